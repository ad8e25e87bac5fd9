// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/atlas/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "contact/text.hpp"
#include "io/csv.hpp"
#include "io/file_text.hpp"
#include "io/tables.hpp"
#include "verification/atlas/columns.hpp"
#include "verification/atlas/digits.hpp"

namespace ehd::verification {

namespace {

constexpr std::string_view csv_comment =
    "# Line contacts in Hertz units: X = x/b, P = p/p_H, H = h R/b^2 (H_Moes = 8M/pi H); p_H_GPa with alpha = 2.2e-8 "
    "1/Pa; NAME_error is the uncertainty of the printed NAME, relative, of H_0 and X_spike absolute; wall_s in "
    "seconds; "
    "empty: not known. docs/atlas.md says more.";
constexpr double giga = 1e9;

std::map<std::string, KnownDigits> known_of(const AtlasRecord& record) {
  std::map<std::string, KnownDigits> known;
  if (!record.has_digits()) return known;
  for (const auto& [name, reading] : record.readings) {
    if (const auto digits = known_digits(reading.value, reading.error)) known[name] = *digits;
  }
  return known;
}

}  // namespace

std::string case_text_of(const AtlasPoint& point, const AtlasRecord& record, int version) {
  const ContactCase contact = point.contact();
  const Lubricant& lubricant = *contact.lubricant;
  std::string text = fmt::format(
      "# Written by `ehd atlas`: README.md in this folder.\n"
      "id = \"{}\"\nversion = {}\ntitle = \"{}\"\nsource = \"own\"\n\n"
      "[moes]\nM = {}\nL = {}\n\n"
      "[lubricant]\nviscosity = \"{}\"\ndensity = \"{}\"\n",
      point.id(), version, point.title(), plain(point.M), plain(point.L), to_string(lubricant.viscosity),
      to_string(lubricant.density));
  if (lubricant.alpha_per_Pa) text += fmt::format("alpha_per_Pa = {}\n", plain(*lubricant.alpha_per_Pa));
  if (lubricant.z) text += fmt::format("z = {}\np0_Pa = {}\n", plain(*lubricant.z), plain(lubricant.p0_Pa));
  text += fmt::format("\n[domain]\ninlet = {}\n",
                      std::holds_alternative<Flooded>(point.inlet) ? "\"flooded\"" : inlet_text(point.inlet));
  const auto known = known_of(record);
  for (const AtlasColumn& column : columns_of_values) {
    if (!column.quantity) continue;
    const auto at = known.find(std::string(column.name));
    const std::string heading = fmt::format("\n[[expect]]\nquantity = \"{}\"\n", to_string(*column.quantity));
    if (at != known.end()) {
      text += fmt::format("{}value = \"{}\"\nscaling = \"hertz\"\nuncertainty = {}\nkind = \"computed\"\n", heading,
                          at->second.text, at->second.relative);
    } else if (*column.quantity == Quantity::film_minimum || *column.quantity == Quantity::film_central) {
      text += heading + "status = \"waiting\"\n";
    }
  }
  return text;
}

const std::vector<std::string>& atlas_columns() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"id", "laws", "M", "L", "inlet", "p_H_GPa", "numerical_test", "status"};
    for (const AtlasColumn& column : columns_of_values) {
      all.emplace_back(column.name);
      all.push_back(column.error_name());
    }
    all.insert(all.end(), {"tolerance", "nodes", "wall_s"});
    return all;
  }();
  return names;
}

std::vector<std::string> atlas_row(const AtlasPoint& point, const AtlasRecord& record) {
  std::vector<std::string> cells{point.id(),
                                 std::string(to_string(point.laws)),
                                 plain(point.M),
                                 plain(point.L),
                                 inlet_text(point.inlet),
                                 point.L > 0 ? plain(point.hertz_pressure_Pa() / giga, 4) : "",
                                 point.numerical_test() ? "yes" : "no",
                                 std::string(to_string(record.status))};
  const auto known = known_of(record);
  for (const AtlasColumn& column : columns_of_values) {
    const auto at = known.find(std::string(column.name));
    cells.push_back(at == known.end() ? "" : at->second.text);
    cells.push_back(at == known.end() ? "" : column.absolute ? at->second.absolute : at->second.relative);
  }
  cells.push_back(plain(record.tolerance));
  cells.push_back(record.nodes > 0 ? std::to_string(record.nodes) : "");
  cells.push_back(plain(record.wall_s, 3));
  return cells;
}

AtlasRow row_of(const std::vector<std::string>& cells) {
  AtlasRow row;
  for (std::size_t i = 0; i < cells.size(); ++i) row[atlas_columns()[i]] = cells[i];
  return row;
}

std::string csv_text(const AtlasTable& table) {
  std::string text = std::string(csv_comment) + "\n" + csv_line(atlas_columns());
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (const auto& name : atlas_columns()) cells.push_back(row.at(name));
    text += csv_line(cells);
  }
  return text;
}

namespace {

/// A table of M and L for one law set and inlet: digits of H_min/H_cen.
std::string digits_block(const AtlasTable& table, const std::string& laws, const std::string& inlet) {
  const auto by_value = [](const std::string& a, const std::string& b) { return std::stod(a) < std::stod(b); };
  std::set<std::string, decltype(by_value)> all_M(by_value), all_L(by_value);
  std::map<std::pair<std::string, std::string>, std::string> cells;
  for (const auto& row : table.rows) {
    if (row.at("laws") != laws || row.at("inlet") != inlet) continue;
    all_M.insert(row.at("M"));
    all_L.insert(row.at("L"));
    const int minimum = count_digits(row.at("H_min")), central = count_digits(row.at("H_cen"));
    cells[{row.at("M"), row.at("L")}] = (minimum == 0 && central == 0 ? "-" : fmt::format("{}/{}", minimum, central)) +
                                        (row.at("numerical_test") == "yes" ? "*" : "");
  }
  std::vector<std::vector<std::string>> lines{{"M"}};
  for (const auto& L : all_L) lines[0].push_back("L = " + L);
  for (const auto& M : all_M) {
    lines.push_back({M});
    for (const auto& L : all_L) {
      const auto at = cells.find({M, L});
      lines.back().push_back(at == cells.end() ? "" : at->second);
    }
  }
  return fmt::format("\n{}, {}\n{}", laws, inlet == "flooded" ? inlet : "inlet cut at X = " + inlet,
                     aligned(lines, 0, "  "));
}

}  // namespace

std::string digits_text(const AtlasTable& table) {
  std::vector<std::pair<std::string, std::string>> blocks;  // laws, inlet
  for (const auto& row : table.rows) {
    const std::pair block{row.at("laws"), row.at("inlet")};
    if (std::find(blocks.begin(), blocks.end(), block) == blocks.end()) blocks.push_back(block);
  }
  std::string text =
      "Significant digits known of H_min/H_cen; -: not known to 1e-4; *: a numerical test, p_H above 4 GPa\n";
  for (const auto& [laws, inlet] : blocks) text += digits_block(table, laws, inlet);
  return text;
}

std::optional<std::string> atlas_text(const std::filesystem::path& file) {
  // The table of all points has 0.2 MiB, a case or a record 1 KiB.
  return text_if_there(file, {.name = "a file that `ehd atlas` writes", .most_bytes = 16 << 20});
}

}  // namespace ehd::verification
