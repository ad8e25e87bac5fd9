// SPDX-License-Identifier: GPL-3.0-or-later
// What the grids of `fast` say of their limit and its errors, and how its solve ended.
#pragma once

#include <vector>

#include "contact/solver.hpp"
#include "fast/extrapolation.hpp"
#include "fast/judgement.hpp"
#include "fast/run.hpp"

namespace ehd::fast {

/// The result of one pass through all grids of a map.
struct MappedClimb {
  std::vector<GridRecord> grids;  ///< coarse to fine
  MapFit fit = MapFit::settled;   ///< of the map that they share
  Fields fields;                  ///< of the finest grid
  std::vector<Fields> beside;     ///< the pressure of the grid before
  std::vector<State> states;      ///< the solutions, a grid each
  ErrorBudget film_minimum, film_central;
  std::vector<double> left;  ///< relative error that iteration leaves in the films, a grid each
  bool complete = false;     ///< Newton reached the last grid
};

/// The inlet is cut at X > -2.5. There the residual says little of the films: (M, L) = (0.0262, 42.7), cut at -1.05 and
/// asked for 7e-3, ended 5e-3 off where 9e-4 was stated.
[[nodiscard]] bool is_cut_near_the_contact(const Problem& problem);

/// Errors are calibrated up to M = 5000 and L = 30, and for nearly isoviscous oil at any M. Elsewhere the spike is
/// narrower; nearly isoviscous films have no spike.
[[nodiscard]] bool is_calibrated(const Groups& groups);

/// Relative error of the films from iteration: the largest of the last five grids.
[[nodiscard]] double iteration_error(const MappedClimb& climb);

/// Errors of a film, film_minimum or film_central.
[[nodiscard]] ErrorBudget film_budget(const MappedClimb& climb, Quantity film, const Run& run);

/// Puts the limits of the grids, their errors, and notes into `solution`. The climb must have grids.
void judge(const MappedClimb& climb, const Problem& problem, Solution& solution);

[[nodiscard]] Ending ending_of(const MappedClimb& climb, const Run& run, const Request& request);

}  // namespace ehd::fast
