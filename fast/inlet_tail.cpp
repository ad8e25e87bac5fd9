// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/inlet_tail.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fast/tail_rule.hpp"

namespace ehd::fast {

namespace {

/// Pressures are held where a Q reaches this, and the gap is kept above this part of x^2: both happen only while Newton
/// is far from the solution.
constexpr double largest_aQ = 0.9, least_gap = 1.0 / 8;
/// Below this a Q, P = Q to rounding.
constexpr double linear_aQ = 1e-8;

}  // namespace

InletTail inlet_tail(double far, double gap_excess, double moment, double flux, double lambda, double slope) {
  const TailRule& rule = tail_rule();
  constexpr int points = TailRule::points;
  using std::numbers::pi;
  Eigen::Matrix<double, points, 1> gap, integrand;
  for (int k = 0; k < points; ++k) {
    const double t = rule.t[k], x = far / t;
    gap[k] = std::max(x * x / 2 + gap_excess + std::log(t) / 2 - moment / pi * (t - 1) / far, x * x * least_gap);
    integrand[k] = lambda * (1 - flux / gap[k]) / (gap[k] * gap[k]) * far / (t * t);
  }
  const auto pressure_of = [&](double reduced) {
    const double q = std::min(slope * reduced, largest_aQ);
    return q > linear_aQ ? -std::log1p(-q) / slope : reduced;
  };
  const Eigen::Matrix<double, points, 1> reduced = rule.up_to * integrand;

  InletTail tail;
  tail.pressure = pressure_of(rule.w.dot(integrand));
  for (int k = 0; k < points; ++k) {
    const double t = rule.t[k], x = far / t;
    const double P = pressure_of(reduced[k]), share = rule.w[k] * far / (t * t) * P;
    tail.load += share;
    tail.work += rule.w[k] * integrand[k] * gap[k] / (1 - std::min(slope * reduced[k], largest_aQ));
    // ln(x + X) = ln x + X/x - X^2/(2 x^2) + …
    tail.deflection[0] -= share * std::log(x) / pi;
    tail.deflection[1] -= share / x / pi;
    tail.deflection[2] += share / (x * x) / (2 * pi);
    tail.deflection[3] -= share / (x * x * x) / (3 * pi);
    tail.deflection[4] += share / (x * x * x * x) / (4 * pi);
  }
  return tail;
}

}  // namespace ehd::fast
