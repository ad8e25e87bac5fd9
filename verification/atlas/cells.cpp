// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/atlas/cells.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace ehd::verification {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

/// The fault of a number's cell; empty where there is none.
std::string wrong_with(const std::string& cell, const Allowed& allowed) {
  if (cell.empty()) return allowed.empty ? "" : "is missing";
  double value = 0;
  const auto read = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (read.ptr != cell.data() + cell.size() || read.ec == std::errc::invalid_argument) return "is not a number";
  if (read.ec != std::errc()) return "is out of range";
  if (!std::isfinite(value)) return "is not finite";
  if (value != 0 && !std::isnormal(value)) return "is out of range";  // std::stod refuses it later
  const bool low_enough = allowed.low_itself ? value >= allowed.low : value > allowed.low;
  return low_enough && value <= allowed.high ? "" : "is out of range";
}

}  // namespace ehd::verification
