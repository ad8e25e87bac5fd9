// SPDX-License-Identifier: GPL-3.0-or-later
// The text of --help in the width of a table.
#pragma once

#include <string>

namespace ehd::cli {

/// Lines at most 100 columns wide, as tables are. A paragraph with a longer line is filled anew; "Word: " or "Exit
/// code: " at the begin of a line begins a paragraph. A longer line of a list (it begins with blanks) goes on under its
/// second column.
[[nodiscard]] std::string help_page(const std::string& text);

}  // namespace ehd::cli
