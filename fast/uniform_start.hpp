// SPDX-License-Identifier: GPL-3.0-or-later
// The last resort of fast.uniform where no cold start leads to a solution.
#pragma once

#include "fast/run.hpp"

namespace ehd::fast {

/// Goes from a mild contact (M at most 20, L at most 5) to the given one, in steps of one parameter, on the grid of n
/// intervals. A success goes to run.state.
[[nodiscard]] Attempt continuation(Run& run, int n, const Target& target);

}  // namespace ehd::fast
