// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/graded.hpp"

#include <string>

#include "reference/map.hpp"
#include "reference/study.hpp"

namespace ehd::reference {

namespace {

/// Intervals of the grids that a map is fitted on, and how often it is fitted.
constexpr int coarse = 100, maps = 3;

}  // namespace

Solution Graded::solve(const Problem& problem, const Request& request) const {
  Study study(problem, request);
  if (request.nodes && *request.nodes > largest_nodes)
    return study.without_film(
        StopReason::limit_reached,
        std::to_string(*request.nodes) + " intervals do not fit into memory; at most " + std::to_string(largest_nodes));
  const auto* truncated = std::get_if<TruncatedAt>(&problem.inlet);
  const double inlet = truncated ? truncated->x : farthest_inlet * contact_length(study.expected_film());

  // A map from the film formula, then three from what was solved on the map before; the last one stays.
  GradedMap map = first_map(inlet, study.expected_film());
  std::optional<Level> level = study.solve(map.grid(coarse));
  for (int i = 1; level && i <= maps; ++i) {
    map = adapted_map(level->state, level->at);
    if (i < maps) level = study.solve(map.grid(coarse), *level);
  }
  if (!level)
    return study.without_film(study.limit_reached() ? StopReason::limit_reached : StopReason::diverged,
                              "no positive film was found on " + std::to_string(coarse) + " intervals");

  const auto grid = [&](int intervals) { return map.grid(intervals); };
  if (request.nodes) {
    // The last three grids give the error. Grids down to `coarse` are solved too, each as the start of the next: where
    // the load is very heavy, a start on a quarter of the nodes is too coarse.
    const auto sizes = halved_sizes(*request.nodes, [&](int n) { return 4 * n >= *request.nodes || n >= coarse; });
    return solve_grids(study, grid, sizes, {}, *request.nodes % 4 == 0, level);
  }
  return solve_grids(study, grid, doubled_sizes(coarse, largest_nodes), request.tolerance, true, level);
}

}  // namespace ehd::reference
