// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/monotone_spline.hpp"

#include <cmath>
#include <vector>

#include "tests/check.hpp"

namespace ehd::bearing {

using verification::Tolerance;

namespace {

MonotoneSpline through(const std::vector<double>& x, double (*f)(double)) {
  std::vector<double> y;
  for (const double at : x) y.push_back(f(at));
  return {x, y};
}

/// Gaps that differ by factors of up to eight.
std::vector<double> uneven() { return {0.1, 0.15, 0.55, 0.6, 0.9, 1.0, 1.8, 1.9, 2.0, 2.8}; }

}  // namespace

BOOST_AUTO_TEST_SUITE(monotone_spline)

// Exact: a parabola through three points is itself, and so is a cubic through four and more.
BOOST_AUTO_TEST_CASE(polynomials_are_reproduced) {
  const MonotoneSpline parabola = through({0.5, 1.2, 3.0}, [](double x) { return x * x + 3 * x; });
  for (const double x : {0.5, 0.8, 1.2, 2.9, 3.0}) {
    EHD_CHECK(error(parabola.at(x).value, x * x + 3 * x), Tolerance::round_off(20));
    EHD_CHECK(error(parabola.at(x).slope, 2 * x + 3), Tolerance::round_off(50));
  }
  for (const std::vector<double>& points : {std::vector<double>{0.1, 0.4, 0.9, 1.0}, uneven()}) {
    const MonotoneSpline cubic = through(points, [](double x) { return x * x * x + 2 * x; });
    for (double x = points.front(); x <= points.back(); x += 0.01) {
      EHD_CHECK(error(cubic.at(x).value, x * x * x + 2 * x), Tolerance::round_off(50));
      EHD_CHECK(error(cubic.at(x).slope, 3 * x * x + 2), Tolerance::round_off(500));
    }
  }
}

// Invariant: the second derivative does not jump at a point. Slopes are parabolas on a piece, so that one-sided
// differences of them are exact.
BOOST_AUTO_TEST_CASE(the_second_derivative_is_continuous) {
  const std::vector<double> x = uneven();
  const MonotoneSpline spline = through(x, [](double at) { return std::exp(at); });
  const auto second = [&](double at, double h) {
    // Just inside the piece: the point itself belongs to two pieces.
    const double from = at + 1e-9 * h;
    return (-3 * spline.at(from).slope + 4 * spline.at(from + h).slope - spline.at(from + 2 * h).slope) / (2 * h);
  };
  for (std::size_t k = 1; k + 1 < x.size(); ++k)
    EHD_CHECK(error(second(x[k], 0.02), second(x[k], -0.02)), Tolerance::discretisation(1e-8, 1));
}

// Exact: without the limit four points give the one cubic through them, though it falls where the points rise.
BOOST_AUTO_TEST_CASE(without_the_limit_the_spline_is_the_plain_one) {
  const std::vector<double> x{0, 1, 2, 3}, y{0, 0.01, 1, 8};
  const double slope = MonotoneSpline(x, y, MonotoneSpline::Limit::none).at(1).slope;
  EHD_CHECK(error(slope, 0.01 + 0.98 / 2 - 5.03 / 6), Tolerance::round_off(50));  // Newton's differences
  BOOST_TEST(MonotoneSpline(x, y).at(1).slope >= 0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::bearing
