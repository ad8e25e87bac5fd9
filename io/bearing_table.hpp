// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of one bearing side by side, for a terminal.
#pragma once

#include <string>
#include <vector>

#include "io/bearing_summary.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd {

struct BearingView {
  bool details = false;  ///< also costs, 2 x 2 stiffness, fitted lines, and notes on how the laws were made
};

/// One case: the summary of its laws, then the laws side by side over the rollers, and notes.
[[nodiscard]] std::string human_table(const Case& bearing_case, const std::vector<BearingResult>& results,
                                      const BearingView& view = {});

}  // namespace ehd
