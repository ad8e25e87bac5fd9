// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/estimate.hpp"

#include <cmath>
#include <vector>

#include "tests/check.hpp"

namespace {

using namespace ehd;
using verification::Tolerance;

constexpr double truth = 0.0743;

/// truth (1 + c 2^(-order k) + c4 2^(-4k)), k = 0 … grids-1.
std::vector<double> sequence(double c, double order, int grids, double c4 = 0) {
  std::vector<double> values;
  for (int k = 0; k < grids; ++k)
    values.push_back(truth * (1 + c * std::pow(2.0, -order * k) + c4 * std::pow(16.0, -k)));
  return values;
}

/// True relative error over the estimate; 1 or less where the estimate covers it.
double coverage(const std::vector<double>& values, double formal_order) {
  const auto judged = estimate(values, formal_order);
  return std::abs(judged.value - truth) / std::abs(judged.value) / judged.error;
}

const Tolerance covered = Tolerance::required(1, "the estimate covers the true error");

}  // namespace

BOOST_AUTO_TEST_SUITE(estimate)

BOOST_AUTO_TEST_CASE(one_grid_tells_nothing) {
  const auto judged = ehd::estimate({truth}, 2);
  BOOST_TEST(std::isinf(judged.error));
  BOOST_TEST(std::isinf(judged.extrapolated_error));
  BOOST_TEST(!judged.observed_order.has_value());
}

BOOST_AUTO_TEST_CASE(clean_second_order_is_recognised_and_extrapolated) {
  const auto judged = ehd::estimate(sequence(0.02, 2, 5), 2);
  EHD_CHECK(error(judged.observed_order.value(), 2), Tolerance::round_off(16, 1 / (3 * 0.02 / 256)));
  EHD_CHECK(error(judged.extrapolated, truth), Tolerance::round_off(64));
  EHD_CHECK(coverage(sequence(0.02, 2, 5), 2), covered);
  // 2 |d|/(4 - 1) is twice the true error.
  EHD_CHECK(error(judged.error, 2 * 0.02 / 256), Tolerance::asymptotic(1e-4, "relative to the value, not the truth"));
}

BOOST_AUTO_TEST_CASE(the_error_covers_the_truth_whatever_order_the_grids_show) {
  int rows = 0;
  for (const double order : {0.5, 0.75, 1.0, 1.5, 2.0, 2.6, 3.0}) {
    for (const double c : {0.3, -0.04}) {
      for (const int grids : {3, 4, 6}) {
        BOOST_TEST_CONTEXT("order " << order << ", c " << c << ", grids " << grids) {
          EHD_CHECK(coverage(sequence(c, order, grids), 2), covered);
        }
        ++rows;
      }
    }
  }
  BOOST_TEST(rows == 42);
}

BOOST_AUTO_TEST_CASE(a_slower_convergence_never_gets_a_smaller_error) {
  // Differences 1 and r, to r = 2: beyond it half the larger difference before decides, which grows with r.
  double before = INFINITY;
  int rows = 0;
  for (const double r : {1.05, 1.2, 1.3, 1.45, 1.55, 1.8, 2.0}) {
    const double d = 1e-3;
    const double judged = ehd::estimate({truth - d - r * d, truth - d, truth}, 2).error;
    BOOST_TEST(judged <= before);
    before = judged;
    ++rows;
  }
  BOOST_TEST(rows == 7);
}

BOOST_AUTO_TEST_CASE(first_order_is_not_extrapolated_as_if_it_were_second) {
  const auto values = sequence(0.02, 1, 5);
  const auto judged = ehd::estimate(values, 2);
  EHD_CHECK(error(judged.observed_order.value(), 1), Tolerance::round_off(16, 16 / 0.02));
  BOOST_TEST(judged.extrapolated == values.back());
  BOOST_TEST(judged.extrapolated_error == judged.error);
}

BOOST_AUTO_TEST_CASE(two_grids_cover_first_order) {
  EHD_CHECK(coverage(sequence(0.1, 1, 2), 2), Tolerance::required(1 + 1e-12, "equality at first order, rounded"));
  EHD_CHECK(coverage(sequence(-0.1, 2, 2), 2), covered);
}

BOOST_AUTO_TEST_CASE(oscillating_grids_are_not_extrapolated) {
  const std::vector<double> values = {truth * 1.01, truth * 0.996, truth * 1.002};
  const auto judged = ehd::estimate(values, 2);
  BOOST_TEST(!judged.observed_order.has_value());
  BOOST_TEST(judged.extrapolated == values.back());
  EHD_CHECK(coverage(values, 2), covered);
  // The larger of the last difference and half the one before it: 0.007.
  EHD_CHECK(error(judged.error, 0.007 / 1.002), Tolerance::round_off(16, 1000));
}

BOOST_AUTO_TEST_CASE(a_coincidence_of_the_last_two_grids_is_not_taken_for_accuracy) {
  int rows = 0;
  for (const double last : {0.0, 1e-9, -1e-9}) {
    const std::vector<double> values = {truth * 1.02, truth * 1.004, truth * (1.004 + last)};
    const auto judged = ehd::estimate(values, 2);
    EHD_CHECK(coverage(values, 2), covered);
    EHD_CHECK(error(judged.error, 0.008 / 1.004), Tolerance::asymptotic(1e-6, "half the difference before"));
    BOOST_TEST((!judged.observed_order || std::isfinite(*judged.observed_order)));
    ++rows;
  }
  BOOST_TEST(rows == 3);
}

BOOST_AUTO_TEST_CASE(the_error_of_the_extrapolated_value_covers_the_truth) {
  int rows = 0;
  for (const double c4 : {0.0, 0.02, -0.02, 0.2}) {
    for (const int grids : {3, 4, 5}) {
      BOOST_TEST_CONTEXT("c4 " << c4 << ", grids " << grids) {
        const auto judged = ehd::estimate(sequence(0.05, 2, grids, c4), 2);
        EHD_CHECK(std::abs(judged.extrapolated - truth) / truth,
                  Tolerance::discretisation(judged.extrapolated_error + 1e-15, 1));
      }
      ++rows;
    }
  }
  BOOST_TEST(rows == 12);
}

BOOST_AUTO_TEST_CASE(one_vanishing_move_of_the_extrapolated_value_is_not_taken_for_accuracy) {
  // Differences 5, 4/3·…: the last ratio is exactly 4 by chance, the one before is not.
  const std::vector<double> values = {1.0, 1.0 + 0.020, 1.0 + 0.020 + 0.004, 1.0 + 0.020 + 0.004 + 0.001};
  const auto judged = ehd::estimate(values, 2);
  const double move_before = std::abs(0.004 + (0.004 - 0.020) / 3);
  EHD_CHECK(error(judged.extrapolated_error, move_before / 4 / values.back()), Tolerance::round_off(16, 1e4));
}

BOOST_AUTO_TEST_CASE(a_diverged_value_never_gets_a_finite_error) {
  BOOST_TEST(!(ehd::estimate({1.0, 1.1, std::nan("")}, 2).error <= 1e300));
  BOOST_TEST(!(ehd::estimate({1.0, std::nan(""), 1.1}, 2).error <= 1e300));
}

BOOST_AUTO_TEST_SUITE_END()
