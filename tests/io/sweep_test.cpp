// SPDX-License-Identifier: GPL-3.0-or-later
// Sweeps: what the file says, and that rows depend on nothing but themselves.
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "io/case_reader.hpp"
#include "io/json.hpp"
#include "io/output_file.hpp"
#include "io/store.hpp"
#include "io/sweep_file.hpp"
#include "io/sweep_run.hpp"
#include "io/sweep_shards.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/process.hpp"
#include "workflow/film_table_oil.hpp"
#include "workflow/registry.hpp"

using namespace ehd;
using namespace ehd::verification;
using test::Folder;

namespace {

/// Six bearings, two of them at each speed; three laws.
const char* small_sweep = R"(case = "na4908"
laws = ["hertz", "ehd-linear", "ehd"]
combine = "product"
[keys]
"operation.radial_load_N" = [20e3, 50e3]
"operation.speed_rpm" = [2500.0, 5000.0, 7500]
)";

const char* dry_sweep = R"(case = "na4908"
laws = ["hertz", "iso"]
combine = "product"
[keys]
"operation.radial_load_N" = { from = 1e3, to = 5e4, points = 5, spacing = "logarithmic" }
"bearing.clearance_m" = [0.0, 2.5e-6, 1e-5]
)";

std::string head(const std::string& rest) { return "case = \"na4908\"\n" + rest; }
std::string keys(const std::string& rest) { return head("combine = \"product\"\n[keys]\n" + rest); }

struct Files {
  std::string csv, json;
  explicit Files(const std::filesystem::path& folder)
      : csv(test::read(folder / "rows.csv")), json(test::read(folder / "rows.json")) {}
  bool operator==(const Files&) const = default;
};

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

std::vector<std::string> lines_of_text(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// Removes times, as the sweep does; written here again.
Json without_times(Json json) {
  for (const char* key : {"wall_s", "planning_s", "total_s", "stage_s"})
    if (json.is_object()) json.erase(key);
  if (json.is_structured())
    for (auto& inner : json) inner = without_times(inner);
  return json;
}

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

BOOST_AUTO_TEST_SUITE(sweep)

// ---- the file -------------------------------------------------------------------------------------------------------

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
      {keys("operation.radial_load_N = [1.0]\n"), 4, {"operation", "quotation marks"}},
      {keys("\"operation.radial_load\" = [1.0]\n"), 4, {"operation.radial_load", "is no key", "radial_load_N"}},
      {keys("\"title\" = [\"one\"]\n"), 4, {"title", "is no key", "table.key"}},
      {keys("\"expect.value\" = [\"1\"]\n"), 4, {"expect.value", "is no key"}},
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

// ---- rows -----------------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(a_row_of_a_bearing_says_what_ehd_bearing_says_of_that_case) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", small_sweep));
  const SweepCost cost = run_sweep(read, {}, folder.path() / "out");
  BOOST_TEST(cost.computed == 6u);
  BOOST_TEST(cost.failures.rows == 0u);
  BOOST_TEST(cost.saved() > 0);
  const Json rows = Json::parse(test::read(folder.path() / "out/rows.json"));
  BOOST_TEST(rows["schema"] == "ehd-sweep-1");
  BOOST_TEST(!rows["provenance"].contains("date"));
  BOOST_TEST(rows["rows"].size() == 6u);

  // Row 5 as a case file of its own.
  std::string text = test::read(std::string(EHD_SOURCE_DIR) + "/cases/na4908.toml");
  const auto replace = [&text](const std::string& from, const std::string& to) {
    BOOST_REQUIRE(text.find(from) != std::string::npos);
    text.replace(text.find(from), from.size(), to);
  };
  replace("speed_rpm = 5000.0", "speed_rpm = 7500");
  std::filesystem::create_directories(folder.path() / "own");
  const auto own = folder.write("own/na4908.toml", text);
  const auto ended = test::ehd_run(folder, "bearing " + quoted(own) + " --json -");
  Json results = without_times(Json::parse(ended.out));
  for (Json& result : results) result.erase("error_budget");  // further balances, which a row leaves out
  Json swept = rows["rows"][5]["results"];
  BOOST_TEST(results.size() == 3u);
  // One process solves for all laws, so what came from memory is the same there.
  BOOST_TEST(swept.dump() == results.dump());
  BOOST_TEST((rows["rows"][5]["keys"] == Json{{"operation.radial_load_N", 50e3}, {"operation.speed_rpm", 7500}}));

  const auto csv = lines_of_text(test::read(folder.path() / "out/rows.csv"));
  BOOST_TEST(csv.size() == 1 + 6 * 3u);
  BOOST_TEST(csv[0].starts_with("row,operation.radial_load_N,operation.speed_rpm,law,status,displacement_m,"));
  const Json& last = results[2];
  double largest = 0, film = 1;
  for (const Json& roller : last["rollers"]) {
    largest = std::max(largest, roller["inner"]["force_N"].get<double>());
    for (const char* raceway : {"inner", "outer"})
      film = std::min(film, roller[raceway]["film_minimum_m"].get<double>());
  }
  BOOST_TEST(
      csv.back().starts_with(fmt::format("5,50000.0,7500,ehd,converged,{},{},0.0,{},", last["displacement_m"].dump(),
                                         Json(largest).dump(), Json(film).dump())));
}

