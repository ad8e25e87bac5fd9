// SPDX-License-Identifier: GPL-3.0-or-later
// Results as people read them on a terminal.
#pragma once

#include <string>
#include <vector>

#include "workflow/contact_run.hpp"

namespace ehd {

/// The result of one contact, its status, the film formulas beside it, and the cost. `styled`: with bold and colour.
[[nodiscard]] std::string human_table(const ContactRun& run, const std::string& title, bool styled);
[[nodiscard]] std::string human_plan(const Plan& plan);

/// Rows of cells as aligned columns, two spaces between; the first `left` columns flush left, the others right.
[[nodiscard]] std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t left,
                                  const std::string& indent = "");

}  // namespace ehd
