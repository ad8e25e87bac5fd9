// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ehd::fast {

namespace {

/// Shape of the map; map.hpp has the formula. Width of the crowding in the contact, over l; weight of the crowding
/// before the inlet zone, and its width over that of the inlet zone.
constexpr double contact_width = 0.7, inlet_weight = 3, inlet_spread = 2;
/// Halley's method stops here: the step from this error of s leaves rounding alone, since it contracts cubically.
constexpr double last_error = 1e-6;
/// Bracketed Newton, for nodes one by one, stops here: it contracts quadratically.
constexpr double last_error_alone = 1e-9;
/// Halley's method for a block of nodes; nodes that are not sharp after so many steps are found one by one.
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
  return std::asinh(X / (contact_width * l)) + std::asinh((X + l) / (d * l)) +
         inlet_weight * std::atan((X + l * (1 + d)) / (inlet_spread * d * l)) + std::asinh((X - spike) / width);
}

double Map::operator()(double X) const { return (raw(X) - first_) / range_; }

double Map::slope(double X) const {
  const auto& [inlet, exit, l, d, spike, width] = shape_;
  const auto rise = [](double y, double scale) { return 1 / (std::sqrt(1 + y * y) * scale); };
  const double y = (X + l * (1 + d)) / (inlet_spread * d * l);
  return (rise(X / (contact_width * l), contact_width * l) + rise((X + l) / (d * l), d * l) +
          inlet_weight / ((1 + y * y) * inlet_spread * d * l) + rise((X - spike) / width, width)) /
         range_;
}

