// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of one bearing side by side, for a terminal.
#pragma once

#include <string>
#include <vector>

#include "workflow/bearing_run.hpp"

namespace ehd {

/// One case: its laws side by side over the rollers, fits, notes.
[[nodiscard]] std::string human_table(const Case& bearing_case, const std::vector<BearingResult>& results);

}  // namespace ehd
