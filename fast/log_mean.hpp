// SPDX-License-Identifier: GPL-3.0-or-later
// The logarithmic mean of the fluidity 1/eta between two nodes.
#pragma once

#include <cmath>

namespace ehd::fast {

/// Below this difference of the logarithms the quotient cancels, and a series replaces it.
constexpr double log_mean_series_below = 0.03;

/// (u - v)/d with u = e^-a, v = e^-b, d = b - a. For small d the series about the geometric mean; its next term is
/// d^6/322560.
inline double log_mean(double u, double v, double d) {
  const double quotient = (u - v) / d;
  const double series = std::sqrt(u * v) * (1 + d * d * (1.0 / 24 + d * d / 1920));
  return std::abs(d) < log_mean_series_below ? series : quotient;
}

/// The logarithmic mean and its derivatives by a and b.
struct LogMean {
  double value, by_a, by_b;
};

inline LogMean log_mean_with_slopes(double u, double v, double d) {
  const double quotient = (u - v) / d, inverse = 1 / d;
  const double mid = std::sqrt(u * v), even = d * d;
  const double m = 1 + even * (1.0 / 24 + even / 1920), odd = d * (1.0 / 12 + even / 480);
  const bool near = std::abs(d) < log_mean_series_below;
  return {near ? mid * m : quotient, near ? mid * (-0.5 * m - odd) : (quotient - u) * inverse,
          near ? mid * (-0.5 * m + odd) : (v - quotient) * inverse};
}

}  // namespace ehd::fast
