// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/uniform.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "reference/study.hpp"

namespace ehd::reference {

namespace {

/// A flooded domain: equal cells begin at X = -4 l, the others are a quarter of all.
constexpr double equal_from = 4;
constexpr int stretched_part = 4;
/// X_a = -2 n l, and not beyond farthest_inlet.
constexpr double far_per_interval = -2;
/// First guess of X*: 1 + this times (l - 1). The grid follows the exit.
constexpr double exit_per_length = 0.5;
/// Steps of the fixed-point iteration for the stretching.
constexpr int stretch_steps = 60;
/// Intervals of the first grid where a tolerance is given.
constexpr int first_intervals = 64;

/// Equal cells where the film lives. Of a flooded inlet a quarter of the cells lies before X = -4 l: it begins with the
/// same spacing and stretches as sinh. More cells reach farther, so that what is cut off falls as n^-2, as the error of
/// the cells does.
Grid grid_of(const Inlet& inlet, double expected_film, int intervals) {
  if (const auto* truncated = std::get_if<TruncatedAt>(&inlet)) return uniform_grid(truncated->x, intervals);
  const double l = contact_length(expected_film), far = std::max(far_per_interval * intervals, farthest_inlet) * l;
  const double exit = 1 + exit_per_length * (l - 1);
  const int outer = intervals / stretched_part, inner = intervals - outer;
  const double h = (exit + equal_from * l) / inner, reach = -far - equal_from * l;
  double stretch = 1;  // h outer sinh(stretch)/stretch = reach
  for (int i = 0; i < stretch_steps; ++i) stretch = std::asinh(reach * stretch / (h * outer));
  Array X(intervals + 1);
  for (int i = 0; i < outer; ++i)
    X[i] = -equal_from * l - h * outer / stretch * std::sinh(stretch * (outer - i) / outer);
  for (int i = 0; i <= inner; ++i) X[outer + i] = -equal_from * l + h * i;
  return {.inlet = X[0], .fractions = (X[intervals] - X) / (X[intervals] - X[0]), .kappa = Array::Zero(intervals)};
}

}  // namespace

Solution Uniform::solve(const Problem& problem, const Request& request) const {
  Study study(problem, request);
  const auto grid = [&](int intervals) { return grid_of(problem.inlet, study.expected_film(), intervals); };
  const auto expected_cells = [&](int intervals) {
    return inlet_cells(grid(intervals).nodes(1), study.expected_film());
  };
  if (request.nodes) {
    if (*request.nodes > largest_nodes)
      return study.without_film(StopReason::limit_reached, std::to_string(*request.nodes) +
                                                               " intervals do not fit into memory; at most " +
                                                               std::to_string(largest_nodes));
    const int quarter = *request.nodes / 4;
    const auto sizes = halved_sizes(*request.nodes, [&](int n) { return n >= quarter || expected_cells(n) >= 1; });
    return solve_grids(study, grid, sizes, {}, false, std::nullopt);
  }
  int first = first_intervals;
  while (expected_cells(first) < fewest_inlet_cells && 2 * first <= largest_nodes) first *= 2;
  return solve_grids(study, grid, doubled_sizes(first, largest_nodes), request.tolerance, false, std::nullopt);
}

}  // namespace ehd::reference
