// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/csv.hpp"

#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>

#include "contact/text.hpp"

namespace ehd {

namespace {

constexpr std::string_view begins_a_formula = "=+-@";

bool is_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  return read.ec == std::errc() && read.ptr == text.data() + text.size();
}

}  // namespace

std::string csv_cell(const std::string& text) {
  const bool formula = !text.empty() && begins_a_formula.find(text.front()) != std::string_view::npos;
  std::string cell = (formula && !is_number(text) ? "'" : "") + text;
  if (cell.find_first_of(",\"\n\r") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? std::string("\"\"") : std::string{c};
  return quoted + "\"";
}

std::string csv_number(const std::optional<double>& value, int digits) {
  return value && std::isfinite(*value) ? plain(*value, digits) : "";
}

std::string csv_comment(const std::string& text) {
  std::string line = "# ";
  for (const char c : one_line(text)) {
    if (line.back() == ',' && begins_a_formula.find(c) != std::string_view::npos) line += ' ';
    line += c;
  }
  return line + "\n";
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t c = 0; c < cells.size(); ++c) line += (c > 0 ? "," : "") + csv_cell(cells[c]);
  return line + "\n";
}

}  // namespace ehd
