// SPDX-License-Identifier: GPL-3.0-or-later
// What the grids of fast.uniform say of their errors, and how its solve ended.
#pragma once

#include <string>
#include <vector>

#include "contact/solver.hpp"
#include "fast/judgement.hpp"
#include "fast/run.hpp"

namespace ehd::fast {

/// A uniform grid needs this many cells in the inlet zone before its numbers mean anything. Calibrated at M = 1000,
/// L = 10: 0.5 cells 40 % off, 1 cell 12..16 %, 2 cells 2..3 %, 4 cells 1 % (H_min and H_cen).
constexpr double fewest_inlet_cells = 1.5;
/// Relative film error of a grid with so many cells in the inlet zone; covers the calibration above three times over.
[[nodiscard]] double error_of_inlet_cells(double cells);

/// What a climb through the grids leaves.
struct UniformClimb {
  std::vector<GridRecord> grids;  ///< coarse to fine
  Fields fields;                  ///< of the finest grid
  std::vector<Fields> beside;     ///< the pressure of the grid before
  ErrorBudget film_minimum, film_central;
  double iteration = 0;  ///< relative error that iteration leaves in the films of the finest grid
  double cells = 0;      ///< in the inlet zone of the finest grid
  int refused = 0;       ///< intervals of a grid that Newton could not solve on, after others; 0: none
};

/// Error of a quantity on the finest grid. `truncation`: of the films.
[[nodiscard]] ErrorBudget error_budget(const UniformClimb& climb, Quantity quantity, double truncation);

/// Observables of the finest grid with their errors, film budgets, and notes; only where the climb has grids.
void judge(const UniformClimb& climb, const Run& run, Solution& solution);

[[nodiscard]] Ending ending_of(const UniformClimb& climb, const Run& run, const Request& request,
                               const SolveRecord& record);

}  // namespace ehd::fast
