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

/// Most characters of a table's line: more do not fit into the terminals of most users.
inline constexpr std::size_t widest_table = 100;
/// Characters of the lines that aligned() makes of the rows.
[[nodiscard]] std::size_t table_width(const std::vector<std::vector<std::string>>& rows, const std::string& indent);
/// Rows of cells as aligned columns, two spaces between; the first `left` columns flush left, the others right.
[[nodiscard]] std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t left,
                                  const std::string& indent = "");
/// The same for a table of many columns. Columns that would make it too wide follow below, after an empty line; the
/// first `left` columns stand there again.
[[nodiscard]] std::string aligned_in_parts(const std::vector<std::vector<std::string>>& rows, std::size_t left,
                                           const std::string& indent = "");

/// A line of words, wrapped to the width of a table; what follows its first line stands behind `indent`.
[[nodiscard]] std::string wrapped(const std::string& line, const std::string& indent);
/// Each line of a text, wrapped; it goes on below its own indentation.
[[nodiscard]] std::string wrapped_lines(const std::string& text);

}  // namespace ehd
