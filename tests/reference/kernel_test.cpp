// SPDX-License-Identifier: GPL-3.0-or-later
// The log kernel on piecewise-linear functions against GSL's quadrature. Moments near the element are judged by the
// claim kernel/reference-moments.
#include "reference/kernel.hpp"

#include <cmath>

#include "tests/check.hpp"
#include "tests/quadrature.hpp"

using namespace ehd;
using namespace ehd::reference;
using namespace ehd::testing;
using verification::Tolerance;

namespace {

// QAWS and QAG have a tolerance of 1e-13; the moments are of size 1.
const Tolerance to_quadrature = Tolerance::round_off(500);

}  // namespace

BOOST_AUTO_TEST_SUITE(kernel)

BOOST_AUTO_TEST_CASE(moments_do_not_cancel_a_million_elements_away) {
  // What is small is compared as such: Int ln(1 - t/v) dt and Int t ln(1 - t/v) dt, relative to themselves.
  for (const double v : {6.0, -30.0, 1e2, -1e3, 1e4, 1e6}) {
    const LogMoments moments = log_moments(v);
    BOOST_TEST_CONTEXT("v = " << v) {
      const double first = smooth_integral([&](double t) { return t * std::log1p(-t / v); }, -1, 1);
      EHD_CHECK(error(moments.first, first), to_quadrature);
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
