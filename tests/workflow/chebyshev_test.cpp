// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/chebyshev.hpp"

#include <algorithm>
#include <cmath>

#include "tests/check.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

/// A polynomial of degree 5 in x and 3 in y, with its derivatives.
ValueWithSlopes polynomial(double x, double y) {
  return {.value = 0.3 - x + 2 * std::pow(x, 5) * y + x * x * std::pow(y, 3),
          .by_x = -1 + 10 * std::pow(x, 4) * y + 2 * x * std::pow(y, 3),
          .by_y = 2 * std::pow(x, 5) + 3 * x * x * y * y};
}

std::vector<double> interpolated(const std::vector<double>& x, const std::vector<double>& y) {
  MatrixOf<double> values(static_cast<Eigen::Index>(x.size()), static_cast<Eigen::Index>(y.size()));
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < y.size(); ++j)
      values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = polynomial(x[i], y[j]).value;
  const MatrixOf<double> c = chebyshev_coefficients(values, x, y);
  std::vector<double> rows;
  for (Eigen::Index i = 0; i < c.rows(); ++i)
    for (Eigen::Index j = 0; j < c.cols(); ++j) rows.push_back(c(i, j));
  return rows;
}

/// Values of up to 4 and slopes of up to 13 by solves with matrices of condition below 30, and sums of 80 terms.
Tolerance rounding_here() { return Tolerance::round_off(80, 30); }

}  // namespace

BOOST_AUTO_TEST_SUITE(chebyshev)

BOOST_AUTO_TEST_CASE(a_polynomial_is_reproduced_with_its_derivatives) {
  const auto x = leja_points(8), y = leja_points(5);
  const std::vector<double> c = interpolated(x, y);
  for (const double at_x : {-1.0, -0.73, 0.11, 0.9, 1.0})
    for (const double at_y : {-1.0, -0.2, 0.47, 1.0}) {
      const ValueWithSlopes sum = chebyshev_sum(c, ChebyshevBasis(7, at_x), ChebyshevBasis(4, at_y));
      const ValueWithSlopes truth = polynomial(at_x, at_y);
      EHD_CHECK(std::abs(sum.value - truth.value), rounding_here());
      EHD_CHECK(std::abs(sum.by_x - truth.by_x), rounding_here());
      EHD_CHECK(std::abs(sum.by_y - truth.by_y), rounding_here());
    }
}

BOOST_AUTO_TEST_CASE(a_degree_too_low_does_not_reproduce_it) {
  const std::vector<double> c = interpolated(leja_points(5), leja_points(4));
  const ValueWithSlopes sum = chebyshev_sum(c, ChebyshevBasis(4, 0.9), ChebyshevBasis(3, 0.8));
  BOOST_TEST(std::abs(sum.value - polynomial(0.9, 0.8).value) > 1e-3);
}

BOOST_AUTO_TEST_CASE(leja_points_are_distinct_points_of_the_interval_that_interpolate_well) {
  constexpr std::size_t count = 41;
  auto points = leja_points(count);
  BOOST_TEST(points.size() == count);
  // Runge's function, on which equally spaced points diverge.
  MatrixOf<double> values(static_cast<Eigen::Index>(count), 1);
  for (std::size_t i = 0; i < count; ++i)
    values(static_cast<Eigen::Index>(i), 0) = 1 / (1 + 25 * points[i] * points[i]);
  const MatrixOf<double> c = chebyshev_coefficients(values, points, {0.0});
  double worst = 0;
  for (double x = -1; x <= 1; x += 1e-2) {
    const ValueWithSlopes sum =
        chebyshev_sum({c.data(), c.data() + c.size()}, ChebyshevBasis(40, x), ChebyshevBasis(0, 0));
    worst = std::max(worst, std::abs(sum.value - 1 / (1 + 25 * x * x)));
  }
  const double decay = std::pow(0.2 + std::sqrt(1.04), -40);  // of its Chebyshev series, singular at x = +-i/5
  EHD_CHECK(worst, Tolerance::asymptotic(count * decay, "decay of the series times the Lebesgue constant"));
  std::sort(points.begin(), points.end());
  BOOST_TEST(points.front() == -1.0);
  BOOST_TEST(points.back() == 1.0);
  BOOST_CHECK(std::adjacent_find(points.begin(), points.end()) == points.end());
}

BOOST_AUTO_TEST_SUITE_END()
