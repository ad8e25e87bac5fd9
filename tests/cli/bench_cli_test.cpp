// SPDX-License-Identifier: GPL-3.0-or-later
// ehd bench as a process.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/process.hpp"

using namespace ehd;
using namespace ehd::verification;
using nlohmann::json;

BOOST_AUTO_TEST_SUITE(bench_cli)

BOOST_AUTO_TEST_CASE(a_quick_bench_prints_its_tables_and_leaves_its_files) {
  const test::Folder folder;
  const auto out = folder.path() / "new" / "bench";
  const auto ended = test::ehd_run(folder,
                                   "bench --quick --case own-moes-5-5 --solver fast --solver fast.uniform "
                                   "--solver reference --output '" +
                                       out.string() + "'");
  BOOST_TEST(ended.exit_code == 0);
  BOOST_TEST(ended.err == "");  // progress is for terminals
  for (const char* text :
       {"one convolution", "speed-up", "The truths", "reference/fast", "fast.uniform/fast", "covered"})
    BOOST_CHECK_MESSAGE(ended.out.find(text) != std::string::npos, text << " is not in the tables");
  const json bench = json::parse(test::read(out / "bench.json"));
  BOOST_TEST(bench["schema"] == "ehd-bench-1");
  BOOST_TEST(bench["provenance"].contains("compiler"));
  BOOST_TEST(bench["looks"]["fast"] != bench["looks"]["reference"]);  // line styles of the report
  for (const char* part : {"work_precision", "scaling", "batch"}) BOOST_TEST(bench.contains(part));
  BOOST_TEST(!bench["work_precision"]["rows"].empty());
  for (const json& row : bench["work_precision"]["rows"]) {
    if (row["status"] == "converged") BOOST_TEST(row["cost"]["wall_s"].get<double>() > 0);
    BOOST_TEST(row["cost"]["total_s"].get<double>() >= row["cost"]["wall_s"].get<double>());
  }
  for (const char* name : {"work_precision.csv", "scaling.csv"})
    BOOST_TEST(test::read(out / name).find('\n') != std::string::npos);
  const auto files = std::distance(std::filesystem::directory_iterator(out), {});
  BOOST_TEST(files == 3);
}

BOOST_AUTO_TEST_CASE(the_yardstick_of_all_times_is_one_line) {
  const test::Folder folder;
  const auto out = folder.path() / "bench";
  const auto ended = test::ehd_run(folder, "bench --part convolution --output '" + out.string() + "'");
  BOOST_TEST(ended.exit_code == 0);
  BOOST_TEST(ended.out.starts_with("c = "));
  BOOST_TEST(std::count(ended.out.begin(), ended.out.end(), '\n') == 1);
  const json measured = json::parse(test::read(out / "bench.json"))["convolution"];
  BOOST_TEST(measured["nodes"] == 512);
  BOOST_TEST(measured["c_s"].get<double>() > 0);
}

BOOST_AUTO_TEST_CASE(a_first_solve_plans_and_a_later_one_does_not) {
  const test::Folder folder;
  const auto out = folder.path() / "bench";
  const auto ended = test::ehd_run(folder, "bench --part first --quick --output '" + out.string() + "'");
  BOOST_TEST(ended.exit_code == 0);
  const json rows = json::parse(test::read(out / "bench.json"))["first"];
  BOOST_REQUIRE_EQUAL(rows.size(), 2u);  // fast and fast.uniform
  for (const json& row : rows) {
    for (const char* time : {"planning_s", "later_s", "c_s"}) BOOST_TEST(row[time].get<double>() > 0);
    BOOST_TEST(row["first_s"].get<double>() > 0);
  }
}

BOOST_AUTO_TEST_CASE(each_answer_has_its_cost_in_seconds_and_in_c) {
  const test::Folder folder;
  const auto out = folder.path() / "bench";
  const auto ended = test::ehd_run(folder, "bench --part cost --quick --output '" + out.string() + "'");
  BOOST_TEST(ended.exit_code == 0);
  const json rows = json::parse(test::read(out / "bench.json"))["cost"];
  std::vector<std::string> asked;
  for (const json& row : rows) {
    asked.push_back(row["asked"]);
    BOOST_TEST(row["not_converged"] == 0);
    BOOST_TEST(row["c_s"].get<double>() > 0);
    BOOST_TEST(row["median_s"].get<double>() > 0);
    BOOST_TEST(row["slowest_s"].get<double>() >= row["of_95_percent_s"].get<double>());
    BOOST_TEST(row["of_95_percent_s"].get<double>() >= row["median_s"].get<double>());
  }
  const std::vector<std::string> expected{
      "H_cen alone to 1e-6", "both films to 1e-3", "both films to 1e-5", "both films to 1e-4", "NA4908",
      "whole process"};
  BOOST_TEST(asked == expected, boost::test_tools::per_element());
  // The goal of the three bearings: a raceway is solved once for all laws and clearances.
  constexpr int most_solves = 40;
  BOOST_TEST(rows[4]["contact_solves"].get<int>() <= most_solves);
  for (const char* text : {"median [ms]", "median [c]", "slowest [c]"})
    BOOST_CHECK_MESSAGE(ended.out.find(text) != std::string::npos, text << " is not in the table");
}

BOOST_AUTO_TEST_CASE(one_part_leaves_its_own_files_only) {
  const test::Folder folder;
  const auto out = folder.path() / "bench";
  const auto ended = test::ehd_run(folder, "bench --quick --part batch --solver fast --output '" + out.string() + "'");
  BOOST_TEST(ended.exit_code == 0);
  BOOST_TEST(std::filesystem::exists(out / "bench.json"));
  BOOST_TEST(!std::filesystem::exists(out / "scaling.csv"));
  BOOST_TEST(!json::parse(test::read(out / "bench.json")).contains("work_precision"));
}

BOOST_AUTO_TEST_CASE(wrong_usage_is_one_line_and_leaves_nothing) {
  const test::Folder folder;
  const std::string out = (folder.path() / "out").string();
  const std::string file = folder.write("file", "text").string();
  for (const auto& [arguments, says] : std::initializer_list<std::pair<std::string, std::string>>{
           {"--part speed", "--part = speed: is unknown; allowed is work-precision, scaling, batch"},
           {"--solver fastest", "--solver = fastest: is unknown"},
           {"--case nowhere", "nowhere"},
           {"--case dry-steel", "is a dry contact"},
           {"--case na4908", "is no contact"},
           {"--part batch --case own-moes-5-5", "belongs to the part work-precision"},
           {"--part scaling --solver reference", "uses no FFT"},
           {"--time-limit 0", "--time-limit = 0: is out of range"},
           {"extra", "ehd bench --help"}}) {
    test::check_refused(folder, fmt::format("bench --quick --output '{}' {}", out, arguments), says);
    BOOST_TEST(!std::filesystem::exists(out), arguments);
  }
  BOOST_TEST(test::ehd_run(folder, "bench --quick --output '" + file + "'").exit_code == 2);
  BOOST_TEST(test::read(file) == "text");
}

BOOST_AUTO_TEST_SUITE_END()
