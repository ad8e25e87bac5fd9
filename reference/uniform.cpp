// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/uniform.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "reference/study.hpp"

namespace ehd::reference {

namespace {

/// Equal cells where the film lives; for a flooded inlet a quarter of them leaves X = -4 l with the same spacing and
/// stretches as sinh, the farther the more there are: what is truncated falls as n^-2, like the error of the cells.
Grid grid_of(const Inlet& inlet, double expected_film, int intervals) {
  if (const auto* truncated = std::get_if<TruncatedAt>(&inlet)) return uniform_grid(truncated->x, intervals);
  const double l = contact_length(expected_film), far = std::max(-2.0 * intervals, farthest_inlet) * l;
  const double exit = 1 + 0.5 * (l - 1);  // roughly; the grid follows the exit
  const int outer = intervals / 4, inner = intervals - outer;
  const double h = (exit + 4 * l) / inner, reach = -far - 4 * l;
  double stretch = 1;  // h outer sinh(stretch)/stretch = reach
  for (int i = 0; i < 60; ++i) stretch = std::asinh(reach * stretch / (h * outer));
  Array X(intervals + 1);
  for (int i = 0; i < outer; ++i) X[i] = -4 * l - h * outer / stretch * std::sinh(stretch * (outer - i) / outer);
  for (int i = 0; i <= inner; ++i) X[outer + i] = -4 * l + h * i;
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
    return solve_grids(study, grid, sizes, std::nullopt, false, std::nullopt);
  }
  int first = 64;
  while (expected_cells(first) < fewest_inlet_cells && 2 * first <= largest_nodes) first *= 2;
  return solve_grids(study, grid, doubled_sizes(first, largest_nodes), request.tolerance, false, std::nullopt);
}

}  // namespace ehd::reference
