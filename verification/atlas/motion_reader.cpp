// SPDX-License-Identifier: GPL-3.0-or-later
// kappa.csv and waviness.csv, written and read back: every cell is checked.
#include <fmt/format.h>

#include <sstream>

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/case_text.hpp"
#include "io/csv.hpp"
#include "verification/atlas/cells.hpp"
#include "verification/atlas/motion.hpp"

namespace ehd::verification {

namespace {

std::vector<std::string> columns_of(const MotionTable& table) {
  std::vector<std::string> columns{"id", "laws", "M", "L"};
  columns.insert(columns.end(), table.places.begin(), table.places.end());
  for (const std::string& value : table.values) columns.insert(columns.end(), {value, value + "_error"});
  return columns;
}

/// The first cell of a row that `ehd atlas --motion` would not write.
std::optional<WrongCell> wrong_motion_cell(const MotionTable& table, const AtlasRow& row) {
  if (!is_id(row.at("id"))) return WrongCell{"id", "is no id", allowed_in_id};
  if (!atlas_laws_from(row.at("laws"))) return WrongCell{"laws", "is unknown", "isoviscous, barus, roelands"};
  const auto wrong = [&](const std::string& column, const Allowed& allowed) -> std::optional<WrongCell> {
    const std::string what = wrong_with(row.at(column), allowed);
    if (what.empty()) return std::nullopt;
    return WrongCell{column, what, std::string(allowed.what)};
  };
  if (const auto bad = wrong("M", {.low = smallest_M, .high = largest_M, .what = "a number from 1e-3 to 1e6"}))
    return bad;
  if (const auto bad = wrong("L", {.low = 0, .high = largest_L, .what = "a number from 0 to 100"})) return bad;
  for (const std::string& place : table.places)
    if (const auto bad = wrong(place, {.low = 0, .what = "a number that is not negative"})) return bad;
  for (const std::string& value : table.values) {
    if (const auto bad = wrong(value, {.empty = true, .what = "a number, or nothing"})) return bad;
    const Allowed error{.empty = true, .low = 0, .low_itself = false, .what = "a positive number, or nothing"};
    if (const auto bad = wrong(value + "_error", error)) return bad;
    if (row.at(value).empty() != row.at(value + "_error").empty())
      return WrongCell{value + "_error", "is there or missing alone", "a number and its uncertainty, or neither"};
  }
  return std::nullopt;
}

}  // namespace

std::string motion_csv_text(const MotionTable& table, const std::vector<AtlasRow>& rows) {
  const std::vector<std::string> columns = columns_of(table);
  std::string text = std::string(table.comment) + "\n" + csv_line(columns);
  for (const AtlasRow& row : rows) {
    std::vector<std::string> cells;
    for (const std::string& column : columns) cells.push_back(row.at(column));
    text += csv_line(cells);
  }
  return text;
}

std::vector<AtlasRow> read_motion_table(const MotionTable& table, const std::filesystem::path& folder) {
  const auto file = folder / table.file;
  const auto text = atlas_text(file);
  const auto refuse = [&](int line, const std::string& what) {
    return CaseError(one_line(fmt::format("{}{}: {}", file.string(), line > 0 ? fmt::format(":{}", line) : "", what)));
  };
  if (!text) throw refuse(0, "there is no such file; required is the table that `ehd atlas --motion` writes");
  const std::vector<std::string> columns = columns_of(table);
  std::vector<AtlasRow> rows;
  std::istringstream lines(*text);
  bool header = false;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    const auto cells = cells_of(line);
    if (cells.size() != columns.size() || (!header && cells != columns))
      throw refuse(
          number, shortened(line, most_quoted) + ": wrong columns; allowed are those that `ehd atlas --motion` writes");
    if (!std::exchange(header, true)) continue;
    AtlasRow row;
    for (std::size_t i = 0; i < cells.size(); ++i) row[columns[i]] = cells[i];
    if (const auto bad = wrong_motion_cell(table, row))
      throw refuse(number, fmt::format("{} = {}: {}; allowed is {}", bad->column,
                                       shortened(row.at(bad->column), most_quoted), bad->what, bad->allowed));
    rows.push_back(std::move(row));
  }
  if (!header)
    throw refuse(std::max(number, 1), "has no header; required is the table that `ehd atlas --motion` writes");
  return rows;
}

}  // namespace ehd::verification
