// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/steep_fall.hpp"

#include <algorithm>

namespace ehd::fast {

namespace {

/// A steep fall takes at most so many cells.
constexpr Eigen::Index most_cells = 2;
/// It ends where the pressure falls from node to node by less than this part of the steepest cell's fall.
constexpr double least_fall = 0.1;

}  // namespace

double SteepFall::mean(double X, double width) const {
  const double before = std::clamp((jump - X) / width + 0.5, 0.0, 1.0);
  return before * P_top + (1 - before) * P_bottom;
}

std::optional<SteepFall> steep_fall(const Array& X, const Array& P) {
  const Eigen::Index n = P.size() - 1;
  Eigen::Index steepest = 0;
  ((P.head(n) - P.tail(n)) / (X.tail(n) - X.head(n))).maxCoeff(&steepest);
  Eigen::Index top = steepest, bottom = steepest + 1;
  while (top > 0 && P[top - 1] > P[top]) --top;
  while (bottom < n && P[bottom] - P[bottom + 1] > least_fall * (P[steepest] - P[steepest + 1])) ++bottom;
  if (bottom - top > most_cells || bottom == n) return std::nullopt;
  const Eigen::Index cells = bottom - top;
  const double integral =
      ((X.segment(top + 1, cells) - X.segment(top, cells)) * (P.segment(top, cells) + P.segment(top + 1, cells)))
          .sum() /
      2;
  const double above = integral - P[bottom] * (X[bottom] - X[top]);
  return SteepFall{.top = top,
                   .bottom = bottom,
                   .P_top = P[top],
                   .P_bottom = P[bottom],
                   .jump = X[top] + above / (P[top] - P[bottom])};
}

}  // namespace ehd::fast
