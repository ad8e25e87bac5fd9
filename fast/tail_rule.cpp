// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/tail_rule.hpp"

#include <cmath>
#include <numbers>

namespace ehd::fast {

namespace {

/// Newton for the points of the rule: most steps, and the move that ends it.
constexpr int most_steps = 100;
constexpr double last_move = 1e-16;

TailRule make_rule() {
  constexpr int points = TailRule::points;
  TailRule rule;
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

const TailRule& tail_rule() {
  static const TailRule rule = make_rule();
  return rule;
}

}  // namespace ehd::fast
