// SPDX-License-Identifier: GPL-3.0-or-later
// First iterates on the finer grids of one map. Two grids tell where the spike, the exit and H_0 go next, and the
// pressure is carried along. Without this the spike marches to its place, about one node a Newton step: the flux is
// exponential in P there, and its linearisation sees one node ahead.
#pragma once

#include <optional>
#include <utility>

#include "fast/grid.hpp"
#include "fast/state.hpp"

namespace ehd::fast {

/// The iterate on a grid with `n` intervals by cubic interpolation; pressure kept >= 0.
[[nodiscard]] State interpolate_to(const State& coarse, int n);

class Prolongation {
 public:
  /// The solution on a grid; each has about twice the intervals of the one before.
  void note(const State& solution) { before_ = std::exchange(last_, solution); }
  /// The first iterate on n intervals, more than the last solution has. Needs at least one solution. From one solution,
  /// or without a spike, it only interpolates.
  [[nodiscard]] State onto(int n, Grids& grids, double inlet) const;

 private:
  std::optional<State> before_, last_;
};

}  // namespace ehd::fast
