// SPDX-License-Identifier: GPL-3.0-or-later
// Many contacts at once, one solve a thread.
#pragma once

#include <vector>

#include "workflow/registry.hpp"

namespace ehd {

/// The solutions in the order of the problems. `threads`: 0 takes one per core. Solves are independent of each other:
/// only the times in a record depend on the number of threads, unless a time limit ends a solve. What a solver throws
/// is thrown again.
[[nodiscard]] std::vector<Solution> solve_all(const RegisteredSolver& solver, const std::vector<Problem>& problems,
                                              const Request& request, unsigned threads);

/// The same status, observables (values, places, errors), fields, grids and counts, bit for bit; times are left out.
[[nodiscard]] bool identical(const Solution& one, const Solution& other);

}  // namespace ehd
