// SPDX-License-Identifier: GPL-3.0-or-later
// The errors of one discretisation from its difference to a second one. docs/certified-solver.md, section 6.
#pragma once

#include "reference/hp/discretised.hpp"

namespace ehd::reference::hp {

/// The solution of `first` with an error for each quantity. `rounding` is that of its films, relative. `guide` is null,
/// or the discretisation by which `first` was laid out; where that has more intervals, the difference to it counts too.
/// The cost, the list of grids and the status are left to the caller; the status is `converged`.
[[nodiscard]] Solution report(const Problem& problem, const Discretised& first, const Discretised& second,
                              const Discretised* guide, double rounding);

}  // namespace ehd::reference::hp
