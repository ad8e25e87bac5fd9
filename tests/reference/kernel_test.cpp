// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 1: the log kernel on piecewise-linear functions against GSL's quadrature.
#include "reference/kernel.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <cmath>
#include <functional>

#include "tests/check.hpp"

using namespace ehd;
using namespace ehd::reference;
using verification::Tolerance;

namespace {

double call(double x, void* f) { return (*static_cast<std::function<double(double)>*>(f))(x); }

/// Int_a^b f(t) dt for a smooth f.
double smooth_integral(std::function<double(double)> f, double a, double b) {
  gsl_function wrapped{.function = call, .params = &f};
  gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(1000);
  double value = 0, error = 0;
  gsl_error_handler_t* handler = gsl_set_error_handler_off();  // stopping at round-off is as good as it gets
  const int status = gsl_integration_qag(&wrapped, a, b, 0, 1e-13, 1000, GSL_INTEG_GAUSS61, workspace, &value, &error);
  gsl_set_error_handler(handler);
  BOOST_REQUIRE(status == GSL_SUCCESS || status == GSL_EROUND);
  gsl_integration_workspace_free(workspace);
  return value;
}

/// Int_a^b f(t) ln|t - end| dt where `end` is a or b, f smooth.
double integral_with_log(std::function<double(double)> f, double a, double b, double end) {
  if (b <= a) return 0;
  gsl_function wrapped{.function = call, .params = &f};
  gsl_integration_qaws_table* table = gsl_integration_qaws_table_alloc(0, 0, end == a ? 1 : 0, end == b ? 1 : 0);
  gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(1000);
  double value = 0, error = 0;
  gsl_integration_qaws(&wrapped, a, b, table, 1e-15, 1e-13, 1000, workspace, &value, &error);
  gsl_integration_workspace_free(workspace);
  gsl_integration_qaws_table_free(table);
  return value;
}

/// Int_a^b f(t) ln|v - t| dt for any v, split at v where it lies inside.
double log_integral(const std::function<double(double)>& f, double a, double b, double v) {
  if (v > a && v < b) return integral_with_log(f, a, v, v) + integral_with_log(f, v, b, v);
  if (v == a || v == b) return integral_with_log(f, a, b, v);
  return smooth_integral([&](double t) { return f(t) * std::log(std::abs(v - t)); }, a, b);
}

// QAWS and QAG have a tolerance of 1e-13; the moments are of size 1.
const Tolerance quadrature = Tolerance::round_off(500);

}  // namespace

BOOST_AUTO_TEST_SUITE(kernel)

BOOST_AUTO_TEST_CASE(moments_are_the_integrals_in_the_element_at_its_ends_and_outside) {
  for (const double v : {0.0, 0.3, -0.77, 1.0, -1.0, 1.01, -1.5, 2.0, 3.0, 4.99, -4.99, 5.0, 5.01, -7.0, 40.0}) {
    const LogMoments moments = log_moments(v);
    BOOST_TEST_CONTEXT("v = " << v) {
      EHD_CHECK(
          std::abs(moments.zeroth - log_integral([](double) { return 1; }, -1, 1, v)) / (1 + std::abs(moments.zeroth)),
          quadrature);
      EHD_CHECK(std::abs(moments.first - log_integral([](double t) { return t; }, -1, 1, v)), quadrature);
    }
  }
}

BOOST_AUTO_TEST_CASE(moments_do_not_cancel_a_million_elements_away) {
  // What is small is compared as such: Int ln(1 - t/v) dt and Int t ln(1 - t/v) dt, relative to themselves.
  for (const double v : {6.0, -30.0, 1e2, -1e3, 1e4, 1e6}) {
    const LogMoments moments = log_moments(v);
    BOOST_TEST_CONTEXT("v = " << v) {
      const double first = smooth_integral([&](double t) { return t * std::log1p(-t / v); }, -1, 1);
      EHD_CHECK(error(moments.first, first), quadrature);
      const double small = smooth_integral([&](double t) { return std::log1p(-t / v) + t / v; }, -1, 1);
      EHD_CHECK(std::abs(moments.zeroth - 2 * std::log(std::abs(v)) - small) / std::log(std::abs(v)),
                Tolerance::round_off(4));
    }
  }
}

BOOST_AUTO_TEST_CASE(kernel_rows_are_the_integrals_of_hat_functions_on_a_graded_grid) {
  Array nodes(7);
  nodes << 1, 0.6, 0.15, 0.03, 3e-3, 1e-6, 0;  // cells from 0.45 down to 1e-6: a millionth beside large ones
  const Eigen::MatrixXd K = log_kernel(nodes);
  const Array hats = hat_integrals(nodes);
  BOOST_REQUIRE_EQUAL(K.rows(), 7);
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 7; ++j) {
      double integral = 0;
      if (j > 0)
        integral += log_integral([&](double s) { return (nodes[j - 1] - s) / (nodes[j - 1] - nodes[j]); }, nodes[j],
                                 nodes[j - 1], nodes[i]);
      if (j < 6)
        integral += log_integral([&](double s) { return (s - nodes[j + 1]) / (nodes[j] - nodes[j + 1]); }, nodes[j + 1],
                                 nodes[j], nodes[i]);
      BOOST_TEST_CONTEXT("i = " << i << ", j = " << j) {
        // ln|s_i - s| is of size 1 to 14 and may vanish: relative to the hat's own integral.
        EHD_CHECK(std::abs(K(i, j) - integral) / hats[j], Tolerance::round_off(500, 14));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(kernel_rows_sum_to_the_integral_of_the_logarithm) {
  // Hats sum to 1: Sum_j K_ij = Int_0^1 ln|s_i - s| ds = s ln s + (1 - s) ln(1 - s) - 1, whatever the grid.
  Array nodes(6);
  nodes << 1, 0.7, 0.65, 0.2, 1e-4, 0;
  const Eigen::VectorXd sums = log_kernel(nodes).rowwise().sum();
  const auto x_log_x = [](double x) { return x > 0 ? x * std::log(x) : 0; };
  for (int i = 0; i < 6; ++i)
    EHD_CHECK(error(sums[i], x_log_x(nodes[i]) + x_log_x(1 - nodes[i]) - 1), Tolerance::round_off(100));
  EHD_CHECK(error(hat_integrals(nodes).sum(), 1), Tolerance::round_off(10));
}

BOOST_AUTO_TEST_SUITE_END()
