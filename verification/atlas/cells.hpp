// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of the atlas' tables, as their readers check them.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace ehd::verification {

inline constexpr std::size_t most_quoted = 60;  ///< bytes of a line or cell that a message repeats

/// At the commas; no cell of the atlas is quoted.
[[nodiscard]] std::vector<std::string> cells_of(const std::string& line);

/// The values that a cell may have.
struct Allowed {
  bool empty = false;
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool low_itself = true;
  std::string_view what = "a number";
};

/// The fault of a number's cell; empty where there is none.
[[nodiscard]] std::string wrong_with(const std::string& cell, const Allowed& allowed);

/// A cell that `ehd atlas` would not write.
struct WrongCell {
  std::string column, what, allowed;
};

}  // namespace ehd::verification
