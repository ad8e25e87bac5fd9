// SPDX-License-Identifier: GPL-3.0-or-later
// reference.linear: the same equations on a grid graded to the solution, with Richardson extrapolation. README.md,
// section 5.
#pragma once

#include "contact/solver.hpp"

namespace ehd::reference {

/// Dense full Newton as reference.uniform, on the nested grids n, 2n, 4n … of one smooth map (map.hpp) that is fitted
/// to coarse solutions first.
/// - Flooded: the map reaches to X_a = -4000 l; the truncation error is estimated from cut inlets and is part of the
/// stated error.
/// - Request::nodes: that grid with its halves; Request::tolerance: as many as it needs.
/// - Films are extrapolated where the observed ratio of differences supports order 2, else those of the finest grid.
class Graded {
 public:
  static constexpr SolverDescription description{
      .name = "reference.linear",
      .method = "Dense full Newton on a graded grid fitted to the solution, Richardson extrapolation",
      .cite = "this project, reference/README.md",
      .formal_order = 2,
      .work_exponent = 3};
  /// More would not fit into memory: two dense matrices of 8 n^2 bytes, 2.3 GB here.
  static constexpr int largest_nodes = 12000;
  [[nodiscard]] Solution solve(const Problem& problem, const Request& request) const;
};

}  // namespace ehd::reference
