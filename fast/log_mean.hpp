// SPDX-License-Identifier: GPL-3.0-or-later
// The logarithmic mean of the fluidity 1/eta between two nodes.
#pragma once

#include <cmath>

namespace ehd::fast {

/// Below this difference of the logarithms the quotient cancels, and a series replaces it.
constexpr double log_mean_series_below = 0.03;

/// (u - v)/d with u = e^-a, v = e^-b, d = b - a; the same as (u + v)/2 tanh(d/2)/(d/2). For small d the series of the
/// latter; its next term is 31 d^8/362880. Without a branch or a call, so that loops over faces vectorise.
inline double log_mean(double u, double v, double d) {
  const double quotient = (u - v) / d, even = d * d;
  const double series = (u + v) / 2 * (1 - even * (1.0 / 12 - even * (1.0 / 120 - even * (17.0 / 20160))));
  return std::abs(d) < log_mean_series_below ? series : quotient;
}

/// The logarithmic mean and its derivatives by a and b.
struct LogMean {
  double value, by_a, by_b;
};

/// The derivatives are value (-1/2 -+ r) with r = coth(d/2)/2 - 1/d; for small d its series, whose next term is
/// d^7/1209600.
inline LogMean log_mean_with_slopes(double u, double v, double d) {
  const double value = log_mean(u, v, d), inverse = 1 / d, even = d * d;
  const double r = d * (1.0 / 12 - even * (1.0 / 720 - even / 30240));
  const bool near = std::abs(d) < log_mean_series_below;
  return {value, near ? value * (-0.5 - r) : (value - u) * inverse, near ? value * (r - 0.5) : (v - value) * inverse};
}

}  // namespace ehd::fast