// Later columns stand behind all others: the datum, use outside the fit, lambda ratio, lateral displacement.
BOOST_AUTO_TEST_CASE(a_line_tells_the_datum_and_use_outside_the_fit) {
  const Folder folder;
  std::string text = test::read(std::string(EHD_SOURCE_DIR) + "/cases/na4908.toml");
  const auto behind = [&text](const std::string& line, const std::string& added) {
    BOOST_REQUIRE(text.find(line) != std::string::npos);
    text.insert(text.find(line) + line.size(), added);
  };
  behind("density_kg_per_m3 = 7850.0", "\nroughness_m = 1e-7\nfirst_azimuth_deg = 5.0");
  (void)folder.write("na4908.toml", text);
  const Sweep read = read_sweep(folder.write("s.toml", R"(case = "na4908.toml"
laws = ["hertz", "ehd-linear", "ehd"]
combine = "product"
[keys]
"operation.radial_load_N" = [5e3, 7e4]
)"));
  BOOST_TEST(run_sweep(read, {}, folder.path() / "out").failures.rows == 0u);
  const auto csv = lines_of_text(test::read(folder.path() / "out/rows.csv"));
  const std::string added =
      "displacement_lateral_m,datum_inner_x0_m,datum_outer_x0_m,fit_used_outside,lambda_ratio_minimum";
  BOOST_TEST(csv.at(0).ends_with(",contacts,reason," + added));
  const auto cells_of = [](const std::string& line) {
    std::vector<std::string> cells{""};
    for (const char c : line)
      if (c == ',')
        cells.emplace_back();
      else
        cells.back() += c;
    return std::vector<std::string>(cells.end() - 5, cells.end());
  };
  const Json rows = Json::parse(test::read(folder.path() / "out/rows.json"));
  BOOST_REQUIRE(csv.size() == 1 + 2 * 3u);
  std::vector<std::string> datum;
  for (std::size_t row = 0; row < 2; ++row)
    for (std::size_t law = 0; law < 3; ++law) {
      const Json& result = rows["rows"][row]["results"][law];
      const auto cells = cells_of(csv[1 + 3 * row + law]);
      BOOST_TEST(cells[0] == result["displacement_lateral_m"].dump());
      BOOST_TEST(std::stod(cells[0]) != 0);
      if (law == 0) {
        for (std::size_t k = 1; k < 5; ++k) BOOST_TEST(cells[k].empty());
        continue;
      }
      BOOST_TEST(cells[1] == result["datum"]["inner_x0_m"].dump());
      BOOST_TEST(cells[2] == result["datum"]["outer_x0_m"].dump());
      BOOST_TEST(cells[1] != cells[2]);
      datum.push_back(cells[1]);
      int outside = 0;  // the case states 2 to 12 kN
      double ratio = 1e9;
      for (const Json& roller : result["rollers"])
        for (const char* raceway : {"inner", "outer"}) {
          const double force = roller[raceway]["force_N"].get<double>();
          outside += force > 0 && (force < 2000 || force > 12000);
          if (roller[raceway].contains("film_minimum_m"))
            ratio = std::min(ratio, roller[raceway]["film_minimum_m"].get<double>() / 1e-7);
        }
      BOOST_TEST(cells[3] == (law == 1 ? std::to_string(outside) : ""));
      if (law == 1) BOOST_TEST(outside > 0);
      EHD_CHECK(error(std::stod(cells[4]), ratio), Tolerance::round_off(2));
    }
  BOOST_TEST(datum[0] == datum[1]);  // of a row's laws
  BOOST_TEST(datum[0] != datum[2]);  // the default follows the row's own load
  // A load that is named fixes it.
  const Sweep fixed = read_sweep(folder.write("f.toml", R"(case = "na4908.toml"
laws = ["ehd-linear"]
combine = "product"
[keys]
"operation.radial_load_N" = [5e3, 7e4]
"datum.load_N" = [9289.0]
)"));
  BOOST_TEST(run_sweep(fixed, {}, folder.path() / "fixed").failures.rows == 0u);
  const auto lines = lines_of_text(test::read(folder.path() / "fixed/rows.csv"));
  BOOST_TEST(cells_of(lines.at(1))[1] == cells_of(lines.at(2))[1]);
  BOOST_TEST(!cells_of(lines.at(1))[1].empty());
}

BOOST_AUTO_TEST_CASE(neither_threads_nor_other_rows_change_a_bit) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", small_sweep));
  for (const unsigned threads : {1u, 2u, 5u})
    (void)run_sweep(read, {.threads = threads}, folder.path() / std::to_string(threads));
  const Files one(folder.path() / "1");
  BOOST_TEST(one.json.size() > 10000u);
  BOOST_TEST((one == Files(folder.path() / "2")));
  BOOST_TEST((one == Files(folder.path() / "5")));
  // The last row alone, which shares its contacts with nobody.
  const Sweep alone = read_sweep(folder.write("alone.toml", head(R"(laws = ["hertz", "ehd-linear", "ehd"]
combine = "zip"
[keys]
"operation.radial_load_N" = [50e3]
"operation.speed_rpm" = [7500]
)")));
  const SweepCost cost = run_sweep(alone, {}, folder.path() / "alone");
  BOOST_TEST(cost.saved() == 0);
  const Json all = Json::parse(one.json), single = Json::parse(test::read(folder.path() / "alone/rows.json"));
  BOOST_TEST(all["rows"][5]["results"].dump() == single["rows"][0]["results"].dump());
  BOOST_TEST(all["rows"][5]["hash"] == single["rows"][0]["hash"]);
}

BOOST_AUTO_TEST_CASE(contacts_that_rows_share_are_solved_once) {
  const Folder folder;
  // One speed: the curves are the same wherever their heaviest load is, and the fit is stated.
  const Sweep read = read_sweep(folder.write("s.toml", head(R"(laws = ["ehd"]
combine = "zip"
[keys]
"bearing.clearance_m" = [0.0, 1e-6, 2e-6, 3e-6]
)")));
  const SweepCost cost = run_sweep(read, {.threads = 2}, folder.path() / "out");
  BOOST_TEST(cost.needed == 4 * cost.solves);
}

BOOST_AUTO_TEST_CASE(a_contact_is_swept_as_ehd_solve_solves_it) {
  const Folder folder;
  const auto file = folder.write("s.toml", R"(case = "own-moes-20-10"
solver = "fast"
tolerance = 1e-2
combine = "zip"
[keys]
"moes.M" = [5.0, 20.0]
"domain.inlet" = ["flooded", -4.0]
)");
  const auto out = folder.path() / "out";
  const auto ended = test::ehd_run(folder, fmt::format("sweep {} --output {}", quoted(file), quoted(out)));
  BOOST_TEST(ended.exit_code == 0);
  BOOST_TEST(ended.err == "");
  const Json rows = Json::parse(test::read(out / "rows.json"));
  const auto solved = test::ehd_run(folder, "solve own-moes-20-10 --tolerance 1e-2 --json -");
  BOOST_TEST(rows["rows"][1]["results"][0].dump() == without_times(Json::parse(solved.out)).dump());
  const auto csv = lines_of_text(test::read(out / "rows.csv"));
  BOOST_REQUIRE(csv.size() == 3u);
  BOOST_TEST(csv[1].starts_with("0,5.0,flooded,fast,converged,5.0,10.0,"));
}

namespace {

/// Contacts of one oil whose films come from a table.
std::string table_sweep(const std::string& rest = "") {
  return "case = \"own-moes-20-10-flooded\"\nfilms = \"table\"\ntolerance = 1e-3\ncombine = \"product\"\n" + rest +
         "[table]\nM = [15, 40]\nL = [7, 10.0]\n[keys]\n\"moes.M\" = [15, 21.0, 33.3, 40]\n\"moes.L\" = [7.5, 10]\n";
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_row_with_films_from_a_table_says_so_and_agrees_with_a_solve) {
  const Folder folder;
  const Sweep tabled = read_sweep(folder.write("s.toml", table_sweep()));
  const SweepCost cost = run_sweep(tabled, {}, folder.path() / "out");
  BOOST_TEST(cost.failures.rows == 0u);
  BOOST_TEST(cost.saved() >= 0);
  const auto json = nlohmann::json::parse(Files(folder.path() / "out").json);
  BOOST_TEST(json["sweep"]["films"] == "table");
  BOOST_TEST((json["sweep"]["table"]["M"] == std::vector<double>{15, 40}));
  BOOST_REQUIRE(json["rows"].size() == 8u);
  for (const auto& row : json["rows"]) {
    const auto& result = row["results"][0];
    BOOST_TEST(result["solver"] == "table");
    BOOST_TEST(result["notes"].back().get<std::string>().find("a table over M 15 to 40, L 7 to 10") !=
               std::string::npos);
    BOOST_TEST(!result.contains("pressure"));
    const Problem problem =
        problem_of(tabled.table->oil, {row["keys"]["moes.M"].get<double>(), row["keys"]["moes.L"].get<double>()});
    const Solution solved = default_solver().solve(problem, {.tolerance = 1e-5});
    for (const Quantity film : table_films) {
      const auto& entry = result["film"][std::string(to_string(film)).substr(5)];
      const double truth = solved.observables.at(film).value, stated = entry["error"].get<double>();
      const double unit = has_absolute_error(film) ? 1 : truth;
      EHD_CHECK(stated, Tolerance::required(1e-3, "the tolerance of the sweep"));
      EHD_CHECK(std::abs(entry["hertz"].get<double>() - truth) / unit,
                Tolerance::required(stated, "the row states it"));
    }
  }
  const auto lines = lines_of_text(Files(folder.path() / "out").csv);
  for (std::size_t i = 1; i < lines.size(); ++i) BOOST_TEST(lines[i].find(",table,converged,") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(rows_from_a_table_do_not_depend_on_threads_or_shards) {
  const Folder folder;
  const Sweep tabled = read_sweep(folder.write("s.toml", table_sweep()));
  (void)run_sweep(tabled, {.threads = 1}, folder.path() / "one");
  (void)run_sweep(tabled, {.threads = 3}, folder.path() / "three");
  for (const std::size_t number : {1u, 2u}) (void)run_shard(tabled, {}, folder.path() / "parts", {number, 2});
  (void)merge_shards(tabled, {}, folder.path() / "parts");
  BOOST_CHECK(Files(folder.path() / "one") == Files(folder.path() / "three"));
  BOOST_CHECK(Files(folder.path() / "one") == Files(folder.path() / "parts"));
}

BOOST_AUTO_TEST_CASE(the_range_of_a_table_is_in_the_hash_of_a_row) {
  const Folder folder;
  Sweep tabled = read_sweep(folder.write("s.toml", table_sweep()));
  const std::string hash = row_hash(tabled, {}, 0);
  tabled.table->range.M_high = 41;
  BOOST_TEST(row_hash(tabled, {}, 0) != hash);
  tabled.table.reset();
  BOOST_TEST(row_hash(tabled, {}, 0) != hash);
}

BOOST_AUTO_TEST_CASE(what_a_table_cannot_give_is_refused_before_anything_is_computed) {
  const Folder folder;
  const auto refused = [&](const std::string& text, const std::string& phrase) {
    const auto says = [&](const CaseError& error) {
      const std::string what = error.what();
      const bool right = what.find(phrase) != std::string::npos && what.find('\n') == std::string::npos;
      BOOST_CHECK_MESSAGE(right, phrase << " is not in: " << what);
      return true;
    };
    BOOST_CHECK_EXCEPTION((void)read_sweep(folder.write("s.toml", text)), CaseError, says);
  };
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = table_sweep();
    return text.replace(text.find(from), from.size(), to);
  };
  refused(changed("[15, 21.0", "[14, 21.0"), "M = 14, L = 7.5 is outside the table; allowed is M 15 to 40, L 7 to 10");
  refused(changed("\"moes.L\" = [7.5, 10]", "\"moes.L\" = [7.5, 10.5]"), "L = 10.5 is outside the table");
  refused(table_sweep() + "\"lubricant.z\" = [0.68, 0.6]\n", "or the inlet differs from the table's");
  refused(table_sweep() + "\"domain.inlet\" = [-4.0]\n", "or the inlet differs from the table's");
  refused(changed("films = \"table\"", "films = \"solve\""), "belongs to films = \"table\"");
  refused(changed("films = \"table\"", "films = \"sheet\""), "films = \"sheet\"");
  refused(changed("M = [15, 40]\n", ""),
          "[table]: M is missing; required is [LOW, HIGH] with 0.001 <= LOW < HIGH <= 1e6");
  refused(changed("M = [15, 40]", "M = [40, 15]"), "is no range; allowed is [LOW, HIGH]");
  refused(changed("M = [15, 40]", "M = 15"), "allowed is [LOW, HIGH]");
  refused(changed("[table]\nM = [15, 40]\nL = [7, 10.0]\n", ""), "[table]");
  refused(changed("L = [7, 10.0]", "L = [7, 10.0]\nN = 3"), "N");
  refused(table_sweep("solver = \"reference\"\n"), "is made by fast");
  refused(head("films = \"table\"\ncombine = \"zip\"\n[keys]\n\"bearing.clearance_m\" = [0.0]\n"),
          "belongs to the sweep of a contact");
}

BOOST_AUTO_TEST_CASE(a_dry_law_is_swept_through_rest) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", head(R"(laws = ["hertz"]
combine = "product"
[keys]
"operation.speed_rpm" = [0.0, 5000.0]
)")));
  const SweepCost cost = run_sweep(read, {}, folder.path() / "out");
  BOOST_TEST(cost.failures.rows == 0u);
  BOOST_TEST(cost.solves == 0);
  const auto csv = lines_of_text(test::read(folder.path() / "out/rows.csv"));
  BOOST_TEST(csv.size() == 3u);
}

BOOST_AUTO_TEST_CASE(a_row_that_does_not_converge_is_a_row_with_its_reason) {
  const Folder folder;
  const auto file = folder.write("s.toml", small_sweep);
  const auto out = folder.path() / "out";
  const auto ended =
      test::ehd_run(folder, fmt::format("sweep {} --max-iterations 1 --output {}", quoted(file), quoted(out)));
  BOOST_TEST(ended.exit_code == 1);
  BOOST_TEST(ended.error_lines() == 1);
  BOOST_TEST(ended.err.find("6 of 6 rows did not converge; row 0: ehd-linear: limit-reached: ") != std::string::npos);
  const auto csv = lines_of_text(test::read(out / "rows.csv"));
  BOOST_REQUIRE(csv.size() == 1 + 6 * 3u);
  BOOST_TEST(csv[1].find(",hertz,converged,") != std::string::npos);
  BOOST_TEST(csv[2].find(",ehd-linear,limit-reached,,,,") != std::string::npos);
  BOOST_TEST(csv[2].find("M = ") != std::string::npos);
  // No balance, no count of what lies outside the fit; the datum is known.
  BOOST_TEST(std::count(csv[2].begin(), csv[2].end(), ',') >= std::count(csv[0].begin(), csv[0].end(), ','));
  BOOST_TEST(csv[2].ends_with(",,"));
  const Json rows = Json::parse(test::read(out / "rows.json"));
  BOOST_TEST(rows["rows"][0]["results"][2]["status"] == "limit-reached");
  // Known rows fail again, without being computed.
  const auto again =
      test::ehd_run(folder, fmt::format("sweep {} --max-iterations 1 --output {}", quoted(file), quoted(out)));
  BOOST_TEST(again.exit_code == 1);
  BOOST_TEST(again.out.find("rows computed 0") != std::string::npos);
}

/// The cheapest sweep of contacts.
const char* contact_sweep = R"(case = "own-moes-20-10"
combine = "product"
tolerance = 1e-2
[keys]
"moes.M" = [10.0, 20.0, 30.0]
)";

BOOST_AUTO_TEST_CASE(a_row_that_lacked_time_is_tried_again_unless_it_is_to_be_kept) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", contact_sweep));
  const auto out = folder.path() / "out";
  constexpr double too_short_s = 1e-9;
  const auto again = [&](bool keep) {
    return run_sweep(read, {.time_limit_s = too_short_s, .keep_limits = keep}, out);
  };
  BOOST_TEST(again(false).failures.rows == 3u);
  BOOST_TEST(again(false).computed == 3u);
  BOOST_TEST(again(true).computed == 0u);
}

BOOST_AUTO_TEST_CASE(rows_after_the_deadline_are_named_and_run_by_the_next_run) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", contact_sweep));
  const auto out = folder.path() / "out";
  constexpr double passed_s = -1;
  const SweepCost cut = run_sweep(read, {.deadline = Deadline(passed_s)}, out);
  BOOST_TEST(cut.computed == 0u);
  BOOST_TEST(cut.not_run == 3u);
  BOOST_TEST(cut.failures.rows == 3u);
  BOOST_TEST(cut.failures.first == "row 0: limit-reached: " + std::string(Deadline::not_run));
  BOOST_TEST(lines_of_text(test::read(out / "rows.csv")).size() == 4u);
  const SweepCost whole = run_sweep(read, {}, out);
  BOOST_TEST(whole.computed == 3u);
  BOOST_TEST(whole.failures.rows == 0u);
  (void)run_sweep(read, {}, folder.path() / "at once");
  BOOST_TEST((Files(out) == Files(folder.path() / "at once")));
}

BOOST_AUTO_TEST_CASE(a_row_without_memory_fails_alone) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", small_sweep));
  const auto cache =
      std::make_shared<ContactCache>([](const Problem&, const Request&) -> Solution { throw std::bad_alloc(); });
  const ComputedRow row = compute_row(read, {}, 0, std::string(32, '0'), cache);
  BOOST_TEST(lacked_time_or_memory(row.text));
  const Json json = Json::parse("{\"row\":0," + row.text.substr(1));
  BOOST_TEST(json["results"].size() == 3u);
  BOOST_TEST(failure_of(json).value_or("") == "row 0: hertz: limit-reached: memory is exhausted");
}

// ---- interrupted ----------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(a_killed_run_goes_on_where_it_was_and_ends_in_the_same_files) {
  const Folder folder;
  const auto file = folder.write("s.toml", dry_sweep);
  const Sweep read = read_sweep(file);
  (void)run_sweep(read, {.threads = 1}, folder.path() / "whole");
  constexpr std::size_t finished = 4;
  const auto out = folder.path() / "killed";
  const pid_t child = ::fork();
  BOOST_REQUIRE(child >= 0);
  if (child == 0) {  // kill -9 in the middle
    SweepRequest request{.threads = 1};
    request.progress = [](std::size_t, std::size_t, std::size_t computed) {
      if (computed == finished) ::kill(::getpid(), SIGKILL);
    };
    (void)run_sweep(read, request, out);
    ::_exit(0);
  }
  int status = 0;
  BOOST_REQUIRE(::waitpid(child, &status, 0) == child);
  BOOST_TEST(WIFSIGNALED(status));
  BOOST_TEST(!std::filesystem::exists(out / "rows.csv"));
  // As if it had been killed in the middle of a line.
  const auto journal = out / "rows/journal";
  const std::string kept = test::read(journal);
  std::ofstream(journal, std::ios::binary | std::ios::app) << kept.substr(kept.size() / 2, 300);
  const SweepCost cost = run_sweep(read, {.threads = 1}, out);
  BOOST_TEST(cost.rows == 15u);
  BOOST_TEST(cost.computed == 15u - finished);
  BOOST_TEST((Files(out) == Files(folder.path() / "whole")));
  BOOST_TEST(run_sweep(read, {.threads = 1}, out).computed == 0u);
  BOOST_TEST(run_sweep(read, {.threads = 1, .fresh = true}, out).computed == 15u);
  BOOST_TEST((Files(out) == Files(folder.path() / "whole")));
}

BOOST_AUTO_TEST_CASE(a_damaged_row_is_computed_again) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", dry_sweep));
  const auto out = folder.path() / "out";
  (void)run_sweep(read, {}, out);
  const Files before(out);
  std::string journal = test::read(out / "rows/journal");
  const std::size_t digit = journal.find("\"force_N\":", journal.size() / 2) + 11;
  journal[digit] = journal[digit] == '7' ? '8' : '7';
  std::ofstream(out / "rows/journal", std::ios::binary | std::ios::trunc) << journal;
  BOOST_TEST(run_sweep(read, {}, out).computed == 1u);
  BOOST_TEST((Files(out) == before));
}

