// SPDX-License-Identifier: GPL-3.0-or-later
// Cells and lines of the CSV files that the program writes.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ehd {

/// A cell with a comma, a quotation mark or a line feed is quoted. A text that begins with = + - or @ and is no number
/// gets a leading apostrophe, so that no spreadsheet runs it.
[[nodiscard]] std::string csv_cell(const std::string& text);

/// A number; empty where it is unknown or not finite.
[[nodiscard]] std::string csv_number(const std::optional<double>& value, int digits = 10);

/// A line of comment before the header: "# text". A spreadsheet cuts it into cells as well, and runs none of them.
[[nodiscard]] std::string csv_comment(const std::string& text);

/// Cells separated by commas, and a line feed.
[[nodiscard]] std::string csv_line(const std::vector<std::string>& cells);

}  // namespace ehd
