// SPDX-License-Identifier: GPL-3.0-or-later
// Reading a sweep file: its values, and the mistakes that are refused before anything is computed.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "io/case_reader.hpp"
#include "io/sweep_file.hpp"
#include "io/sweep_shards.hpp"
#include "tests/check.hpp"
#include "tests/io/sweeps.hpp"
#include "tests/process.hpp"

using namespace ehd;
using namespace ehd::verification;
using namespace ehd::verification::test;

namespace {

struct BadSweep {
  std::string text;
  int line;
  std::vector<std::string> says;
};

void check_refusal(const Folder& folder, const BadSweep& bad) {
  const auto file = folder.write("bad.toml", bad.text);
  std::string message;
  try {
    (void)read_sweep(file);
  } catch (const CaseError& error) {
    message = error.what();
  }
  BOOST_TEST_CONTEXT("the sweep\n" << bad.text << "is refused with: " << message) {
    BOOST_TEST(message.starts_with(fmt::format("{}:{}: ", file.string(), bad.line)));
    BOOST_TEST(message.find('\n') == std::string::npos);
    BOOST_TEST((message.find("allowed is") != std::string::npos || message.find("allowed with") != std::string::npos ||
                message.find("required is") != std::string::npos));
    for (const std::string& text : bad.says) BOOST_TEST(message.find(text) != std::string::npos, text);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(sweep_reader)

BOOST_AUTO_TEST_CASE(a_product_takes_every_combination_and_the_last_key_turns_fastest) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", small_sweep));
  BOOST_TEST(read.id == "s");
  BOOST_TEST(read.case_id == "na4908");
  BOOST_TEST(read.rows() == 6u);
  const std::vector<std::pair<double, double>> expected{{20e3, 2500}, {20e3, 5000}, {20e3, 7500},
                                                        {50e3, 2500}, {50e3, 5000}, {50e3, 7500}};
  for (std::size_t row = 0; row < expected.size(); ++row) {
    const auto body = std::get<BearingCase>(read.case_of(row).body);
    BOOST_TEST(body.operation.radial_load_N == expected[row].first);
    BOOST_TEST(body.operation.inner_speed_rpm == expected[row].second);
    BOOST_TEST(body.geometry.rollers == 22);
  }
}

BOOST_AUTO_TEST_CASE(zip_takes_the_values_side_by_side) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", head(R"(combine = "zip"
[keys]
"bearing.rollers" = { from = 20, to = 24, points = 3, spacing = "linear" }
"lubricant.density" = ["dowson-higginson", "incompressible", "dowson-higginson-1977"]
"bearing.roughness_m" = [5e-8, 1e-7, 2e-7]
)")));
  BOOST_TEST(read.rows() == 3u);
  const auto body = std::get<BearingCase>(read.case_of(1).body);
  BOOST_TEST(body.geometry.rollers == 22);
  BOOST_TEST((body.lubricant->lubricant.density == DensityLaw::incompressible));
  BOOST_TEST(body.roughness_m.value() == 1e-7);  // a key that the case itself does not have
}

BOOST_AUTO_TEST_CASE(a_range_ends_where_it_says_and_is_spaced_as_it_says) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write(
      "s.toml", keys(R"("operation.radial_load_N" = { from = 1e3, to = 5e4, points = 20, spacing = "logarithmic" }
"bearing.clearance_m" = { from = -1e-5, to = 3e-5, points = 5, spacing = "linear" }
)")));
  const auto& loads = read.keys[0].values;
  BOOST_TEST(std::get<double>(loads.front()) == 1e3);
  BOOST_TEST(std::get<double>(loads.back()) == 5e4);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const double expected = 1e3 * std::exp(std::log(50.0) * static_cast<double>(i) / 19);
    EHD_CHECK(std::abs(std::get<double>(loads[i]) / expected - 1), Tolerance::round_off(10, 4));  // exp and log of 4
  }
  BOOST_TEST(std::get<double>(read.keys[1].values[1]) == 0.0);
  BOOST_TEST(read.rows() == 100u);
}