// A journal of a version that hashed with SHA-256: its rows are computed again.
BOOST_AUTO_TEST_CASE(a_journal_of_an_older_version_is_computed_again) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", dry_sweep));
  (void)run_sweep(read, {}, folder.path() / "new");
  const auto out = folder.path() / "old";
  std::filesystem::create_directories(out / "rows");
  std::ofstream(out / "rows/journal", std::ios::binary)
      << R"(b75049c001e4c984 {"schema":"ehd-sweep-journal-1",)"
      << R"("sweep":"241a47365650322f1e678965bf74253946eb7e6c460633bf6d265aa2b5be6b3b","shard":1,"of":1})"
      << "\n03fc809bdfa4a470 02b6a970740a6ac4f6057771f12bccc9c6b4ea391c202a765ae9aa81bbdc96a6 {\"keys\":{}}\n";
  const SweepCost cost = run_sweep(read, {}, out);
  BOOST_TEST(cost.computed == read.rows());
  BOOST_TEST((Files(out) == Files(folder.path() / "new")));
  BOOST_TEST(test::read(out / "rows/journal").find("ehd-sweep-journal-1") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(what_a_row_follows_from_is_in_its_hash) {
  const Folder folder;
  const auto other = [&](const std::string& text) { return read_sweep(folder.write("s.toml", text)); };
  std::set<std::string> hashes;
  const auto add = [&](const Sweep& one, const SweepRequest& request) { hashes.insert(row_hash(one, request, 0)); };
  const std::string key = "[keys]\n\"operation.radial_load_N\" = ";
  add(other(head("laws = [\"hertz\"]\ncombine = \"zip\"\n" + key + "[1e3]\n")), {});
  add(other(head("laws = [\"hertz\"]\ncombine = \"product\"\n" + key + "[1e3, 2e3]\n")), {});  // the same row
  BOOST_TEST(hashes.size() == 1u);
  add(other(head("laws = [\"iso\"]\ncombine = \"zip\"\n" + key + "[1e3]\n")), {});
  add(other(head("laws = [\"hertz\"]\ncombine = \"zip\"\n" + key + "[1001.0]\n")), {});
  add(other(head("laws = [\"hertz\"]\nsolver = \"reference\"\ncombine = \"zip\"\n" + key + "[1e3]\n")), {});
  add(other(head("laws = [\"hertz\"]\ncombine = \"zip\"\n" + key + "[1e3]\n")), {.max_iterations = 7});
  add(other("case = \"na4908-10um\"\nlaws = [\"hertz\"]\ncombine = \"zip\"\n" + key + "[1e3]\n"), {});
  BOOST_TEST(hashes.size() == 6u);
}

BOOST_AUTO_TEST_CASE(a_second_run_in_the_same_folder_is_refused_while_the_first_works) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", dry_sweep));
  const auto out = folder.path() / "out";
  std::string refusal;
  SweepRequest request{.threads = 1};
  request.progress = [&](std::size_t, std::size_t, std::size_t computed) {
    if (computed != 1) return;
    try {
      (void)run_sweep(read, {}, out);
    } catch (const OutputError& error) {
      refusal = error.what();
    }
  };
  (void)run_sweep(read, request, out);
  BOOST_TEST(refusal.find("another run") != std::string::npos);
}

