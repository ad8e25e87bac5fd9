// SPDX-License-Identifier: GPL-3.0-or-later
// fast.uniform from grid to grid: which grids, how exactly each is solved, and when they suffice.
#pragma once

#include "fast/run.hpp"
#include "fast/uniform_judgement.hpp"

namespace ehd::fast {

/// Climbs until both films are known to the tolerance, or to the number of intervals requested.
[[nodiscard]] UniformClimb climb_uniform(Run& run, const Request& request);

}  // namespace ehd::fast