BOOST_AUTO_TEST_CASE(what_is_wrong_with_a_sweep_is_one_line_before_anything_is_computed) {
  const std::string load = "\"operation.radial_load_N\" = ";
  const std::vector<BadSweep> all{
      {"combine = \"product\"\n", 1, {"case", "is missing"}},
      {"case = \"nobody\"\ncombine = \"product\"\n", 1, {"case = \"nobody\"", "no such case"}},
      {"case = 3\n", 1, {"case = 3", "is an integer"}},
      {"title = \"a case\"\nid = \"mine\"\n", 2, {"id = \"mine\"", "belongs to a case", "allowed is a sweep"}},
      {head("[keys]\n" + load + "[1.0]\n"), 1, {"combine", "is missing", "\"zip\""}},
      {head("combine = \"both\"\n[keys]\n" + load + "[1.0]\n"), 2, {"combine = \"both\"", "is unknown"}},
      {head("combine = \"product\"\n"), 1, {"[keys]", "is missing"}},
      {head("combine = \"product\"\n[keys]\n"), 3, {"[keys]", "is empty"}},
      {head("combine = \"product\"\nspeed = 3\n"), 3, {"speed = 3", "is unknown", "allowed is case, laws"}},
      {head("combine = \"product\"\ncombine = \"zip\"\n"), 3, {"duplicate"}},
      {keys(fmt::format("{}[1.0]\n{}[2.0]\n", load, load)),
       5,
       {load + "[2.0]: is a duplicate (cannot redefine existing array)"}},
      {head("laws = [\"hertz\", \"tomato\"]\n"), 2, {"laws = \"tomato\"", "is unknown", "ehd-linear"}},
      {head("laws = [\"hertz\", \"ehdlinear\"]\n"), 2, {"laws = \"ehdlinear\"", "did you mean ehd-linear?"}},
      {head("laws = []\n"), 2, {"laws = []", "is empty"}},
      {head("laws = [\"hertz\", \"hertz\"]\n"), 2, {"duplicate"}},
      {head("solver = \"slow\"\n"), 2, {"solver = \"slow\"", "is unknown", "reference"}},
      {head("tolerance = 1e-3\n"), 2, {"tolerance = 1e-3", "belongs to the sweep of a contact"}},
      {"case = \"own-moes-20-10\"\nlaws = [\"hertz\"]\n", 2, {"laws", "belongs to the sweep of a bearing"}},
      {"case = \"own-moes-20-10\"\ntolerance = 0\n", 2, {"tolerance = 0", "is out of range"}},
      {keys(load + "[]\n"), 4, {"operation.radial_load_N = []", "is empty"}},
      {keys(load + "1e3\n"), 4, {"is a number", "allowed is a list"}},
      {keys(load + "[true]\n"), 4, {"is a boolean"}},
      {keys(load + "{ from = 1.0, to = 2.0, points = 0, spacing = \"linear\" }\n"), 4, {"points = 0", "out of range"}},
      {keys(load + "{ from = 1.0, to = 2.0, points = 1, spacing = \"linear\" }\n"), 4, {"points = 1", "2 or more"}},
      {keys(load + "{ from = 1.0, to = 2.0, points = 3 }\n"), 4, {"spacing is missing"}},
      {keys(load + "{ from = 1.0, points = 3, spacing = \"linear\" }\n"), 4, {"to is missing"}},
      {keys(load + "{ from = 1.0, to = 2.0, step = 3, spacing = \"linear\" }\n"), 4, {"step = 3", "is unknown"}},
      {keys(load + "{ from = nan, to = 2.0, points = 3, spacing = \"linear\" }\n"), 4, {"from = nan", "out of range"}},
      {keys("\"bearing.clearance_m\" = { from = -1e-5, to = 1e-5, points = 3, spacing = \"logarithmic\" }\n"),
       4,
       {"spacing = \"logarithmic\"", "leads through zero"}},
      {keys("\"bearing.clearance_m\" = { from = 0.0, to = 1e-5, points = 3, spacing = \"logarithmic\" }\n"),
       4,
       {"leads through zero"}},
      {keys(load + "{ from = 1.0, to = 2.0, points = 3, spacing = \"square\" }\n"), 4, {"\"square\"", "is unknown"}},
      {keys("operation.radial_load_N = [1.0]\n"),
       4,
       {"operation: is a table; allowed is the whole key in quotation marks, as \"operation.radial_load_N\""}},
      {keys("moes.M = [1.0]\n"), 4, {"moes: is a table", "as \"moes.M\""}},
      {keys("\"operation.radial_load\" = [1.0]\n"),
       4,
       {"operation.radial_load", "is unknown in [operation]", "radial_load_N"}},
      {keys("\"title\" = [\"one\"]\n"), 4, {"title", "cannot be given another value", "table.key"}},
      {keys("\"expect.value\" = [\"1\"]\n"), 4, {"expect.value", "cannot be given another value"}},
      {keys("\"moes.M\" = [1.0]\n"), 4, {"row 0", "[bearing]"}},
      {keys(load + "[1e3, -5.0]\n"),
       4,
       {"row 1", "operation.radial_load_N = -5.0", "is negative", "allowed is 0, or 1e-9"}},
      {keys(load + "[1e3, \"much\"]\n"), 4, {"row 1", "is a text"}},
      {keys("\"bearing.rollers\" = [22, 22.5]\n"), 4, {"row 1", "rollers = 22.5", "is a number", "an integer"}},
      {keys("\"lubricant.viscosity\" = [\"barus\", \"honey\"]\n"), 4, {"row 1", "honey", "roelands"}},
      {keys("\"operation.speed_rpm\" = [5000.0, 0.0]\n"), 4, {"row 1", "at rest", "ehd"}},
      {head("combine = \"zip\"\n[keys]\n" + load + "[1.0, 2.0]\n\"bearing.clearance_m\" = [0.0]\n"),
       5,
       {"has 1 values where operation.radial_load_N has 2"}},
      {keys("\"bearing.clearance_m\" = { from = 0.0, to = 1e-5, points = 1001, spacing = \"linear\" }\n" + load +
            "{ from = 1.0, to = 2.0, points = 1000, spacing = \"linear\" }\n"),
       5,
       {"more than 1000000 rows"}},
  };
  const Folder folder;
  for (const BadSweep& bad : all) check_refusal(folder, bad);
}

