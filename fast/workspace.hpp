// SPDX-License-Identifier: GPL-3.0-or-later
// What a caller may keep between solves: FFT plans, kernel tables and every array of a solve, grid by grid, so that a
// second solve allocates next to nothing. One thread at a time.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "fast/discretisation.hpp"
#include "fast/gmres.hpp"
#include "fast/grid.hpp"
#include "fast/jacobian.hpp"
#include "fast/multigrid.hpp"
#include "fast/state.hpp"

namespace ehd::fast {

struct Workspace {
  /// The arrays of Newton on one number of intervals.
  struct OnGrid {
    int n = 0;
    Discretisation now, trial;  ///< of the state, and of a candidate for the next one
    State candidate;
    Jacobian jacobian;  ///< at the state
    Gmres gmres;
    std::vector<Step> preconditioned;  ///< M^-1 v_k of GMRES
    Array right_side;                  ///< of GMRES
    Residual unscaled;                 ///< v_k of GMRES, as a residual
    Step step;
  };

  Grids grids;
  std::array<Grids, 2> moved;  ///< of maps whose nodes have moved a little, forward and back (moved_nodes.hpp)
  Multigrid multigrid;
  OnGrid* current = nullptr;  ///< the arrays of the grid that Newton ended on last

  [[nodiscard]] OnGrid& on(int intervals);
  /// Fields of the state that Newton ended on last.
  [[nodiscard]] const Discretisation& now() const { return current->now; }
  /// The most intervals of a grid that Newton has worked on.
  [[nodiscard]] int largest_grid() const;

 private:
  std::vector<std::unique_ptr<OnGrid>> grids_seen_;
};

}  // namespace ehd::fast
