// SPDX-License-Identifier: GPL-3.0-or-later
// Trends of made-up sequences whose limit is known.
#include "verification/studies/grid_study.hpp"

#include <cmath>
#include <functional>
#include <stdexcept>

#include "tests/check.hpp"

namespace {

using namespace ehd;
using namespace ehd::verification;

constexpr double limit = 3.7, round_off = 1e-15;

std::vector<GridValue> sequence(const std::vector<double>& cells, const std::function<double(double n)>& departure) {
  std::vector<GridValue> values;
  for (const double n : cells) values.push_back({n, limit + departure(n)});
  return values;
}

const std::vector<double> doubled{64, 128, 256, 512}, crooked{64, 100, 170, 240, 410};

}  // namespace

BOOST_AUTO_TEST_SUITE(studies_grid_study)

BOOST_AUTO_TEST_CASE(a_pure_power_is_asymptotic_and_extrapolates_to_its_limit) {
  int rows = 0;
  for (const auto& cells : {doubled, crooked}) {
    for (const double order : {1.0, 2.0, 4.0}) {
      const auto values = sequence(cells, [&](double n) { return -5 * std::pow(n, -order); });
      const auto study = study_grids(values, order, round_off);
      BOOST_TEST(to_string(study.trend) == "asymptotic");
      BOOST_REQUIRE(study.observed_order && study.extrapolated);
      // Differences of the fourth order are 1e-9 of values known to 1e-15.
      EHD_CHECK(std::abs(*study.observed_order - order), Tolerance::round_off(10, 1e9));
      EHD_CHECK(std::abs(*study.extrapolated - limit), Tolerance::round_off(10, limit));
      const double truth = 5 * std::pow(cells.back(), -order) / values.back().value;
      EHD_CHECK(error(study.uncertainty, 1.25 * truth), Tolerance::round_off(10, 1e9));
      BOOST_TEST(study.safety == 1.25);
      ++rows;
    }
  }
  BOOST_TEST(rows == 6);
}

BOOST_AUTO_TEST_CASE(a_power_of_another_order_is_monotone_and_not_extrapolated) {
  for (const double order : {0.3, 1.0, 3.0}) {
    const auto study = study_grids(sequence(crooked, [&](double n) { return std::pow(n, -order); }), 2, round_off);
    BOOST_TEST(to_string(study.trend) == "monotone");
    BOOST_TEST(!study.extrapolated);
    BOOST_TEST(study.safety == 3);
    EHD_CHECK(std::abs(*study.observed_order - order), Tolerance::round_off(10, 1e9));
    BOOST_TEST(study.uncertainty > std::pow(410, -order) / (limit + 1));
  }
}

BOOST_AUTO_TEST_CASE(three_grids_never_show_that_they_are_asymptotic) {
  const auto study = study_grids(sequence({64, 128, 256}, [](double n) { return 1 / (n * n); }), 2, round_off);
  BOOST_TEST(to_string(study.trend) == "monotone");
  BOOST_TEST(!study.extrapolated);
}

BOOST_AUTO_TEST_CASE(an_order_that_is_right_once_by_chance_is_not_asymptotic) {
  // Two differences in the ratio 4, the one before in the ratio 10.
  std::vector<GridValue> values{{64, limit + 40 + 4 + 1}, {128, limit + 4 + 1}, {256, limit + 1}, {512, limit}};
  BOOST_TEST(to_string(study_grids(values, 2, round_off).trend) == "monotone");
}

BOOST_AUTO_TEST_CASE(alternating_departures_are_oscillatory_with_half_their_range) {
  double sign = 1;
  const auto values = sequence(doubled, [&](double n) { return (sign = -sign) / (n * n); });
  const auto study = study_grids(values, 2, round_off);
  BOOST_TEST(to_string(study.trend) == "oscillatory");
  BOOST_TEST(!study.observed_order);
  EHD_CHECK(error(study.uncertainty, (std::pow(128, -2) + std::pow(256, -2)) / 2 / values.back().value),
            Tolerance::round_off(10, 1e5));
}

BOOST_AUTO_TEST_CASE(differences_that_grow_are_divergent) {
  const auto growing = study_grids(sequence(doubled, [](double n) { return std::sqrt(n); }), 2, round_off);
  BOOST_TEST(to_string(growing.trend) == "divergent");
  BOOST_TEST(std::isinf(growing.uncertainty));
  double sign = 1;
  BOOST_TEST(
      to_string(study_grids(sequence(doubled, [&](double n) { return (sign = -sign) * n; }), 2, round_off).trend) ==
      "divergent");
  // Differences that fall more slowly than any power: logarithmic, equal ones.
  BOOST_TEST(to_string(study_grids(sequence(doubled, [](double n) { return std::log(n); }), 2, round_off).trend) ==
             "divergent");
}

