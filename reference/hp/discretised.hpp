// SPDX-License-Identifier: GPL-3.0-or-later
// A solved discretisation: states at several floors of the fluidity, and what is read off the last one.
#pragma once

#include <map>
#include <vector>

#include "contact/solution.hpp"
#include "reference/hp/homotopy.hpp"

namespace ehd::reference::hp {

/// A discretisation at the end of its descent.
struct Discretised {
  std::vector<Resolved> floors;             ///< from the highest floor down; the last one is reported
  Fields fields;                            ///< of the last floor
  Observables seen;                         ///< extrapolated to floor 0 where the descent ended above 0
  std::map<Quantity, double> floor_errors;  ///< absolute errors of that extrapolation
  [[nodiscard]] const Resolved& last() const { return floors.back(); }
};

/// The size that an error of the quantity is compared with: |value|, and 1 where errors are absolute.
[[nodiscard]] double size_of(Quantity quantity, double value);

/// A quantity at a floor of the fluidity.
struct AtFloor {
  double floor, value;
};

/// The quantity at floor 0, and its absolute error.
struct AtZero {
  double value, error;
};

/// From two or three floors, the lowest first. Three floors of which the lowest is at most 1e-6 give the line through
/// the lower two and the bend delta ln delta; else the line alone counts. docs/certified-solver.md, section 4.
[[nodiscard]] AtZero carried_to_zero(const std::vector<AtFloor>& floors);

/// Extrapolates `done.seen` from the last floors to floor 0 and states the errors of this. Peaks keep their values and
/// get an error. Nothing changes where the descent reached 0. docs/certified-solver.md, section 4.
void carry_to_zero(const Problem& problem, const Wanted& wanted, Discretised& done);

}  // namespace ehd::reference::hp
