// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/map.hpp"

#include <algorithm>
#include <cmath>

namespace ehd::reference {

double GradedMap::density_integral(double X) const {
  const auto bump = [&](double x, double width) { return std::asinh(x / width) - std::asinh(x / (3 * length)); };
  return std::asinh(X / (0.7 * length)) + bump(X + length, inlet_zone * length) +
         3 * std::atan((X + length * (1 + inlet_zone)) / (2 * inlet_zone * length)) + bump(X - spike, spike_width);
}

Grid GradedMap::grid(int intervals) const {
  const double begin = density_integral(inlet), end = density_integral(exit);
  Grid grid{.inlet = inlet, .fractions = Array(intervals + 1), .kappa = Array(intervals)};
  double X = inlet;
  for (int i = 0; i <= intervals; ++i) {
    const double s = begin + (end - begin) * i / intervals;
    double low = X, high = exit;
    for (int bisections = 0; bisections < 60 && i > 0; ++bisections) {
      X = (low + high) / 2;
      (density_integral(X) < s ? low : high) = X;
    }
    if (i == intervals) X = exit;
    grid.fractions[i] = (exit - X) / (exit - inlet);
    if (i < intervals) grid.kappa[i] = -0.5 * std::tanh(4 * X / length);
  }
  return grid;
}

GradedMap first_map(double inlet, double central_film) {
  const double d = inlet_zone(central_film), l = contact_length(central_film);
  const double exit = std::max(1 + 0.45 * d, 0.5 * l);
  return {
      .inlet = inlet, .exit = exit, .length = l, .inlet_zone = d, .spike = 1 - 0.45 * d, .spike_width = 0.5 * d * l};
}

GradedMap adapted_map(const State& state, const Evaluation& at) {
  const Eigen::Index n = at.gradient.size();
  GradedMap map = first_map(at.X[0], local_cubic(at.X, at.H, 0));
  map.exit = state.exit;
  Eigen::Index steepest = n - 1;
  for (Eigen::Index i = 0; i < n; ++i)
    if (at.X[i] > 0 && at.gradient[i] < at.gradient[steepest]) steepest = i;
  map.spike = (at.X[steepest] + at.X[steepest + 1]) / 2;
  map.spike_width = std::max(0.02 * map.inlet_zone * map.length, (at.X[steepest + 1] - at.X[steepest]) / 2);
  return map;
}

}  // namespace ehd::reference
