// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ehd::fast {

namespace {

/// Newton stops here: the step from this error of s leaves rounding alone, since Newton contracts quadratically.
constexpr double last_error = 1e-9;
/// Newton for all nodes at once; nodes that are not sharp after so many steps are found one by one, by bracketed
/// Newton.
constexpr int steps_together = 7, steps_alone = 100;
/// Grids of up to so many intervals are made from nothing, finer even ones from the grid of half as many.
constexpr int made_from_nothing = 32;
/// The first values come from s at X = centre + unit sinh(pitch k), |k| <= reach, for each term of the map.
constexpr int sample_reach = 12;
constexpr double sample_pitch = 0.8;

}  // namespace

Map::Map(const MapShape& shape) : shape_(shape) {
  first_ = raw(shape.inlet);
  range_ = raw(shape.exit) - first_;
}

double Map::raw(double X) const {
  const auto& [inlet, exit, l, d, spike, width] = shape_;
  return std::asinh(X / (0.7 * l)) + std::asinh((X + l) / (d * l)) + 3 * std::atan((X + l * (1 + d)) / (2 * d * l)) +
         std::asinh((X - spike) / width);
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

namespace {

/// asinh, with a rounding error relative to the larger of 1 and the result: enough for a sum of such terms.
Array asinh_of(const Array& y, const Array& root) { return (y.abs() + root).log() * y.sign(); }

/// atan: three half angles bring |y| below tan(pi/16) = 0.199; there the series' next term is below 1e-18.
Array atan_of(const Array& y, const Array& root) {
  Array t = y / (1 + root);
  t = t / (1 + (1 + t * t).sqrt());
  t = t / (1 + (1 + t * t).sqrt());
  const Array q = t * t;
  Array sum = Array::Constant(y.size(), 1.0 / 25);
  for (int k = 23; k >= 1; k -= 2) sum = 1.0 / k - q * sum;
  return 8 * t * sum;
}

}  // namespace

void Map::evaluate(const Array& X, Array& s, Array& slope) const {
  const auto& [inlet, exit, l, d, spike, width] = shape_;
  Array y = X / (0.7 * l), root = (1 + y * y).sqrt();
  s = asinh_of(y, root) - first_;
  slope = (root * (0.7 * l)).inverse();
  y = (X + l) / (d * l);
  root = (1 + y * y).sqrt();
  s += asinh_of(y, root);
  slope += (root * (d * l)).inverse();
  y = (X + l * (1 + d)) / (2 * d * l);
  root = (1 + y * y).sqrt();
  s += 3 * atan_of(y, root);
  slope += 3 / (2 * d * l) * (1 + y * y).inverse();
  y = (X - spike) / width;
  root = (1 + y * y).sqrt();
  s += asinh_of(y, root);
  slope += (root * width).inverse();
  s /= range_;
  slope /= range_;
}

Array Map::slopes(const Array& X) const {
  Array s, slope;
  evaluate(X, s, slope);
  return slope;
}

double Map::inverse(double s, double guess, double low, double high) const {
  double X = guess > low && guess < high ? guess : (low + high) / 2;
  for (int step = 0; step < steps_alone; ++step) {
    const double error = (*this)(X)-s;
    const double next = X - error / slope(X);
    if (std::abs(error) < last_error) return next;
    (error > 0 ? high : low) = X;
    X = next > low && next < high ? next : (low + high) / 2;
  }
  return X;
}

Array Map::sharpened(Array X, const Array& target, const Array& low, const Array& high) const {
  Array s, slope;
  double largest = 1;
  for (int step = 0; step < steps_together && !(largest < last_error); ++step) {
    evaluate(X, s, slope);
    s -= target;
    largest = s.abs().maxCoeff();
    X = (X - s / slope).max(low).min(high);
  }
  if (!(largest < last_error)) {
    for (Eigen::Index i = 0; i < X.size(); ++i) X[i] = inverse(target[i], X[i], low[i], high[i]);
  }
  return X;
}

Array Map::refined(const Array& coarse) const {
  const Eigen::Index m = coarse.size() - 1, n = 2 * m;
  const Array slope = slopes(coarse).inverse();
  // The cubic through both neighbours and their slopes, then Newton.
  const Array low = coarse.head(m), high = coarse.tail(m);
  Array X = ((low + high) / 2 + (slope.head(m) - slope.tail(m)) / (4.0 * static_cast<double>(n))).max(low).min(high);
  const Array target = Array::LinSpaced(m, 1, static_cast<double>(n - 1)) / static_cast<double>(n);
  X = sharpened(std::move(X), target, low, high);
  Array all(n + 1);
  all(Eigen::seqN(0, m + 1, 2)) = coarse;
  all(Eigen::seqN(1, m, 2)) = X;
  return all;
}

/// Places that gather as the nodes do, inlet and exit among them, in order.
Array Map::samples() const {
  const auto& [inlet, exit, l, d, spike, width] = shape_;
  Array places(4 * (2 * sample_reach + 1) + 2);
  Eigen::Index count = 0;
  places[count++] = inlet;
  places[count++] = exit;
  for (const auto& [centre, unit] : {std::pair{0.0, 0.7 * l}, {-l, d * l}, {-l * (1 + d), 2 * d * l}, {spike, width}}) {
    for (int k = -sample_reach; k <= sample_reach; ++k) {
      const double X = centre + unit * std::sinh(sample_pitch * k);
      if (X > inlet && X < exit) places[count++] = X;
    }
  }
  std::sort(places.begin(), places.begin() + count);
  return places.head(count);
}

Array Map::nodes(int n) const {
  if (n > made_from_nothing && n % 2 == 0) return refined(nodes(n / 2));
  // First values from straight lines through s at the samples.
  const Array places = samples();
  Array s, slope;
  evaluate(places, s, slope);
  Array low(n - 1), high(n - 1), target(n - 1), X(n - 1);
  Eigen::Index right = 1;
  for (int i = 1; i < n; ++i) {
    target[i - 1] = static_cast<double>(i) / n;
    while (right + 1 < places.size() && s[right] < target[i - 1]) ++right;
    low[i - 1] = places[right - 1];
    high[i - 1] = places[right];
    const double rise = s[right] - s[right - 1];
    X[i - 1] = rise > 0 ? low[i - 1] + (high[i - 1] - low[i - 1]) * (target[i - 1] - s[right - 1]) / rise : low[i - 1];
  }
  Array all(n + 1);
  all[0] = shape_.inlet;
  all[n] = shape_.exit;
  all.segment(1, n - 1) = sharpened(std::move(X), target, low, high);
  return all;
}

}  // namespace ehd::fast