// ---- shards ---------------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(the_first_wrong_row_is_refused_whatever_the_threads_do) {
  const Folder folder;
  const Sweep read =
      read_sweep_statement(folder.write("s.toml", keys("\"bearing.rollers\" = [22, 20, -1, 18, -2, -3]\n")));
  const auto refusal = [&](const std::vector<std::size_t>& rows, unsigned threads) -> std::string {
    try {
      require_cases(read, rows, threads);
    } catch (const CaseError& error) {
      return error.what();
    }
    return "";
  };
  for (const unsigned threads : {1u, 2u, 8u}) {
    BOOST_TEST(refusal({0, 1, 2, 3, 4, 5}, threads).find("row 2 ") != std::string::npos);
    BOOST_TEST(refusal(rows_of(read, {2, 2}), threads).find("row 5 ") != std::string::npos);
    BOOST_TEST(refusal({0, 1, 3}, threads) == "");
  }
}

BOOST_AUTO_TEST_CASE(a_shard_reads_the_cases_of_its_own_rows) {
  const Folder folder;
  const auto file = folder.write("s.toml", keys("\"bearing.rollers\" = [22, -1]\n") + "");
  const auto shard = [&](const char* part) {
    return test::ehd_run(
        folder, fmt::format("sweep {} --output {} --shard {}", quoted(file), quoted(folder.path() / "out"), part));
  };
  BOOST_TEST(shard("1/2").exit_code == 0);
  BOOST_TEST(shard("2/2").exit_code == 2);
  test::check_refused(folder, fmt::format("sweep {} --output {} --merge", quoted(file), quoted(folder.path() / "out")),
                      "2-of-2");
}

