// SPDX-License-Identifier: GPL-3.0-or-later
// atlas.csv read back: every cell is checked.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/case_text.hpp"
#include "io/contact_json.hpp"
#include "io/csv.hpp"
#include "verification/atlas/cells.hpp"
#include "verification/atlas/columns.hpp"
#include "verification/atlas/table.hpp"

namespace ehd::verification {

namespace {

std::string header_text() {
  const std::string line = csv_line(atlas_columns());
  return line.substr(0, line.size() - 1);  // without the line feed
}

Allowed allowed_in(std::string_view column) {
  if (column == "M") return {.low = smallest_M, .high = largest_M, .what = "a number from 1e-3 to 1e6"};
  if (column == "L") return {.low = 0, .high = largest_L, .what = "a number from 0 to 100"};
  const Allowed positive{.empty = true, .low = 0, .low_itself = false, .what = "a positive number, or nothing"};
  if (column == "X_exit" || column == "H_0" || column == "X_spike")
    return {.empty = true, .what = "a number, or nothing"};
  if (column == "tolerance") return {.low = 0, .low_itself = false, .what = "a positive number"};
  if (column == "nodes" || column == "wall_s") return {.low = 0, .what = "a number that is not negative"};
  return positive;  // films, forces, pressures, and every uncertainty
}

bool is_text(std::string_view column) {
  return column == "id" || column == "laws" || column == "inlet" || column == "numerical_test" || column == "status";
}

/// The first cell of a row that `ehd atlas` would not write.
std::optional<WrongCell> wrong_cell(const AtlasRow& row) {
  for (const std::string& column : atlas_columns()) {
    if (is_text(column)) continue;
    const Allowed allowed = allowed_in(column);
    if (const std::string what = wrong_with(row.at(column), allowed); !what.empty())
      return WrongCell{column, what, std::string(allowed.what)};
  }
  for (const AtlasColumn& column : columns_of_values) {
    const std::string value(column.name), error = column.error_name();
    if (row.at(value).empty() != row.at(error).empty())
      return WrongCell{error, row.at(error).empty() ? "is missing" : "has no value before it",
                       "a number and its uncertainty, or neither"};
  }
  if (const std::string& id = row.at("id"); !is_id(id)) return WrongCell{"id", "is no id", allowed_in_id};
  if (!stop_reason_from(row.at("status")))
    return WrongCell{"status", "is unknown", "converged, tolerance-not-met, under-resolved, limit-reached, diverged"};
  const auto laws = atlas_laws_from(row.at("laws"));
  if (!laws) return WrongCell{"laws", "is unknown", "isoviscous, barus, roelands"};
  if ((*laws == AtlasLaws::isoviscous) != (std::stod(row.at("L")) == 0))
    return WrongCell{"laws", "does not go with L = " + row.at("L"), "isoviscous at L = 0, barus or roelands above"};
  const Allowed cut{.high = -1, .what = "flooded, or a number up to -1"};
  const std::string& inlet = row.at("inlet");
  if (inlet != "flooded" && !wrong_with(inlet, cut).empty())
    return WrongCell{"inlet", "is unknown", std::string(cut.what)};
  if (const std::string& test = row.at("numerical_test"); test != "yes" && test != "no")
    return WrongCell{"numerical_test", "is unknown", "yes, no"};
  return std::nullopt;
}

}  // namespace

AtlasTable read_atlas_table(const std::filesystem::path& csv) {
  const auto text = atlas_text(csv);
  const auto refuse = [&](int line, const std::string& what) {
    return CaseError(one_line(fmt::format("{}{}: {}", csv.string(), line > 0 ? fmt::format(":{}", line) : "", what)));
  };
  if (!text) throw refuse(0, "there is no such file; required is the table that `ehd atlas` writes");
  AtlasTable table;
  std::istringstream lines(*text);
  int number = 0;
  bool header = false;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    const auto cells = cells_of(line);
    if (!header) {
      if (cells != atlas_columns())
        throw refuse(number, shortened(line, most_quoted) +
                                 ": other columns; allowed is what `ehd atlas` writes: " + header_text());
      header = true;
      continue;
    }
    if (cells.size() != atlas_columns().size())
      throw refuse(number, fmt::format("{}: has {} cells; allowed is {}", shortened(line, most_quoted), cells.size(),
                                       atlas_columns().size()));
    auto row = row_of(cells);
    if (const auto wrong = wrong_cell(row))
      throw refuse(number, fmt::format("{} = {}: {}; allowed is {}", wrong->column,
                                       shortened(row.at(wrong->column), most_quoted), wrong->what, wrong->allowed));
    table.rows.push_back(std::move(row));
  }
  if (!header) throw refuse(std::max(number, 1), "has no header; required is the table that `ehd atlas` writes");
  return table;
}

}  // namespace ehd::verification
