// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/solver.hpp"

namespace ehd::reference {

/// The certified solver: collocation on polynomial elements adapted to the solution (hp/), with errors from a second,
/// independently adapted discretisation.
/// - Request::tolerance: both discretisations resolve well below it; if their films differ by more, both are refined.
/// - Request::nodes: elements are laid out for just that many intervals; the second discretisation has half as many
///   again.
/// - Flooded: cut at X_a = -800 l with the asymptotic tail before it, for the second discretisation at half of that.
class HighOrder {
 public:
  static constexpr SolverDescription description{
      .name = "reference",
      .method =
          "Dense full Newton on adapted polynomial elements, left Radau collocation, errors from a second such mesh",
      .cite = "this project, reference/hp/README.md",
      .formal_order = 12,
      .work_exponent = 3};
  /// More would not fit into memory: four dense matrices of 8 (1.5 n)^2 bytes, 5.9 GB here.
  static constexpr int largest_nodes = 9000;
  [[nodiscard]] Solution solve(const Problem& problem, const Request& request) const;
};

}  // namespace ehd::reference