BOOST_AUTO_TEST_CASE(the_program_refuses_with_one_line_and_leaves_nothing) {
  const Folder folder;
  const auto bad = folder.write("bad.toml", keys("\"operation.radial_load_N\" = [1e3, -5.0]\n"));
  const auto good = folder.write("good.toml", dry_sweep);
  const auto out = folder.path() / "out";
  for (const std::string& arguments :
       {quoted(bad), quoted(folder.path() / "none.toml"), quoted(good) + " --shard 3/2", quoted(good) + " --shard 0/2",
        quoted(good) + " --shard 2", quoted(good) + " --threads 0", quoted(good) + " --merge --shard 1/2",
        quoted(good) + " --merge --fresh", quoted(good) + " --merge"}) {
    const auto ended = test::ehd_run(folder, fmt::format("sweep {} --output {}", arguments, quoted(out)));
    BOOST_TEST_CONTEXT(arguments << ": " << ended.err) {
      BOOST_TEST(ended.exit_code == 2);
      BOOST_TEST(ended.error_lines() == 1);
      BOOST_TEST(ended.out == "");
      BOOST_TEST(!std::filesystem::exists(out));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_case_is_found_from_the_folder_of_the_sweep) {
  const Folder folder;
  std::filesystem::create_directories(folder.path() / "below");
  (void)folder.write("below/own-moes-20-10.toml",
                     test::read(std::string(EHD_SOURCE_DIR) + "/cases/own-moes-20-10.toml"));
  const auto file =
      folder.write("s.toml", "case = \"below/own-moes-20-10.toml\"\ncombine = \"zip\"\n[keys]\n\"moes.M\" = [5.0]\n");
  BOOST_TEST(read_sweep(file).case_file == folder.path() / "below/own-moes-20-10.toml");
}

BOOST_AUTO_TEST_CASE(what_a_case_expects_of_its_own_numbers_is_not_asked_of_other_ones) {
  const Folder folder;
  // Harris' bearing has fourteen rollers, and the case expects a force of the fourth.
  const Sweep read = read_sweep(
      folder.write("s.toml", "case = \"harris-209\"\ncombine = \"zip\"\n[keys]\n\"bearing.rollers\" = [3, 14]\n"));
  const Case own = read_case(read.case_text, read.case_file);
  const auto asks_of_the_fourth = [](const Expectation& one) { return one.quantity.starts_with("roller.4."); };
  BOOST_TEST(std::count_if(own.expectations.begin(), own.expectations.end(), asks_of_the_fourth) == 1);
  for (std::size_t row = 0; row < 2; ++row) BOOST_TEST(read.case_of(row).expectations.empty());
}

BOOST_AUTO_TEST_CASE(the_examples_can_be_read) {
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(EHD_SOURCE_DIR) + "/examples/sweeps")) {
    if (entry.path().extension() != ".toml") continue;
    ++found;
    BOOST_TEST(read_sweep(entry.path()).rows() > 0u);
  }
  BOOST_TEST(found >= 3u);
}

// A line each, in the order in which the file is read; what depends on a part that could not be read is left out.
BOOST_AUTO_TEST_CASE(all_faults_of_a_sweep_are_named_at_once) {
  const Folder folder;
  const auto file = folder.write("bad.toml", R"(case = "na490"
laws = ["hertzz", "ehd", "isoo"]
solver = "fas"
tolerance = 3
kombine = "zip"
films = "table"
nonsense = 1
[keys]
"operation.radial_load_N" = []
"bearing.rollers" = [20]
"bearing.length_m" = 3
)");
  std::vector<std::string> lines;
  try {
    (void)read_sweep(file);
  } catch (const CaseError& error) {
    lines.emplace_back(error.what());
    lines.insert(lines.end(), error.more().begin(), error.more().end());
  }
  const std::vector<std::string> beginnings{"5: kombine = \"zip\": is unknown; did you mean combine?",
                                            "7: nonsense = 1: is unknown; allowed is",
                                            "1: case = \"na490\": na490: there is no such case; did you mean na4908?",
                                            "2: laws = \"hertzz\": is unknown; did you mean hertz?",
                                            "2: laws = \"isoo\": is unknown; did you mean iso?",
                                            "3: solver = \"fas\": is unknown; did you mean fast?",
                                            "4: tolerance = 3: is out of range",
                                            "9: operation.radial_load_N = []: is empty",
                                            "11: bearing.length_m = 3: is an integer"};
  BOOST_REQUIRE(lines.size() == beginnings.size());
  for (std::size_t i = 0; i < lines.size(); ++i)
    BOOST_TEST(lines[i].starts_with(file.string() + ":" + beginnings[i]), lines[i]);
}

BOOST_AUTO_TEST_SUITE_END()
