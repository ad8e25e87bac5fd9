// SPDX-License-Identifier: GPL-3.0-or-later
// All ways of `fast` to a solution, the usual one first.
#pragma once

#include "contact/solver.hpp"
#include "fast/mapped_judgement.hpp"
#include "fast/mapped_start.hpp"
#include "fast/run.hpp"

namespace ehd::fast {

/// The time limit starts here.
[[nodiscard]] Run begin_mapped(const Problem& problem, const Request& request, Workspace& workspace);

/// The first complete climb of all ways to begin, or the one that came farthest. `care`: of its maps; `from`: the
/// solution of a neighbouring problem, tried first; `neighbours`: milder problems that were begun on the way here.
[[nodiscard]] MappedClimb best_climb(Run& run, const Request& request, Care care, const Solution* from = nullptr,
                                     int neighbours = 0);

}  // namespace ehd::fast
