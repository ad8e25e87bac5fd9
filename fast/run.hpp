// SPDX-License-Identifier: GPL-3.0-or-later
// What the solvers of this folder share on the way through their grids.
#pragma once

#include "contact/solver.hpp"
#include "fast/newton_krylov.hpp"
#include "fast/workspace.hpp"
#include "fast/start.hpp"

namespace ehd::fast {

/// Everything that one solve carries from grid to grid.
struct Run {
  const Problem& problem;
  Setting setting;
  Workspace& workspace;
  Limits limits;
  Counters counters = {};
  Lengths lengths;
  State state = {};
  bool has_state = false;
  bool limit_reached = false;

  /// Cells of a uniform grid in the inlet zone.
  [[nodiscard]] double cells(int n, double exit) const { return lengths.inlet * n / (exit - setting.inlet); }
};

[[nodiscard]] Limits limits_of(const Request& request, std::chrono::steady_clock::time_point begin);

/// At most 60 Newton steps on the grid of `state`; notes a limit that was reached.
NewtonResult newton_on(Run& run, State& state, const Target& target);
/// Converged or nearly, P >= 0 and a film that opens at the exit: the conditions that tracking the exit leaves to check.
[[nodiscard]] bool succeeded(const NewtonResult& result, const Run& run, const State& state);
/// Where a sharpening spike stops Newton on a finer grid: with a floor under the fluidity, lowered to nothing.
[[nodiscard]] bool lower_floor(Run& run, State& state, const Target& target, NewtonResult& result);

/// Of the grid that the workspace holds now.
[[nodiscard]] Fields fields_of(const Run& run);
/// film.offset and approach have absolute errors.
[[nodiscard]] bool is_absolute(Quantity quantity);

/// Grids, counts and times of the run; `planning_before`, `plans_before`: of the workspace when the solve began.
void fill_cost(SolveRecord& record, Run& run, std::chrono::steady_clock::time_point begin, double planning_before,
               long plans_before);

}  // namespace ehd::fast