BOOST_AUTO_TEST_CASE(shards_take_every_row_once) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", dry_sweep));
  for (const std::size_t of : {1u, 2u, 4u, 15u, 40u}) {
    std::vector<int> taken(read.rows());
    for (std::size_t number = 1; number <= of; ++number)
      for (const std::size_t row : rows_of(read, {number, of})) ++taken[row];
    BOOST_TEST(std::count(taken.begin(), taken.end(), 1) == static_cast<long>(read.rows()));
  }
}

BOOST_AUTO_TEST_CASE(merged_shards_are_the_unsharded_files_bit_for_bit) {
  const Folder folder;
  const auto file = folder.write("s.toml", small_sweep);
  const auto whole = folder.path() / "whole", parts = folder.path() / "parts";
  BOOST_TEST(test::ehd_run(folder, fmt::format("sweep {} --output {}", quoted(file), quoted(whole))).exit_code == 0);
  for (const char* shard : {"3/4", "1/4", "4/4", "2/4"}) {
    const auto ended =
        test::ehd_run(folder, fmt::format("sweep {} --output {} --shard {}", quoted(file), quoted(parts), shard));
    BOOST_TEST(ended.exit_code == 0);
    BOOST_TEST(!std::filesystem::exists(parts / "rows.csv"));
  }
  const auto merged = test::ehd_run(folder, fmt::format("sweep {} --output {} --merge", quoted(file), quoted(parts)));
  BOOST_TEST(merged.exit_code == 0);
  BOOST_TEST(merged.err == "");
  BOOST_TEST((Files(parts) == Files(whole)));
}

