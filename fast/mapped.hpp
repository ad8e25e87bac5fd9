// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/solver.hpp"
#include "fast/workspace.hpp"

namespace ehd::fast {

/// The FFT multigrid solver on a mapped grid: nodes gather in the inlet zone and at the spike, where a map made from
/// coarser solutions puts them; a kernel product is one FFT and a smooth remainder. Second order, films extrapolated.
class Mapped {
 public:
  static constexpr SolverDescription description{
      .name = "fast",
      .method = "mapped grid, full multigrid, Newton-GMRES, one FFT and a smooth remainder a kernel product",
      .cite = "this project",
      .formal_order = 2,
      .work_exponent = 1};
  static constexpr int largest_nodes = 65536;

  [[nodiscard]] Solution solve(const Problem& problem, const Request& request) const;
  /// The same with plans, tables and arrays that the caller keeps. One thread at a time.
  [[nodiscard]] Solution solve(const Problem& problem, const Request& request, Workspace& workspace) const;
  /// The same, started from the solution of a neighbouring problem, by any solver. The map and the pressure are taken
  /// from that solution at tolerances below 3e-4, where this saves a tenth of the steps. Where this start fails, the
  /// solver starts from nothing.
  [[nodiscard]] Solution solve(const Problem& problem, const Request& request, Workspace& workspace,
                               const Solution& start) const;
};

}  // namespace ehd::fast
