// SPDX-License-Identifier: GPL-3.0-or-later
// Newton on one grid; each step by flexible GMRES with the multigrid cycle as right preconditioner.
#pragma once

#include <chrono>
#include <limits>
#include <memory>
#include <vector>

#include "fast/discretisation.hpp"
#include "fast/multigrid.hpp"

namespace ehd::fast {

/// What a caller may keep between solves: FFT plans, kernel tables and every array of a solve, grid by grid, so that a
/// second solve allocates next to nothing. One thread at a time.
struct Workspace {
  /// The arrays of Newton on one number of intervals.
  struct OnGrid {
    int n = 0;
    Discretisation now, trial;
    State candidate;
    Step step;
    std::vector<Step> preconditioned;
    std::vector<Array> basis;
    Array product, flux_error;
  };

  Grids grids;
  Multigrid multigrid;
  OnGrid* current = nullptr;  ///< of the grid that Newton ended on last

  [[nodiscard]] OnGrid& on(int intervals);
  /// Fields of the state that Newton ended on last.
  [[nodiscard]] const Discretisation& now() const { return current->now; }

 private:
  std::vector<std::unique_ptr<OnGrid>> grids_seen_;
};

/// What bounds a solve.
struct Limits {
  long newton_iterations = 2000;
  std::chrono::steady_clock::time_point deadline;
  [[nodiscard]] bool time_is_up() const { return std::chrono::steady_clock::now() > deadline; }
};

enum class NewtonEnd { converged, stalled, failed, limit };

/// When Newton is done: residual <= max(residual, 8 x rounding floor), or film_error < film_error at a residual that is
/// small already, at most film_residual.
struct Target {
  double residual = 0;
  double film_error = 0;
  double film_residual = 1e-2;
};

struct NewtonResult {
  NewtonEnd end = NewtonEnd::failed;
  int iterations = 0;
  double residual = 0;  ///< max|e|/(rho_n H_n) or the relative load error, whichever is larger
  /// What iteration left in H_min and H_cen, relative, estimated; infinite where nothing is known.
  double film_error = std::numeric_limits<double>::infinity();
};

/// Until the target is met. `stalled`: no further decrease, residual small (< 1e-3) but above the target. On return
/// workspace.now() holds the fields of `state`.
[[nodiscard]] NewtonResult newton(const Setting& setting, State& state, const Target& target, int most_iterations,
                                  const Limits& limits, Workspace& workspace, Counters& counters);

}  // namespace ehd::fast
