// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/error_budget.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "contact/text.hpp"
#include "io/json.hpp"
#include "io/tables.hpp"
#include "verification/studies/paper_statements.hpp"

namespace ehd::verification {

namespace {

/// The result by `ehd`: from the results if present, else balanced on the stored curve.
BearingResult full_relation(const Case& bearing_case, const std::vector<BearingResult>& results, bearing::Form form,
                            ContactMemory& memory) {
  for (const BearingResult& result : results)
    if (result.law == bearing::Law::ehd) return result;
  auto made =
      run_bearing(bearing_case, {.laws = {bearing::Law::ehd}, .explicitly = true, .films = true, .form = form}, memory);
  return made.empty() ? BearingResult{} : std::move(made.front());
}

/// The numbers of a row by their keys in the JSON.
std::vector<std::pair<const char*, std::optional<double>>> numbers_of(const BudgetRow& row) {
  return {{"displacement_m", row.displacement_m},
          {"displacement_lateral_m", row.displacement_lateral_m},
          {"largest_force_N", row.largest_force_N},
          {"any_force_N", row.any_force_N},
          {"smallest_film_relative", row.smallest_film}};
}

}  // namespace

std::vector<BudgetRow> budget_of(const Case& bearing_case, const std::vector<BearingResult>& results, bearing::Law law,
                                 ContactMemory& memory) {
  const BearingResult* const result = balance_by(law, results);
  if (!result || !needs_film(law) || !result->curve || !result->datum_m) return {};
  const auto& body = std::get<BearingCase>(bearing_case.body);
  const auto again = [&](const Case& one, bearing::Law by) {
    return run_bearing(one, {.laws = {by}, .explicitly = true, .films = true, .form = result->form}, memory);
  };
  std::vector<BudgetRow> rows =
      numerical_budget(body, *result, full_relation(bearing_case, results, result->form, memory));
  if (rows.empty()) return {};

  // The datum, which is a choice: the differences that other data make.
  const std::pair<const char*, Datum> data[] = {
      {"palmgren", PalmgrenDatum{}},
      {"lundberg", LundbergDatum{}},
      {"x_0 twice that of the inner raceway", LengthDatum{2 * result->datum_m->inner}}};
  for (const auto& [name, datum] : data) {
    const bool own = datum.index() == body.datum.index() && !std::holds_alternative<LengthDatum>(datum);
    if (own) continue;
    Case other = bearing_case;
    std::get<BearingCase>(other.body).datum = datum;
    const auto there = again(other, law);
    if (const BearingResult* const moved = balance_by(law, there)) {
      BudgetRow row = difference(*moved, *result);
      row.source = datum_source;
      row.of = name;
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::optional<BearingErrors> numerical_errors(std::vector<BudgetRow> budget) {
  std::erase_if(budget, [](const BudgetRow& row) { return row.source == datum_source; });
  return sum_of(budget);
}

std::optional<std::string> why_no_budget(const Case& bearing_case, const std::vector<BearingResult>& results,
                                         bearing::Law law, ContactMemory& memory) {
  const BearingResult* const result = balance_by(law, results);
  if (!result || !needs_film(law) || !budget_of(bearing_case, results, law, memory).empty()) return std::nullopt;
  const BearingResult full = full_relation(bearing_case, results, result->form, memory);
  if (!full.rollers.empty()) return "no curve of its films could be made";
  return "the distance from the law ehd is not known, because that has no balance (" + full.why + ")";
}

Json to_json(const std::vector<BudgetRow>& rows) {
  Json json = Json::array();
  for (const BudgetRow& row : rows) {
    Json one = {{"source", row.source}, {"of", row.of}, {"kind", row.bound ? "bound" : "difference"}};
    std::vector<std::string> unknown;
    for (const auto& [key, number] : numbers_of(row)) {
      put(one, key, number);
      if (!std::isfinite(number.value_or(0))) unknown.emplace_back(key);
    }
    if (!unknown.empty()) one["unknown"] = unknown;
    json.push_back(std::move(one));
  }
  return json;
}

std::string human_budget(const std::vector<BudgetRow>& rows) {
  std::vector<std::vector<std::string>> table{{"error", "of", "delta um", "largest N", "any N", "film %"}};
  for (const BudgetRow& row : rows) {
    const auto cell = [&](double value, int digits) {
      if (!std::isfinite(value)) return std::string("unknown");
      return row.bound && value == 0 ? "-" : (row.bound ? "< " : "") + plain(value, digits);
    };
    table.push_back({row.source, row.of, cell(1e6 * row.displacement_m, 2), cell(row.largest_force_N, 3),
                     cell(row.any_force_N, 3), row.smallest_film ? cell(100 * *row.smallest_film, 2) : "-"});
  }
  return aligned(table, 2, "  ");
}

}  // namespace ehd::verification
