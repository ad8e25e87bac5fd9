// SPDX-License-Identifier: GPL-3.0-or-later
// `fast` from grid to grid on its final map: which grids, how exactly each is solved, and when they suffice.
#pragma once

#include "contact/solver.hpp"
#include "fast/mapped_judgement.hpp"
#include "fast/mapped_start.hpp"
#include "fast/run.hpp"

namespace ehd::fast {

/// Climbs until both films are known to the tolerance, or to the number of intervals requested. `from`: the solution of
/// a neighbouring problem. It is used only with full care.
[[nodiscard]] MappedClimb climb_mapped(Run& run, const Request& request, const Recipe& recipe, const Solution* from,
                                       Care care);

/// The tolerance is met.
[[nodiscard]] bool met(const MappedClimb& climb, const Request& request);

}  // namespace ehd::fast
