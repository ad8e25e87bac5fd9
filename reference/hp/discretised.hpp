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

/// Extrapolates `done.seen` linearly from the last floors to floor 0, and states the errors of that. Peaks keep their
/// values and get an error. Nothing changes where the descent reached 0. docs/certified-solver.md, section 4.
void carry_to_zero(const Problem& problem, const Wanted& wanted, Discretised& done);

}  // namespace ehd::reference::hp