BOOST_AUTO_TEST_CASE(shards_that_are_missing_unfinished_damaged_or_foreign_are_named) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", dry_sweep));
  const auto out = folder.path() / "out";
  for (const std::size_t number : {1u, 2u, 3u}) (void)run_shard(read, {}, out, {number, 3});
  const auto refusal = [&](const Sweep& of) -> std::string {
    try {
      (void)merge_shards(of, {}, out);
    } catch (const OutputError& error) {
      BOOST_TEST(!std::filesystem::exists(out / "rows.csv"));
      BOOST_TEST(std::string(error.what()).find('\n') == std::string::npos);
      return error.what();
    }
    return "merged";
  };
  const auto says = [&](const std::string& message, const std::string& text) {
    BOOST_TEST(message.find(text) != std::string::npos, message);
    BOOST_TEST(message.find("2-of-3") != std::string::npos, message);
    BOOST_TEST(message.find("--shard 2/3") != std::string::npos, message);
  };
  const auto second = out / "shards/2-of-3/journal";
  const std::string whole = test::read(second);
  const auto put = [&](const std::string& text) { std::ofstream(second, std::ios::binary | std::ios::trunc) << text; };

  std::filesystem::remove(second);
  says(refusal(read), "missing");
  put(whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1));
  says(refusal(read), "holds 4 of 5 rows");
  put(whole.substr(0, whole.size() - 40));
  says(refusal(read), "damaged at line 6");
  std::string flipped = whole;
  flipped[whole.size() / 2] ^= 1;
  put(flipped);
  says(refusal(read), "damaged at line");
  put(test::read(out / "shards/1-of-3/journal"));
  says(refusal(read), "another part");
  put(whole);
  const Sweep other = read_sweep(folder.write("s.toml", keys("\"operation.radial_load_N\" = [1e3]\n")));
  BOOST_TEST(refusal(other).find("another sweep") != std::string::npos);
  (void)run_shard(read, {}, out, {1, 2});
  BOOST_TEST(refusal(read).find("side by side") != std::string::npos);
  std::filesystem::remove_all(out / "shards/1-of-2");
  BOOST_TEST(refusal(read) == "merged");
  BOOST_TEST(std::filesystem::exists(out / "rows.csv"));
}

