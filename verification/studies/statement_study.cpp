// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/statement_study.hpp"

#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "bearing/law_table.hpp"
#include "contact/oil_laws.hpp"
#include "contact/text.hpp"
#include "io/json.hpp"
#include "io/tables.hpp"
#include "verification/studies/paper_statements.hpp"

namespace ehd::verification {

namespace {

/// A choice: how it changes a case, and which balance of a result it judges.
struct Choice {
  std::string factor, value;
  std::function<void(BearingCase&)> change;
  bool cut = false;         ///< the variant of ehd-linear that lets go at delta = 0
  bool of_the_fit = false;  ///< it changes the straight line alone
  bearing::Law dry = bearing::Law::hertz;
};

constexpr const char* two_choices = "two choices";

std::string number(double value, const char* unit) { return plain(value, 4) + " " + unit; }

std::vector<Choice> choices(const BearingCase& body) {
  std::vector<Choice> all{{"as the case", "", [](BearingCase&) {}}};
  const auto add = [&all](std::string factor, std::string value, std::function<void(BearingCase&)> change) {
    all.push_back({std::move(factor), std::move(value), std::move(change)});
  };
  const double eta = body.lubricant->viscosity_Pa_s;
  for (const double share : {0.316, 0.5, 2.0, 3.16})
    add("viscosity", number(eta * share, "Pa s"),
        [eta, share](BearingCase& one) { one.lubricant->viscosity_Pa_s = eta * share; });
  if (const auto alpha = body.lubricant->lubricant.alpha_per_Pa)
    for (const double share : {0.5, 0.75, 1.25, 1.75})
      add("alpha", number(*alpha * share, "1/Pa"),
          [alpha, share](BearingCase& one) { one.lubricant->lubricant.alpha_per_Pa = *alpha * share; });
  else if (const auto z = body.lubricant->lubricant.z)  // alpha follows from it
    for (const double share : {0.5, 0.75, 1.25, 1.75})
      add("alpha", "z = " + plain(*z * share, 4),
          [z, share](BearingCase& one) { one.lubricant->lubricant.z = *z * share; });
  for (const DensityLawRow& row : density_laws())
    if (row.law != body.lubricant->lubricant.density)
      add("density", std::string(row.name),
          [law = row.law](BearingCase& one) { one.lubricant->lubricant.density = law; });
  // The dry law that EHD is compared with. The datum stays the case's.
  for (const bearing::Law law : laws_of(bearing::Laws::dry_without_ring_thickness))
    if (law != bearing::Law::hertz) {
      add("K_Hertz", "law " + std::string(to_string(law)), [](BearingCase&) {});
      all.back().dry = law;
    }
  add("fit direction", "delta over f", [](BearingCase& one) { one.fit.of = bearing::FitOf::approach; });
  all.back().of_the_fit = true;
  if (const auto range = body.fit.load_N) {
    for (const double share : {0.15, 0.5, 2.0}) {
      add("fit range", fmt::format("{} to {}", number(range->first * share, "N"), number(range->second, "N")),
          [range, share](BearingCase& one) {
            one.fit.load_N = std::pair{range->first * share, range->second};
          });
      all.back().of_the_fit = true;
    }
    for (const double share : {0.2, 0.5, 1.2})
      add("datum", "palmgren at " + number(range->second * share, "N"),
          [range, share](BearingCase& one) { one.datum = PalmgrenDatum{range->second * share}; });
  }
  add("datum", "lundberg, x_0 = l", [](BearingCase& one) { one.datum = LundbergDatum{}; });
  const double radius_m = bearing::reduced_radius_m(body.geometry, bearing::Raceway::inner);
  add("datum", "x_0 = R_i = " + number(1e3 * radius_m, "mm"),
      [radius_m](BearingCase& one) { one.datum = LengthDatum{radius_m}; });
  add("datum", "x_0 = R_i/4", [radius_m](BearingCase& one) { one.datum = LengthDatum{radius_m / 4}; });
  add("datum", "x_0 = 20 mm", [](BearingCase& one) { one.datum = LengthDatum{0.020}; });
  const bool inner_turns = body.operation.inner_speed_rpm != 0;
  add("rotating ring", inner_turns ? "outer" : "inner",
      [](BearingCase& one) { std::swap(one.operation.inner_speed_rpm, one.operation.outer_speed_rpm); });
  add("unloading", "let go at delta = 0", [](BearingCase&) {});
  all.back().cut = true;
  for (const double length_m : {0.018, 0.122})
    if (length_m != body.geometry.length_m)
      add("length", number(length_m, "m"), [length_m](BearingCase& one) { one.geometry.length_m = length_m; });
  struct Pair {
    double viscosity, length_m, radii;  // times the case's; 0: the case's own; x_0/R_i
  };
  for (const Pair& pair : {Pair{3.16, 0, 1}, {2, 0, 0.125}, {1, 0.018, 0.25}}) {
    const double x0_m = radius_m * pair.radii;
    add(two_choices,
        fmt::format("{}, x_0 = {}",
                    pair.length_m > 0 ? "length " + number(pair.length_m, "m")
                                      : "viscosity " + number(eta * pair.viscosity, "Pa s"),
                    number(1e3 * x0_m, "mm")),
        [pair, eta, x0_m](BearingCase& one) {
          one.lubricant->viscosity_Pa_s = eta * pair.viscosity;
          if (pair.length_m > 0) one.geometry.length_m = pair.length_m;
          one.datum = LengthDatum{x0_m};
        });
  }
  return all;
}

/// The balance of a result's variant, in the place of the result's own.
std::optional<BearingResult> cut_of(const BearingResult& result) {
  if (result.variants.empty()) return std::nullopt;
  BearingResult cut = result;
  cut.rollers = result.variants.front().rollers;
  cut.displacement_m = result.variants.front().displacement_m;
  return cut;
}

StudyRow judged(const Choice& choice, const std::vector<Case>& cases, bearing::Law law, ContactMemory& memory) {
  StudyRow row{choice.factor, choice.value, law, {}, "", {}};
  std::vector<Case> changed = cases;
  std::vector<ClearanceComparison> clearances;
  for (Case& one : changed) {
    auto& body = std::get<BearingCase>(one.body);
    choice.change(body);
    const auto results = run_bearing(one, {.laws = {choice.dry, law}, .explicitly = true, .films = choice.cut}, memory);
    const BearingResult *dry = balance_by(choice.dry, results), *film = balance_by(law, results);
    std::optional<BearingResult> cut;
    if (choice.cut && film) cut = cut_of(*film);
    if (!dry || !film || (choice.cut && !cut)) {
      row.why = !results.empty() && !results.back().why.empty() ? results.back().why : "no balance";
      return row;
    }
    clearances.push_back({body.geometry.clearance_m, *dry, cut.value_or(*film)});
  }
  row.statements = judge_paper_statements(clearances);
  if (row.statements.empty()) row.why = "no balance at a clearance";
  if (choice.factor != "datum" && choice.factor != two_choices && !choice.cut && !row.statements.empty())
    row.scan = scan_datum(changed, law, memory, bearing::Form::plane, choice.dry);
  return row;
}

/// A value of a statement in per cent.
std::string percent_of(const PaperStatement& one, std::string_view name) {
  return signed_fixed(100 * one.value(name).value(), 1);
}

std::string name_of(const StudyRow& row) { return row.value.empty() ? row.factor : row.factor + " " + row.value; }

}  // namespace

std::vector<StudyRow> study_statements(const std::vector<Case>& cases, ContactMemory& memory,
                                       const std::function<void(std::size_t done, std::size_t all)>& progress) {
  std::vector<StudyRow> rows;
  if (!differ_only_in_clearance(cases) || cases.size() < 3) return rows;
  const auto& body = std::get<BearingCase>(cases.front().body);
  if (!body.lubricant) return rows;
  const std::vector<Choice> all = choices(body);
  // The full relation has no fit, and does not let go at a finite force.
  const auto counts = [](bearing::Law law, const Choice& choice) {
    return law != bearing::Law::ehd || !(choice.cut || choice.of_the_fit);
  };
  std::size_t wanted = 0;
  for (const bearing::Law law : film_laws())
    for (const Choice& choice : all) wanted += counts(law, choice) ? 1 : 0;
  for (const bearing::Law law : film_laws())
    for (const Choice& choice : all) {
      if (!counts(law, choice)) continue;
      rows.push_back(judged(choice, cases, law, memory));
      if (progress) progress(rows.size(), wanted);
    }
  return rows;
}

std::vector<StudySummary> summarise(const std::vector<StudyRow>& rows) {
  std::vector<StudySummary> summaries;
  for (const bearing::Law law : film_laws())
    for (const char letter : statement_letters) {
      StudySummary summary{.law = law, .letter = letter};
      std::string yes, no;
      for (const StudyRow& row : rows) {
        const PaperStatement* const one = find_statement(row.statements, letter);
        if (row.law != law || !one || row.factor == two_choices) continue;
        ++summary.of;
        summary.holds += one->holds;
        const auto add = [&row](std::string& list) { list += (list.empty() ? "" : "; ") + name_of(row); };
        add(one->holds ? yes : no);
        if (one->holds_at_top.value_or(one->holds) != one->holds) add(summary.at_top_alone);
      }
      if (summary.of == 0) continue;
      if (summary.holds > 0 && summary.holds < summary.of)
        summary.exceptions = 2 * summary.holds >= summary.of ? "not with " + no : "only with " + yes;
      summaries.push_back(std::move(summary));
    }
  return summaries;
}

Json to_json(const std::vector<StudyRow>& rows) {
  Json json = {{"rows", Json::array()}, {"summary", Json::array()}};
  const auto list = [](const DatumScan::Ranges& of) {
    Json all = Json::array();
    for (const auto& [low, high] : of) all.push_back({low, high});
    return all;
  };
  for (const StudyRow& row : rows) {
    Json one = {
        {"factor", row.factor}, {"value", row.value}, {"law", to_string(row.law)}, {"statements", Json::array()}};
    for (const PaperStatement& judged : row.statements) {
      Json values = Json::object();
      for (const auto& [name, value] : judged.values) put(values, name.c_str(), value);
      one["statements"].push_back({{"letter", std::string(1, judged.letter)},
                                   {"holds", judged.holds},
                                   {"values", std::move(values)},
                                   {"numbers", judged.numbers}});
      if (judged.holds_at_top) one["statements"].back()["holds_at_psi_0"] = *judged.holds_at_top;
    }
    if (!row.why.empty()) one["why"] = row.why;
    if (row.scan) {
      const DatumScan& scan = *row.scan;
      put(one, "x0_lowest_m", scan.lowest_m);
      put(one, "x0_highest_m", scan.highest_m);
      one["x0_a_m"] = list(scan.a_m);
      one["x0_b_m"] = list(scan.b_m);
      one["x0_c_m"] = list(scan.c_m);
      one["x0_d_m"] = list(scan.d_m);
      one["x0_abc_m"] = list(scan.abc_m);
      one["x0_all_hold_m"] = list(scan.all_hold_m);
      one["x0_b_at_psi_0_m"] = list(scan.b_at_top_m);
      one["x0_c_at_psi_0_m"] = list(scan.c_at_top_m);
      one["x0_sign_of_a_m"] = list(scan.at_top_m);
      one["x0_all_hold_mildly_m"] = list(scan.all_hold_mildly_m);
    }
    json["rows"].push_back(std::move(one));
  }
  for (const StudySummary& one : summarise(rows))
    json["summary"].push_back({{"law", to_string(one.law)},
                               {"letter", std::string(1, one.letter)},
                               {"holds", one.holds},
                               {"of", one.of},
                               {"exceptions", one.exceptions},
                               {"at_psi_0_alone", one.at_top_alone}});
  return json;
}

namespace {

std::vector<std::string> study_cells(const StudyRow& row) {
  if (row.statements.empty())
    return {row.factor, row.value, row.why, "", "", "", "", "", "", "", "", "", "", "", "", ""};
  const auto range = [&](DatumScan::Ranges DatumScan::*which) {
    return row.scan ? words_of(*row.scan, (*row.scan).*which, 2) : std::string();
  };
  const auto of = [&](char letter) -> const PaperStatement& { return *find_statement(row.statements, letter); };
  const auto share = [](const PaperStatement& one) { return fixed(100 * one.value("apart").value(), 1); };
  const PaperStatement &a = of('a'), &b = of('b'), &c = of('c');
  return {row.factor,
          row.value,
          cell_of(a),
          percent_of(a, "change"),
          share(a),
          cell_of(b),
          fmt::format("{}..{}", percent_of(b, "least"), percent_of(b, "most")),
          percent_of(b, "loaded"),
          cell_of(c),
          percent_of(c, "middle"),
          share(c),
          percent_of(c, "largest"),
          cell_of(of('d')),
          range(&DatumScan::all_hold_m),
          range(&DatumScan::at_top_m),
          range(&DatumScan::all_hold_mildly_m)};
}

}  // namespace

std::string human_study(const std::vector<StudyRow>& rows) {
  std::string text;
  for (const bearing::Law law : film_laws()) {
    std::vector<std::vector<std::string>> table{{"changed", "to", "(a)", "f_i(0) %", "apart %", "(b)", "delta_i(0) %",
                                                 "loaded %", "(c)", "middle %", "apart %", "largest %", "(d)",
                                                 "x_0 for (a)..(d)", "at psi = 0 alone", "with a mild (c)"}};
    for (const StudyRow& row : rows)
      if (row.law == law) table.push_back(study_cells(row));
    if (table.size() == 1) continue;
    text += text.empty() ? "" : "\n";
    text +=
        wrapped(fmt::format("dry law against {}: changes of the roller load and of delta_i at psi = 0; \"apart\" and "
                            "\"loaded\" are the worst of the distribution",
                            to_string(law)),
                "  ");
    text += aligned_in_parts(table, 2, "  ");
  }
  text += "\n";
  for (const StudySummary& one : summarise(rows))
    text += wrapped(fmt::format("  ({}), {}: holds in {} of {}{}{}{}{}", one.letter, to_string(one.law), one.holds,
                                one.of, one.exceptions.empty() ? "" : ", ", one.exceptions,
                                one.at_top_alone.empty() ? "" : "; at psi = 0 alone also with ", one.at_top_alone),
                    "      ");
  return text;
}

}  // namespace ehd::verification
