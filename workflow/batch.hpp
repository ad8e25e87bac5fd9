// SPDX-License-Identifier: GPL-3.0-or-later
// Many contacts at once, one solve a thread.
#pragma once

#include <vector>

#include "workflow/registry.hpp"

namespace ehd {

/// The solutions in the order of the problems. Work is handed out as threads come free (0: as many as there are cores);
/// no solve knows of another, so that nothing but the times in a record depends on the number of threads. What a solver
/// throws is thrown again. Where a time limit ends a solve, that is no longer so.
[[nodiscard]] std::vector<Solution> solve_all(const RegisteredSolver& solver, const std::vector<Problem>& problems,
                                              const Request& request, unsigned threads);

/// The same status, observables (values, places, errors), fields, grids and counts, bit for bit; times are left out.
[[nodiscard]] bool identical(const Solution& one, const Solution& other);

}  // namespace ehd
