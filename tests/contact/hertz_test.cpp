// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/hertz.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "tests/check.hpp"

namespace {

using namespace ehd;
using std::numbers::pi;
using verification::Tolerance;

constexpr double quadrature_tolerance = 1e-12;  // asked of GSL, absolute on values of size 1

/// Int_-1^1 sqrt(1 - t^2) ln|x - t| dt by GSL, with the singular point as a breakpoint. Knows nothing of contact/.
double log_moment_of_hertz_pressure(double x) {
  const std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)> workspace(
      gsl_integration_workspace_alloc(2000), gsl_integration_workspace_free);
  gsl_function integrand;
  integrand.function = [](double t, void* at) {
    const double distance = std::abs(*static_cast<double*>(at) - t);
    return distance == 0 ? 0.0 : std::sqrt((1 - t) * (1 + t)) * std::log(distance);
  };
  integrand.params = &x;
  double points[] = {-1, x, 1};
  double value = 0, estimate = 0;
  const int status = std::abs(x) < 1 ? gsl_integration_qagp(&integrand, points, 3, quadrature_tolerance, 0, 2000,
                                                            workspace.get(), &value, &estimate)
                                     : gsl_integration_qags(&integrand, -1, 1, quadrature_tolerance, 0, 2000,
                                                            workspace.get(), &value, &estimate);
  BOOST_REQUIRE_MESSAGE(status == GSL_SUCCESS, gsl_strerror(status));
  return value;
}

double film_without_offset(double x) { return x * x / 2 - log_moment_of_hertz_pressure(x) / pi; }

// Error of the quadrature over pi, and the cancellation at the edge of the gap formula.
const Tolerance by_quadrature = Tolerance::discretisation(quadrature_tolerance, 2);

struct QuietGsl {
  QuietGsl() { gsl_set_error_handler_off(); }
};

}  // namespace

BOOST_FIXTURE_TEST_SUITE(hertz, QuietGsl)

BOOST_AUTO_TEST_CASE(hertz_pressure_leaves_a_flat_gap_inside) {
  int rows = 0;
  for (const double x : {-0.93, -0.4, 0.0, 0.31, 0.77, 0.999}) {
    BOOST_TEST_CONTEXT("X = " << x) {
      EHD_CHECK(std::abs(film_without_offset(x) + ehd::hertz::dry_offset()), by_quadrature);
    }
    ++rows;
  }
  BOOST_TEST(rows == 6);
}

BOOST_AUTO_TEST_CASE(the_gap_outside_equals_the_integral) {
  int rows = 0;
  Array X(7);
  X << -9.5, -4.0, -1.7, -1.001, 1.02, 1.4, 6.3;
  const Array gap = ehd::hertz::gap(X);
  for (Eigen::Index i = 0; i < X.size(); ++i) {
    BOOST_TEST_CONTEXT("X = " << X[i]) {
      EHD_CHECK(std::abs(film_without_offset(X[i]) + ehd::hertz::dry_offset() - gap[i]), by_quadrature);
      BOOST_TEST(gap[i] > 0);
    }
    ++rows;
  }
  BOOST_TEST(rows == 7);
  Array inside(3);
  inside << -1.0, 0.2, 1.0;
  BOOST_TEST((ehd::hertz::gap(inside) == 0).all());
}

BOOST_AUTO_TEST_CASE(the_dry_offset_has_the_printed_digits) {
  EHD_CHECK(error(ehd::hertz::dry_offset(), -0.5965736), Tolerance::published_digits("0.5965736"));
}

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

BOOST_AUTO_TEST_CASE(scales_in_si_satisfy_their_relations) {
  const Conditions c{.load_N_per_m = 0.9e5, .reduced_radius_m = 1.3e-2, .reduced_modulus_Pa = 2.19e11};
  const double b = ehd::hertz::half_width_m(c), p_H = ehd::hertz::pressure_Pa(c);
  const Tolerance rounding = Tolerance::round_off(16);
  EHD_CHECK(error(pi * b * p_H / 2, c.load_N_per_m), rounding);  // the ellipse carries the load
  EHD_CHECK(error(p_H, c.reduced_modulus_Pa * b / (4 * c.reduced_radius_m)), rounding);
  EHD_CHECK(error(b * b, 8 * c.load_N_per_m * c.reduced_radius_m / (pi * c.reduced_modulus_Pa)), rounding);
}

BOOST_AUTO_TEST_CASE(extreme_inputs_do_not_overflow_on_the_way) {
  const Conditions c{.load_N_per_m = 1e200, .reduced_radius_m = 1e200, .reduced_modulus_Pa = 1e200};
  EHD_CHECK(error(ehd::hertz::half_width_m(c), std::sqrt(8 / pi) * 1e100), Tolerance::round_off(16));
}

BOOST_AUTO_TEST_SUITE_END()
