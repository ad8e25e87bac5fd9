// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/csv.hpp"

#include <cmath>

#include "contact/text.hpp"

namespace ehd::verification {

namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

}  // namespace

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t c = 0; c < cells.size(); ++c) line += (c > 0 ? "," : "") + quoted(cells[c]);
  return line + "\n";
}

std::string csv_number(const std::optional<double>& value, int digits) {
  return value && std::isfinite(*value) ? plain(*value, digits) : "";
}

std::string status_cell(const std::optional<StopReason>& status) {
  return status ? std::string(to_string(*status)) : "not-run";
}

std::string dash(const std::optional<double>& value, int digits) { return value ? plain(*value, digits) : "-"; }

}  // namespace ehd::verification
