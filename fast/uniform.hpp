// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/solver.hpp"
#include "fast/workspace.hpp"

namespace ehd::fast {

/// The classical FFT multigrid solver on a uniform grid, done well: full multigrid (each grid starts from the one
/// before), Newton-GMRES with one FFT convolution a Jacobian product, a multigrid cycle with a banded dipole smoother
/// as preconditioner, the exit tracked as an unknown. Grids of 64 to 65536 intervals (any number from 16 with
/// Request::nodes). Domain: flooded M 0.05..1000 and L 0..25; with the inlet cut at X = -4, M from 0.5.
///
/// With a tolerance the solver doubles the grid until film.minimum and film.central are estimated within the tolerance;
/// values are those of the finest grid, never extrapolated.
class Uniform {
 public:
  static constexpr SolverDescription description{
      .name = "fast.uniform",
      .method = "uniform grid, full multigrid, Newton-GMRES, FFT convolution, banded dipole smoother",
      .cite = "Venner & Lubrecht 2000 for multigrid in EHD; this project for the smoother and the exit",
      .formal_order = 2,
      .work_exponent = 1};
  static constexpr int largest_nodes = 65536;

  [[nodiscard]] Solution solve(const Problem& problem, const Request& request) const;
  /// The same with plans, tables and arrays that the caller keeps. One thread at a time.
  [[nodiscard]] Solution solve(const Problem& problem, const Request& request, Workspace& workspace) const;
};

}  // namespace ehd::fast
