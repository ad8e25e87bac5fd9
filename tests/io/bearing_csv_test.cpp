// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bearing_csv.hpp"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "tests/check.hpp"
#include "tests/made_bearing.hpp"

using namespace ehd;

namespace {

/// Two rollers, moving at the frequencies.
BearingResult two_rollers(bearing::Law law, const std::vector<double>& frequencies_Hz) {
  BearingResult result;
  result.law = law;
  for (const double azimuth_deg : {0.0, 180.0}) result.rollers.emplace_back().azimuth_deg = azimuth_deg;
  for (const double frequency_Hz : frequencies_Hz) {
    DynamicRow row{.frequency_Hz = frequency_Hz};
    for (const double stiffness : {1e9, 2e9})
      row.rollers.push_back({.inner = {.stiffness_N_per_m = stiffness, .damping_N_s_per_m = frequency_Hz + 7},
                             .outer = {.stiffness_N_per_m = 3 * stiffness}});
    row.ring.stiffness_N_per_m = {{{5, 6}, {6, 7}}};
    if (frequency_Hz > 0) row.ring.damping_N_s_per_m = {{{8, 9}, {9, 10}}};
    result.dynamics.push_back(std::move(row));
  }
  return result;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bearing_csv)

BOOST_AUTO_TEST_CASE(a_bearing_in_motion_has_a_row_a_roller_and_frequency_with_stiffness_and_damping) {
  const Case one = verification::made::needle_bearing(0);
  const auto csv =
      ehd::bearing_csv({one}, {{two_rollers(bearing::Law::hertz, {}), two_rollers(bearing::Law::ehd, {0, 100})}});
  BOOST_REQUIRE(csv.has_value());
  std::istringstream lines(*csv);
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  BOOST_REQUIRE(rows.size() == 1u + 2 + 4);
  BOOST_TEST(
      rows[0].ends_with(",file,frequency_Hz,inner_stiffness_N_per_m,inner_damping_N_s_per_m,"
                        "outer_stiffness_N_per_m,outer_damping_N_s_per_m,ring_stiffness_xx_N_per_m,"
                        "ring_stiffness_yy_N_per_m,ring_stiffness_xy_N_per_m,ring_damping_xx_N_s_per_m,"
                        "ring_damping_yy_N_s_per_m,ring_damping_xy_N_s_per_m"));
  BOOST_TEST(rows[1].ends_with(",needle.toml,,,,,,,,,,,"));
  BOOST_TEST(rows[3].ends_with(",1,,,needle.toml,0,1000000000,7,3000000000,,5,7,6,,,"), rows[3]);
  BOOST_TEST(rows[4].ends_with(",1,,,needle.toml,100,1000000000,107,3000000000,,5,7,6,8,10,9"), rows[4]);
  BOOST_TEST(rows[6].ends_with(",2,,,needle.toml,100,2000000000,107,6000000000,,5,7,6,8,10,9"), rows[6]);
  const auto cells = [](const std::string& row) { return std::count(row.begin(), row.end(), ','); };
  for (const std::string& row : rows) BOOST_TEST(cells(row) == cells(rows[0]));
}

BOOST_AUTO_TEST_CASE(a_line_far_from_ehd_has_no_stiffness_in_motion_as_in_the_json) {
  BearingResult full = two_rollers(bearing::Law::ehd, {100}), line = two_rollers(bearing::Law::ehd_linear, {100});
  line.fit.emplace();
  for (auto& row : line.dynamics[0].ring.stiffness_N_per_m)
    for (double& number : row) number *= 0.3;
  const auto csv = ehd::bearing_csv({verification::made::needle_bearing(0)}, {{full, line}});
  BOOST_REQUIRE(csv.has_value());
  BOOST_TEST(csv->find(",100,1000000000,107,3000000000,,5,7,6,8,10,9\n") != std::string::npos, *csv);
  BOOST_TEST(csv->find(",100,,107,,,,,,8,10,9\n") != std::string::npos, *csv);
}

BOOST_AUTO_TEST_CASE(without_motion_there_is_no_column_of_it_and_without_a_balance_no_file) {
  const Case one = verification::made::needle_bearing(0);
  const auto csv = ehd::bearing_csv({one}, {{two_rollers(bearing::Law::hertz, {})}});
  BOOST_REQUIRE(csv.has_value());
  BOOST_TEST(csv->find("frequency_Hz") == std::string::npos);
  BOOST_TEST(!ehd::bearing_csv({one}, {{BearingResult{}}}).has_value());
}

BOOST_AUTO_TEST_SUITE_END()
