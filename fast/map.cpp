// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/map.hpp"

#include <cmath>

namespace ehd::fast {

Map::Map(const MapShape& shape) : shape_(shape) {
  first_ = raw(shape.inlet);
  range_ = raw(shape.exit) - first_;
}

double Map::raw(double X) const {
  const auto& [inlet, exit, l, d, spike, width] = shape_;
  return std::asinh(X / (0.7 * l)) + std::asinh((X + l) / (d * l)) +
         3 * std::atan((X + l * (1 + d)) / (2 * d * l)) + std::asinh((X - spike) / width);
}

double Map::operator()(double X) const { return (raw(X) - first_) / range_; }

double Map::slope(double X) const {
  const auto& [inlet, exit, l, d, spike, width] = shape_;
  const auto rise = [](double y, double scale) { return 1 / (std::sqrt(1 + y * y) * scale); };
  const double y = (X + l * (1 + d)) / (2 * d * l);
  return (rise(X / (0.7 * l), 0.7 * l) + rise((X + l) / (d * l), d * l) + 3 / ((1 + y * y) * 2 * d * l) +
          rise((X - spike) / width, width)) /
         range_;
}

Array Map::slopes(const Array& X) const {
  Array result(X.size());
  for (Eigen::Index i = 0; i < X.size(); ++i) result[i] = slope(X[i]);
  return result;
}

double Map::inverse(double s, double guess, double low, double high) const {
  double X = guess > low && guess < high ? guess : (low + high) / 2;
  for (int step = 0; step < 100; ++step) {
    const double error = (*this)(X) - s;
    const double next = X - error / slope(X);
    if (std::abs(error) < 1e-9) return next;  // quadratic: this step leaves rounding alone
    (error > 0 ? high : low) = X;
    X = next > low && next < high ? next : (low + high) / 2;
  }
  return X;
}

Array Map::nodes(int n) const {
  Array X(n + 1);
  X[0] = shape_.inlet;
  X[n] = shape_.exit;
  if (n <= 32 || n % 2 == 1) {
    for (int i = 1; i < n; ++i) {
      const double before = X[i - 1];
      X[i] = inverse(static_cast<double>(i) / n, before + 1 / (n * slope(before)), before, shape_.exit);
    }
    return X;
  }
  const Array coarse = nodes(n / 2);
  const Array by_slope = slopes(coarse).inverse();
  for (int i = 0; i < n / 2; ++i) {
    X[2 * i] = coarse[i];
    // The cubic through both neighbours and their slopes.
    const double guess = (coarse[i] + coarse[i + 1]) / 2 + (by_slope[i] - by_slope[i + 1]) / (4.0 * n);
    X[2 * i + 1] = inverse((2 * i + 1.0) / n, guess, coarse[i], coarse[i + 1]);
  }
  return X;
}

}  // namespace ehd::fast
