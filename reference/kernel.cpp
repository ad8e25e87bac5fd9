// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/kernel.hpp"

#include <cmath>

namespace ehd::reference {

namespace {

/// From this distance on, in half lengths, the series replaces the closed forms, which cancel there.
constexpr double series_from = 5;
/// Terms of the series; they reach 5^-24 = 2e-17.
constexpr int series_terms = 12;

double x_log_x(double x) { return x == 0 ? 0 : x * std::log(std::abs(x)); }

}  // namespace

LogMoments log_moments(double v) {
  if (std::abs(v) < series_from) {
    const double edge = std::abs(v) == 1 ? 0 : (v * v - 1) / 2 * std::log(std::abs((v + 1) / (v - 1)));
    return {x_log_x(v + 1) - x_log_x(v - 1) - 2, edge - v};
  }
  // ln|v - t| = ln|v| - Sum (t/v)^k/k, term by term.
  const double w = 1 / (v * v);
  double zeroth = 0, first = 0;
  for (int k = series_terms; k >= 1; --k) {
    zeroth = w * (zeroth + 1.0 / (k * (2 * k + 1)));
    first = first * w + 2.0 / ((2 * k - 1) * (2 * k + 1));
  }
  return {2 * std::log(std::abs(v)) - zeroth, -first / v};
}

Eigen::MatrixXd log_kernel(const Array& nodes) {
  const Eigen::Index last = nodes.size() - 1;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(last + 1, last + 1);
  for (Eigen::Index k = 0; k < last; ++k) {  // element between nodes k and k+1
    const double half = (nodes[k] - nodes[k + 1]) / 2, log_half = std::log(half);
    for (Eigen::Index i = 0; i <= last; ++i) {
      // v runs from -1 at node k+1 to 1 at node k; differences first, so that it is +-1 exactly there.
      const auto [m0, m1] = log_moments(((nodes[i] - nodes[k]) + (nodes[i] - nodes[k + 1])) / (2 * half));
      const double whole = half * (m0 / 2 + log_half);
      K(i, k) += whole + half * m1 / 2;
      K(i, k + 1) += whole - half * m1 / 2;
    }
  }
  return K;
}

Array hat_integrals(const Array& nodes) {
  const Eigen::Index last = nodes.size() - 1;
  Array S = Array::Zero(last + 1);
  const Array half = (nodes.head(last) - nodes.tail(last)) / 2;
  S.head(last) += half;
  S.tail(last) += half;
  return S;
}

}  // namespace ehd::reference
