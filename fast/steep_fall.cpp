// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/steep_fall.hpp"

#include <algorithm>

namespace ehd::fast {

namespace {

/// A steep fall takes at most so many cells.
constexpr Eigen::Index most_cells = 2;
/// It ends where the pressure falls from node to node by less than this part of the steepest cell's fall.
constexpr double least_fall = 0.1;

/// The cell in which P falls most steeply, by its left node.
Eigen::Index steepest_cell(const Array& X, const Array& P) {
  const Eigen::Index n = P.size() - 1;
  Eigen::Index cell = 0;
  ((P.head(n) - P.tail(n)) / (X.tail(n) - X.head(n))).maxCoeff(&cell);
  return cell;
}

/// The maximum from which the pressure falls to this node.
Eigen::Index climb(const Array& P, Eigen::Index node) {
  while (node > 0 && P[node - 1] > P[node]) --node;
  return node;
}

}  // namespace

Eigen::Index peak_before_fall(const Array& X, const Array& P) { return climb(P, steepest_cell(X, P)); }

double SteepFall::mean(double X, double width) const {
  const double before = std::clamp((jump - X) / width + 0.5, 0.0, 1.0);
  return before * P_top + (1 - before) * P_bottom;
}

std::optional<SteepFall> steep_fall(const Array& X, const Array& P) {
  const Eigen::Index exit = P.size() - 1, steepest = steepest_cell(X, P), top = climb(P, steepest);
  const double least = least_fall * (P[steepest] - P[steepest + 1]);
  Eigen::Index bottom = steepest + 1;
  while (bottom < exit && P[bottom] - P[bottom + 1] > least) ++bottom;
  if (bottom - top > most_cells || bottom == exit) return std::nullopt;
  double integral = 0;
  for (Eigen::Index i = top; i < bottom; ++i) integral += (X[i + 1] - X[i]) * (P[i] + P[i + 1]) / 2;
  const double above = integral - P[bottom] * (X[bottom] - X[top]);
  return SteepFall{.top = top,
                   .bottom = bottom,
                   .P_top = P[top],
                   .P_bottom = P[bottom],
                   .jump = X[top] + above / (P[top] - P[bottom])};
}

}  // namespace ehd::fast
