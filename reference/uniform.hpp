// SPDX-License-Identifier: GPL-3.0-or-later
// reference.uniform: the equations on equal cells, in the shortest readable code. README.md, sections 1 to 4.
#pragma once

#include "contact/solver.hpp"

namespace ehd::reference {

/// Dense full Newton, piecewise-linear pressure, tracked exit.
/// - inlet TruncatedAt x: n equal cells from x to the exit.
/// - Flooded: three quarters of the n cells are equal, from X = -4 l (l = max(1, sqrt(2 H_c))) to the exit; the others
///   stretch out to -2 n l, at most to -4000 l.
/// - Request::nodes: the values of that grid; their errors come from it and its halves.
/// - Request::tolerance: doubles the grid until both films are estimated within it; never extrapolates.
class Uniform {
 public:
  static constexpr SolverDescription description{
      .name = "reference.uniform",
      .method = "Dense full Newton on equal cells: piecewise-linear pressure, exact log kernel, tracked exit",
      .cite = "this project, reference/README.md",
      .formal_order = 2,
      .work_exponent = 3};
  /// More would not fit into memory: two dense matrices of 8 n^2 bytes, 2.3 GB here.
  static constexpr int largest_nodes = 12000;
  [[nodiscard]] Solution solve(const Problem& problem, const Request& request) const;
};

}  // namespace ehd::reference
