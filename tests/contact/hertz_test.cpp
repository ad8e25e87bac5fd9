// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/hertz.hpp"

#include <cmath>
#include <numbers>

#include "tests/check.hpp"

namespace {

using namespace ehd;
using std::numbers::pi;
using verification::Tolerance;

}  // namespace

BOOST_AUTO_TEST_SUITE(hertz)

// The gap, the dry offset and the scales in SI are judged by the claims elasticity/hertz-gap, dry-steel and
// inputs/scales/* (verification/claims).

BOOST_AUTO_TEST_CASE(hertz_pressure_is_a_semi_ellipse_with_load_half_pi) {
  Array X(5);
  X << -1.2, -0.6, 0.0, 0.8, 1.0;
  const Array P = ehd::hertz::pressure(X);
  const double expected[] = {0, 0.8, 1, 0.6, 0};
  for (Eigen::Index i = 0; i < 5; ++i) EHD_CHECK(std::abs(P[i] - expected[i]), Tolerance::round_off(4));
  // X = cos(t) makes the integrand smooth and periodic, for which the midpoint rule is exact here.
  const int n = 64;
  double load = 0;
  for (int k = 0; k < n; ++k) {
    const double t = (k + 0.5) * pi / n;
    load += ehd::hertz::pressure(Array::Constant(1, std::cos(t)))[0] * std::sin(t) * pi / n;
  }
  EHD_CHECK(error(load, pi / 2), Tolerance::round_off(n));
}

BOOST_AUTO_TEST_CASE(extreme_inputs_do_not_overflow_on_the_way) {
  const Conditions c{.load_N_per_m = 1e200, .reduced_radius_m = 1e200, .reduced_modulus_Pa = 1e200};
  EHD_CHECK(error(ehd::hertz::half_width_m(c), std::sqrt(8 / pi) * 1e100), Tolerance::round_off(16));
}

BOOST_AUTO_TEST_SUITE_END()
