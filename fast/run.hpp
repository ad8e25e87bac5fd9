// SPDX-License-Identifier: GPL-3.0-or-later
// One solve on its way through the grids: what both solvers of this folder do alike.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include "contact/solver.hpp"
#include "fast/counters.hpp"
#include "fast/judgement.hpp"
#include "fast/newton_krylov.hpp"
#include "fast/start.hpp"
#include "fast/workspace.hpp"

namespace ehd::fast {

/// Where the grid of a flooded contact begins, X_a = -reach max(1, sqrt(2 H_cen)), and the relative film error that the
/// asymptotic tail beyond X_a leaves.
struct FloodedInlet {
  double reach, truncation;
};

/// Everything that one solve carries from grid to grid.
struct Run {
  const Problem& problem;
  Setting setting;
  Workspace& workspace;
  Limits limits;
  Lengths lengths;
  Wanted observed;                ///< read from every grid: the wanted quantities, and both films
  Tables tables = Tables::usual;  ///< of a mapped grid
  double truncation = 0;          ///< relative film error by the cut inlet; 0 where the problem itself cuts
  std::chrono::steady_clock::time_point begin;
  double planning_before = 0;  ///< of the workspace, when the solve began [s]
  Counters counters = {};
  State state = {};
  bool has_state = false;
  bool limit_reached = false;
  /// Residual at which Newton ends on the grids of Request::nodes where the request has no iteration_share.
  double residual_on_given_grids = round_off_residual;
};

/// The time limit starts here.
[[nodiscard]] Run begin_run(const Problem& problem, const Request& request, Workspace& workspace,
                            const FloodedInlet& far);

/// A grid of the workspace; the time to make it is noted.
[[nodiscard]] Grid& grid_of(Run& run, int intervals);

/// How Newton ended, and whether it ended on a solution: converged or nearly. A solution also needs P >= 0 and a film
/// that opens at the exit; the equations do not enforce these two.
struct Attempt {
  bool succeeded = false;
  NewtonResult newton = {};
};

/// Newton on the grid of `state`. Notes in the run that a limit was reached.
[[nodiscard]] Attempt newton_on(Run& run, State& state, const Target& target);
/// Newton from nothing: pressures of Hertz and of Martin, films about the expected one. A success goes to run.state.
[[nodiscard]] Attempt cold_start(Run& run, Grid& grid, const Target& target);
/// Where a sharpening spike stops Newton: a floor under the fluidity, 1/eta + delta, is lowered step by step to
/// nothing. `state`: the start, then the solution.
[[nodiscard]] Attempt lower_floor(Run& run, State& state, const Target& target);

/// The numbers of intervals on the way.
struct GridPlan {
  std::vector<int> given;  ///< with Request::nodes: all of them, coarse to fine
  int first = 0;
  int last = 0;

  /// N, N/2, …, odd numbers rounded up, as long as `halve` is true for the coarsest so far.
  [[nodiscard]] static GridPlan down_from(int nodes, const std::function<bool(int)>& halve);
  /// first, 2 first, … up to last.
  [[nodiscard]] static GridPlan doubling(int first, int last) { return {.given = {}, .first = first, .last = last}; }
  /// The number of intervals after n; empty after the last.
  [[nodiscard]] std::optional<int> after(int n) const;
};

/// The fields on the grid that Newton ended on last, with the pressure of run.state.
[[nodiscard]] Fields fields_of(const Run& run);
/// Counts and times of the run, and the number of its grids.
void fill_cost(SolveRecord& record, Run& run);

}  // namespace ehd::fast