BOOST_AUTO_TEST_CASE(differences_at_the_noise_are_stalled) {
  const auto study =
      study_grids({{64, limit + 0.1}, {128, limit * (1 + 3e-9)}, {256, limit}, {512, limit * (1 + 1e-9)}}, 2, 1e-8);
  BOOST_TEST(to_string(study.trend) == "stalled");
  EHD_CHECK(error(study.uncertainty, 1e-8), Tolerance::round_off(4));
  BOOST_TEST(!study.extrapolated);
  // The same values with less noise do not stall.
  BOOST_TEST(
      to_string(
          study_grids({{64, limit + 0.1}, {128, limit * (1 + 3e-9)}, {256, limit}, {512, limit * (1 + 1e-9)}}, 2, 1e-12)
              .trend) == "oscillatory");
  BOOST_TEST(to_string(study_grids({{1, limit}, {2, limit}, {3, limit}}, 2, 0).trend) == "stalled");
}

BOOST_AUTO_TEST_CASE(what_is_no_grid_study_is_refused) {
  BOOST_CHECK_THROW((void)study_grids({{64, 1}, {128, 2}}, 2, 0), std::invalid_argument);
  BOOST_CHECK_THROW((void)study_grids({{64, 1}, {64, 2}, {128, 3}}, 2, 0), std::invalid_argument);
  BOOST_CHECK_THROW((void)study_grids({{128, 1}, {64, 2}, {32, 3}}, 2, 0), std::invalid_argument);
  BOOST_CHECK_THROW((void)study_grids({{64, 1}, {128, std::nan("")}, {256, 3}}, 2, 0), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(noise_bounds_what_can_be_said) {
  const double noise = 1e-6;
  // Differences below 2 noise say nothing. The uncertainty is half the range where that is more than the noise.
  const auto stalled = study_grids({{64, 1}, {128, 1 + 1.9e-6}, {256, 1 + 3.8e-6}}, 2, noise);
  BOOST_TEST(to_string(stalled.trend) == "stalled");
  EHD_CHECK(error(stalled.uncertainty, 1.9e-6), Tolerance::calibrated(1e-5, "1 + 3.8e-6 as its size"));
  // Refined so far that the correction is below the noise.
  const auto fine = study_grids({{10, 1 + 3e-4}, {100, 1 + 3e-6}, {10000, 1}}, 1, noise);
  BOOST_TEST(to_string(fine.trend) == "monotone");
  EHD_CHECK(error(fine.uncertainty, noise), Tolerance::round_off(4));
}

BOOST_AUTO_TEST_CASE(orders_are_bounded_before_they_enter_the_uncertainty) {
  // Observed order 3, declared 2: the declared order counts, (f1 - f2)/3. Observed order 0.3 counts as 0.5.
  const auto fast = study_grids({{64, 1 + 64e-4}, {128, 1 + 8e-4}, {256, 1 + 1e-4}}, 2, 0);
  EHD_CHECK(error(fast.uncertainty, 3 * 7e-4 / 3 / (1 + 1e-4)), Tolerance::round_off(10, 1e4));
  const double r = std::pow(2, -0.3);
  const auto slow = study_grids({{64, 1 + 1 / r / r}, {128, 1 + 1 / r}, {256, 2.0}}, 2, 0);
  EHD_CHECK(error(slow.uncertainty, 3 * (1 / r - 1) / (std::sqrt(2.0) - 1) / 2), Tolerance::round_off(10, 100));
  // Within a tenth of the formal order, not within 0.1.
  const auto power = [](double order) { return [order](double n) { return std::pow(n / 64, -order); }; };
  BOOST_TEST(to_string(study_grids(sequence(doubled, power(4.3)), 4, 0).trend) == "asymptotic");
  BOOST_TEST(to_string(study_grids(sequence(doubled, power(1.15)), 1, 0).trend) == "monotone");
}

BOOST_AUTO_TEST_CASE(differences_of_unequal_steps_are_compared_by_the_step) {
  // 0.9 over a factor 2, then -1 over a factor 8: per factor it falls.
  BOOST_TEST(to_string(study_grids({{64, 0}, {128, 0.9}, {1024, -0.1}}, 2, 0).trend) == "oscillatory");
  BOOST_TEST(to_string(study_grids({{64, 0}, {512, 0.9}, {1024, 0.1}}, 2, 0).trend) == "divergent");
}

BOOST_AUTO_TEST_SUITE_END()