namespace {

/// atan(y) = 4 atan(t): two half angles bring |y| below tan(pi/8); there x + x^3 P(x^2)/Q(x^2), of S. L. Moshier's
/// Cephes library (atan.c), is exact to rounding up to 0.66.
template <class Block>
Block atan_of(const Block& y, const Block& root) {
  const Block half = y / (1 + root);
  const Block x = half / (1 + (1 + half * half).sqrt()), z = x * x;
  const Block p = (((-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z - 7.500855792314704667340e1) * z -
                   1.228866684490136173410e2) *
                      z -
                  6.485021904942025371773e1;
  const Block q =
      ((((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z + 4.328810604902912668951e2) * z +
       4.853903996359136964868e2) *
          z +
      1.945506571482613964425e2;
  return 4 * (x + x * z * p / q);
}

}  // namespace

/// A sum of asinh is the logarithm of a product: asinh y = ln(y + r) where y >= 0, -ln(-y + r) where y < 0, r^2 = 1 +
/// y^2. With p = max(y, 0) and m = max(-y, 0), of which one is 0, both are ln((p + r_p)/(m + r_m)), and r = r_p r_m.
Map::Values Map::evaluate(const Block& X) const {
  const auto& [inlet, exit, l, d, spike, width] = shape_;
  const double units[] = {contact_width * l, d * l, width}, centres[] = {0, -l, spike}, wide = inlet_spread * d * l;
  Block above = Block::Ones(), below = Block::Ones();
  Values at;
  {
    const Block y = (X + l * (1 + d)) / wide, square = 1 + y * y;
    at.s = inlet_weight * atan_of<Block>(y, square.sqrt()) - first_;
    at.slope = inlet_weight / wide / square;
    at.curvature = -2 / inlet_weight * y * at.slope * at.slope;
  }
  for (int k = 0; k < 3; ++k) {
    const Block y = (X - centres[k]) / units[k], p = y.max(0.0), m = p - y;
    const Block root_p = (1 + p * p).sqrt(), root_m = (1 + m * m).sqrt();
    above *= p + root_p;
    below *= m + root_m;
    const Block rise = (root_p * root_m * units[k]).inverse();
    at.slope += rise;
    at.curvature -= y * units[k] * rise * rise * rise;
  }
  at.s = (at.s + (above / below).log()) / range_;
  at.slope /= range_;
  at.curvature /= range_;
  return at;
}

Map::Block Map::slopes(const Block& X) const {
  const auto& [inlet, exit, l, d, spike, width] = shape_;
  const double units[] = {contact_width * l, d * l, width}, centres[] = {0, -l, spike}, wide = inlet_spread * d * l;
  const Block y = (X + l * (1 + d)) / wide;
  Block slope = inlet_weight / wide / (1 + y * y);
  for (int k = 0; k < 3; ++k) {
    const Block from = X - centres[k];
    slope += (units[k] * units[k] + from * from).sqrt().inverse();
  }
  return slope / range_;
}

double Map::inverse(double s, double guess, double low, double high) const {
  double X = guess > low && guess < high ? guess : (low + high) / 2;
  for (int step = 0; step < steps_alone; ++step) {
    const double error = (*this)(X)-s;
    const double next = X - error / slope(X);
    if (std::abs(error) < last_error_alone) return next;
    (error > 0 ? high : low) = X;
    X = next > low && next < high ? next : (low + high) / 2;
  }
  return X;
}

Map::Block Map::sharpened(Block X, const Block& target, const Block& low, const Block& high) const {
  for (int step = 0; step < steps_together; ++step) {
    const auto [s, slope, curvature] = evaluate(X);
    const Block error = s - target;
    X = (X - 2 * error * slope / (2 * slope * slope - error * curvature)).max(low).min(high);
    if (error.abs().maxCoeff() < last_error) return X;
  }
  for (int i = 0; i < block; ++i) X[i] = inverse(target[i], X[i], low[i], high[i]);
  return X;
}

MapNodes Map::sharpened(const Array& X, const Array& target, const Array& low, const Array& high) const {
  const Eigen::Index count = X.size();
  MapNodes nodes{.X = Array(count), .slope = Array(count)};
  for (Eigen::Index i = 0; i < count; i += block) {
    const Eigen::Index some = std::min<Eigen::Index>(block, count - i);
    const auto part = [&](const Array& all) {  // the last block is filled up with its first place
      Block one = Block::Constant(all[i]);
      one.head(some) = all.segment(i, some);
      return one;
    };
    const Block sharp = sharpened(part(X), part(target), part(low), part(high));
    nodes.X.segment(i, some) = sharp.head(some);
    nodes.slope.segment(i, some) = slopes(sharp).head(some);
  }
  return nodes;
}

MapNodes Map::refined(const MapNodes& coarse) const {
  const Eigen::Index m = coarse.X.size() - 1, n = 2 * m;
  const Array low = coarse.X.head(m), high = coarse.X.tail(m);
  // The cubic through both neighbours and their slopes.
  const Array middle = (low + high) / 2 + (coarse.slope.head(m).inverse() - coarse.slope.tail(m).inverse()) /
                                              (4.0 * static_cast<double>(n));
  const Array target = Array::LinSpaced(m, 1, static_cast<double>(n - 1)) / static_cast<double>(n);
  const MapNodes between = sharpened(middle.max(low).min(high), target, low, high);
  MapNodes all{.X = Array(n + 1), .slope = Array(n + 1)};
  const auto merge = [&](const Array& even, const Array& odd, Array& merged) {
    merged(Eigen::seqN(0, m + 1, 2)) = even;
    merged(Eigen::seqN(1, m, 2)) = odd;
  };
  merge(coarse.X, between.X, all.X);
  merge(coarse.slope, between.slope, all.slope);
  return all;
}

/// Places that gather as the nodes do, inlet and exit among them, in order.
Array Map::samples() const {
  const auto& [inlet, exit, l, d, spike, width] = shape_;
  Array places(4 * (2 * sample_reach + 1) + 2);
  Eigen::Index count = 0;
  places[count++] = inlet;
  places[count++] = exit;
  for (const auto& [centre, unit] :
       {std::pair{0.0, contact_width * l}, {-l, d * l}, {-l * (1 + d), inlet_spread * d * l}, {spike, width}}) {
    for (int k = -sample_reach; k <= sample_reach; ++k) {
      const double X = centre + unit * std::sinh(sample_pitch * k);
      if (X > inlet && X < exit) places[count++] = X;
    }
  }
  std::sort(places.begin(), places.begin() + count);
  return places.head(count);
}

MapNodes Map::nodes(int n) const {
  if (n > made_from_nothing && n % 2 == 0) return refined(nodes(n / 2));
  // First values from straight lines through s at the samples.
  const Array places = samples();
  Array low(n - 1), high(n - 1), target(n - 1), X(n - 1);
  Eigen::Index right = 1;
  double s_left = 0, s_right = (*this)(places[1]);
  for (int i = 1; i < n; ++i) {
    target[i - 1] = static_cast<double>(i) / n;
    while (right + 1 < places.size() && s_right < target[i - 1]) {
      s_left = s_right;
      s_right = (*this)(places[++right]);
    }
    low[i - 1] = places[right - 1];
    high[i - 1] = places[right];
    const double rise = s_right - s_left;
    X[i - 1] = rise > 0 ? low[i - 1] + (high[i - 1] - low[i - 1]) * (target[i - 1] - s_left) / rise : low[i - 1];
  }
  const MapNodes between = sharpened(X, target, low, high);
  MapNodes all{.X = Array(n + 1), .slope = Array(n + 1)};
  all.X << shape_.inlet, between.X, shape_.exit;
  all.slope << slope(shape_.inlet), between.slope, slope(shape_.exit);
  return all;
}

}  // namespace ehd::fast
