// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/monotone_spline.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace ehd::bearing {

namespace {

/// Slopes of the cubic spline with not-a-knot ends (a parabola through three points), limited where the neighbouring
/// secants agree in sign.
std::vector<double> slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<Eigen::Index>(x.size());
  Eigen::VectorXd h(n - 1), secant(n - 1), right(n);
  for (Eigen::Index k = 0; k + 1 < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    h[k] = x[i + 1] - x[i];
    secant[k] = (y[i + 1] - y[i]) / h[k];
  }
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index k = 1; k + 1 < n; ++k) {
    rows(k, k - 1) = h[k];
    rows(k, k) = 2 * (h[k - 1] + h[k]);
    rows(k, k + 1) = h[k - 1];
    right[k] = 3 * (h[k] * secant[k - 1] + h[k - 1] * secant[k]);
  }
  const auto end = [&](Eigen::Index row, Eigen::Index inwards, double h0, double h1, double s0, double s1) {
    if (n == 3) {  // one parabola: d_0 + d_1 = 2 s_0
      rows(row, row) = rows(row, row + inwards) = 1;
      right[row] = 2 * s0;
      return;
    }
    rows(row, row) = h1;
    rows(row, row + inwards) = h0 + h1;
    right[row] = ((h0 + 2 * (h0 + h1)) * h1 * s0 + h0 * h0 * s1) / (h0 + h1);
  };
  end(0, 1, h[0], h[1], secant[0], secant[1]);
  end(n - 1, -1, h[n - 2], h[n - 3], secant[n - 2], secant[n - 3]);
  const Eigen::VectorXd solved = rows.partialPivLu().solve(right);
  std::vector<double> result(x.size());
  for (Eigen::Index k = 0; k < n; ++k) {
    const double before = secant[std::max<Eigen::Index>(k - 1, 0)], after = secant[std::min(k, n - 2)];
    const double largest = 3 * std::min(std::abs(before), std::abs(after));
    double d = solved[k];
    if (before * after > 0)  // monotone here; an extremum of the points keeps its slope
      d = before > 0 ? std::clamp(d, 0.0, largest) : std::clamp(d, -largest, 0.0);
    result[static_cast<std::size_t>(k)] = d;
  }
  return result;
}

}  // namespace

MonotoneSpline::MonotoneSpline(std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)), y_(std::move(y)), slope_(slopes(x_, y_)) {}

ValueAndSlope MonotoneSpline::at(double x) const {
  const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const auto k = static_cast<std::size_t>(above - x_.begin()) - 1;
  const double h = x_[k + 1] - x_[k], t = (x - x_[k]) / h, secant = (y_[k + 1] - y_[k]) / h;
  const double c2 = 3 * secant - 2 * slope_[k] - slope_[k + 1], c3 = slope_[k] + slope_[k + 1] - 2 * secant;
  return {y_[k] + h * t * (slope_[k] + t * (c2 + t * c3)), slope_[k] + t * (2 * c2 + t * 3 * c3)};
}

}  // namespace ehd::bearing
