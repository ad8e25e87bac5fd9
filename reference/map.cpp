// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/map.hpp"

#include <algorithm>
#include <cmath>

namespace ehd::reference {

namespace {

// Shape of the map; map.hpp has the formula. Measured on grids of 400 intervals: other bump weights and widths move the
// error by a factor of two either way. The wedge matters (map.hpp).
constexpr double contact_width = 0.7;       // of the crowding in the contact, over l
constexpr double bump_reach = 3;            // beyond this times l a bump adds no nodes
constexpr double inlet_weight = 3;          // of the crowding before the inlet zone
constexpr double inlet_spread = 2;          // its width, over that of the inlet zone
constexpr double wedge = -0.5;              // the wedge's k far behind the contact; 0.5 before it
constexpr double wedge_steepness = 4;       // of its change at X = 0, per l
constexpr double first_spike_width = 0.5;   // first guess, over d l
constexpr double least_spike_width = 0.02;  // of a fitted map, over d l
constexpr int bisections = 60;

}  // namespace

double GradedMap::density_integral(double X) const {
  const auto bump = [&](double x, double width) {
    return std::asinh(x / width) - std::asinh(x / (bump_reach * length));
  };
  return std::asinh(X / (contact_width * length)) + bump(X + length, inlet_zone * length) +
         inlet_weight * std::atan((X + length * (1 + inlet_zone)) / (inlet_spread * inlet_zone * length)) +
         bump(X - spike, spike_width);
}

Grid GradedMap::grid(int intervals) const {
  const double begin = density_integral(inlet), end = density_integral(exit);
  Grid grid{.inlet = inlet, .fractions = Array(intervals + 1), .kappa = Array(intervals)};
  double X = inlet;
  for (int i = 0; i <= intervals; ++i) {
    const double s = begin + (end - begin) * i / intervals;
    double low = X, high = exit;
    for (int step = 0; step < bisections && i > 0; ++step) {
      X = (low + high) / 2;
      (density_integral(X) < s ? low : high) = X;
    }
    if (i == intervals) X = exit;
    grid.fractions[i] = (exit - X) / (exit - inlet);
    if (i < intervals) grid.kappa[i] = wedge * std::tanh(wedge_steepness * X / length);
  }
  return grid;
}

GradedMap first_map(double inlet, double central_film) {
  const double d = inlet_zone(central_film), l = contact_length(central_film);
  // The spike stands as far inside X = 1 as the exit stands outside.
  const double exit = std::max(1 + exit_per_inlet_zone * d, exit_per_film_length * l);
  return {.inlet = inlet,
          .exit = exit,
          .length = l,
          .inlet_zone = d,
          .spike = 1 - exit_per_inlet_zone * d,
          .spike_width = first_spike_width * d * l};
}

GradedMap adapted_map(const State& state, const Evaluation& at) {
  const Eigen::Index n = at.gradient.size();
  GradedMap map = first_map(at.X[0], local_cubic(at.X, at.H, 0));
  map.exit = state.exit;
  Eigen::Index steepest = n - 1;
  for (Eigen::Index i = 0; i < n; ++i)
    if (at.X[i] > 0 && at.gradient[i] < at.gradient[steepest]) steepest = i;
  map.spike = (at.X[steepest] + at.X[steepest + 1]) / 2;
  map.spike_width =
      std::max(least_spike_width * map.inlet_zone * map.length, (at.X[steepest + 1] - at.X[steepest]) / 2);
  return map;
}

}  // namespace ehd::reference
