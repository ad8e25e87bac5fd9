// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of a sweep: the numbers of single runs, which depend on nothing but themselves.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "io/sweep_file.hpp"
#include "io/sweep_run.hpp"
#include "tests/check.hpp"
#include "tests/io/sweeps.hpp"
#include "tests/process.hpp"

using namespace ehd;
using namespace ehd::verification;
using namespace ehd::verification::test;

BOOST_AUTO_TEST_SUITE(sweep_rows)

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

// Later columns stand behind all others: lateral displacement, datum, use outside the fit, lambda ratio, errors.
BOOST_AUTO_TEST_CASE(a_line_tells_the_datum_use_outside_the_fit_and_errors) {
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
      "displacement_lateral_m,datum_inner_x0_m,datum_outer_x0_m,fit_used_outside,lambda_ratio_minimum,"
      "displacement_error_m,displacement_lateral_error_m,largest_force_error_N,film_minimum_error";
  BOOST_TEST(csv.at(0).ends_with(",contacts,reason," + added));
  const auto cells_of = [](const std::string& line) {
    std::vector<std::string> cells{""};
    for (const char c : line)
      if (c == ',')
        cells.emplace_back();
      else
        cells.back() += c;
    return std::vector<std::string>(cells.end() - 9, cells.end());
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
        for (std::size_t k = 1; k < 9; ++k) BOOST_TEST(cells[k].empty());
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
      const Json& errors = result["errors"];
      BOOST_TEST(cells[5] == errors["displacement_m"].dump());
      BOOST_TEST(cells[6] == errors["displacement_lateral_m"].dump());
      BOOST_TEST(cells[7] == errors["largest_force_N"].dump());
      BOOST_TEST(cells[8] == errors["smallest_film_relative"].dump());
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
  // Without a balance nothing is counted as outside the fit. The datum is known all the same.
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

BOOST_AUTO_TEST_SUITE_END()