// The launchers themselves: tests/engines/.

BOOST_AUTO_TEST_CASE(a_rank_of_a_launcher_is_its_shard) {
  const Folder folder;
  const auto file = folder.write("s.toml", dry_sweep);
  const auto parts = folder.path() / "parts";
  const std::string script = fmt::format("sh '{}/examples/sweeps/rank.sh' {} {} > /dev/null 2>&1", EHD_SOURCE_DIR,
                                         quoted(file), quoted(parts));
  const std::string program = "EHD='" + std::string(EHD_PROGRAM) + "' ";
  // As srun, Open MPI and MPICH tell a process which one it is.
  for (const char* rank :
       {"SLURM_PROCID=0 SLURM_NTASKS=3", "OMPI_COMM_WORLD_RANK=1 OMPI_COMM_WORLD_SIZE=3", "PMI_RANK=2 PMI_SIZE=3"})
    BOOST_TEST(std::system(
                   fmt::format("env -u SLURM_PROCID -u OMPI_COMM_WORLD_RANK -u PMI_RANK {}{} {}", program, rank, script)
                       .c_str()) == 0,
               rank);
  for (const char* name : {"1-of-3", "2-of-3", "3-of-3"})
    BOOST_TEST(std::filesystem::exists(parts / "shards" / name / "journal"), name);
  BOOST_TEST(std::system(("env -u SLURM_PROCID -u OMPI_COMM_WORLD_RANK -u PMI_RANK " + program + script).c_str()) != 0);
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

BOOST_AUTO_TEST_SUITE_END()
