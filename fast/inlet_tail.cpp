// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/inlet_tail.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ehd::fast {

namespace {

/// Of the quadrature; 8 and 16 points give the same film to 1e-9 of H_cen.
constexpr int points = 12;
/// Newton for the points of the rule: most steps, and the move that ends it.
constexpr int most_steps = 100;
constexpr double last_move = 1e-16;
/// Pressures are held where a Q reaches this, and the gap is kept above this part of x^2: both happen only while Newton
/// is far from the solution.
constexpr double largest_aQ = 0.9, least_gap = 1.0 / 8;
/// Below this a Q, P = Q to rounding.
constexpr double linear_aQ = 1e-8;

/// Gauss-Legendre points and weights on (0, 1), and the matrix of integrals from 0 to each point of the Lagrange
/// polynomials through the points.
struct Rule {
  Eigen::Matrix<double, points, 1> t, w;
  Eigen::Matrix<double, points, points> up_to;
};

Rule make_rule() {
  Rule rule;
  for (int i = 0; i < points; ++i) {  // Newton on the Legendre polynomial
    double x = std::cos(std::numbers::pi * (i + 0.75) / (points + 0.5)), slope = 1;
    for (int step = 0; step < most_steps; ++step) {
      double p = 1, before = 0;
      for (int k = 0; k < points; ++k) {
        const double next = ((2 * k + 1) * x * p - k * before) / (k + 1);
        before = p;
        p = next;
      }
      slope = points * (x * p - before) / (x * x - 1);
      const double move = p / slope;
      x -= move;
      if (std::abs(move) < last_move) break;
    }
    rule.t[i] = (1 - x) / 2;
    rule.w[i] = 1 / ((1 - x * x) * slope * slope);
  }
  // The rule itself, shrunk to (0, t_i), integrates each Lagrange polynomial exactly.
  const auto lagrange = [&](int j, double t) {
    double product = 1;
    for (int k = 0; k < points; ++k) {
      if (k != j) product *= (t - rule.t[k]) / (rule.t[j] - rule.t[k]);
    }
    return product;
  };
  for (int i = 0; i < points; ++i) {
    for (int j = 0; j < points; ++j) {
      double sum = 0;
      for (int k = 0; k < points; ++k) sum += rule.w[k] * lagrange(j, rule.t[i] * rule.t[k]);
      rule.up_to(i, j) = rule.t[i] * sum;
    }
  }
  return rule;
}

}  // namespace

InletTail inlet_tail(double far, double gap_excess, double moment, double flux, double lambda, double slope) {
  static const Rule rule = make_rule();
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
