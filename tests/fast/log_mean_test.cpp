// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/log_mean.hpp"

#include <cmath>

#include "tests/check.hpp"

using namespace ehd;
using verification::Tolerance;

BOOST_AUTO_TEST_SUITE(log_mean)

BOOST_AUTO_TEST_CASE(mean_and_slopes_are_exact_to_rounding_on_both_sides_of_the_series) {
  // With a = 0.7: m = e^-a (1 - e^-d)/d, m_a = (m - e^-a)/d, m_b = (e^-b - m)/d, all in long double.
  const double below = fast::log_mean_series_below;
  int rows = 0;
  for (const double size : {0.0, 1e-12, 1e-6, 1e-3, 0.01, 0.999 * below, 1.001 * below, 0.1, 1.0, 30.0}) {
    for (const double sign : {1.0, -1.0}) {
      const double d = sign * size, a = 0.7;
      BOOST_TEST_CONTEXT("d = " << d) {
        const double u = std::exp(-a), v = u * std::exp(-d);
        const long double e = -std::expm1(-static_cast<long double>(d)), wide = d;
        // The slopes cancel twice: below 1e-3 their limit, -m/2 -+ m d/12, is exact to d^3/720.
        const bool small = size < 1e-2;
        const long double m = d == 0 ? 1 : e / wide;
        const long double m_a = small ? m * (-0.5L - wide / 12 + wide * wide * wide / 720) : (m - 1) / wide;
        const long double m_b = small ? m * (-0.5L + wide / 12 - wide * wide * wide / 720) : (1 - e - m) / wide;
        const fast::LogMean now = fast::log_mean_with_slopes(u, v, d);
        BOOST_CHECK_EQUAL(now.value, fast::log_mean(u, v, d));
        // Beyond the series u - v loses 2/d roundings of the smaller of both, the slopes that much again.
        const double lost = size < below ? 1 : 2 / std::min(size, 1.0);
        EHD_CHECK(error(now.value, u * static_cast<double>(m)), Tolerance::round_off(8, lost));
        EHD_CHECK(error(now.by_a, u * static_cast<double>(m_a)), Tolerance::round_off(8, lost * lost));
        EHD_CHECK(error(now.by_b, u * static_cast<double>(m_b)), Tolerance::round_off(8, lost * lost));
        ++rows;
      }
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 20);
}

BOOST_AUTO_TEST_SUITE_END()
