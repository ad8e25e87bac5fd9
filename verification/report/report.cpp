// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>
#include <vector>

#include "bearing/law_table.hpp"
#include "contact/text.hpp"
#include "verification/report/ladder.hpp"

namespace ehd::report {

namespace {

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
  throw ReportError(one_line(where + ": " + what));
}

View required(const View& object, const std::string& key, const std::string& allowed) {
  const View value = object[key];
  if (!value.exists()) refuse(object.path() + ": " + key, "is missing; required is " + allowed);
  return value;
}

void require_verdict(const View& judged) {
  const std::string allowed = "pass, fail or inconclusive";
  const View value = required(judged, "verdict", allowed);
  const std::string verdict = value.text();
  constexpr std::size_t shown = 60;
  if (verdict != "pass" && verdict != "fail" && verdict != "inconclusive")
    refuse(value.path(), fmt::format("\"{}\" is no verdict; required is {}", shortened(verdict, shown), allowed));
}

void require_rung(const View& row) {
  const std::string allowed = fmt::format("an integer from 0 to {}", rungs - 1);
  const View value = required(row, "rung", allowed);
  const double rung = value.number().value_or(-1);
  for (int one = 0; one < rungs; ++one)
    if (rung == one) return;
  refuse(value.path(), value.cell() + " is no rung; required is " + allowed);
}

/// Without this check, a page that lost its claims would look like a page on which no claim fails.
void require_whole(const View& results) {
  const std::string written = "what ehd verify --output wrote";
  const View claims = required(results, "claims", written);
  (void)required(results, "summary", written).members();
  (void)required(results, "provenance", written).members();
  for (const View& claim : claims.list()) {
    require_verdict(claim);
    require_rung(claim);
  }
  for (const View& row : results.list("skipped")) require_rung(row);
  for (const View& row : results.list("rungs")) require_rung(row);
}

}  // namespace

bool stands(const View& claim) {
  const std::string verdict = claim.text("verdict");
  return verdict == "pass" || (verdict == "inconclusive" && !claim.text("accepted").empty());
}

std::optional<double> digits_of(const std::optional<double>& relative_error) {
  constexpr double most = 16;
  if (!relative_error || !std::isfinite(*relative_error)) return std::nullopt;
  return std::clamp(-std::log10(std::abs(*relative_error)), 0.0, most);
}

std::string digits_text(double digits) {
  constexpr double rounding = 1e-9;  // -log10 of a power of ten may be 4 - 1e-16
  return plain(std::floor(10 * digits + rounding) / 10, 3);
}

std::string report_html(const Documents& documents) {
  const View results(documents.results, "results.json"), bench(documents.bench, "bench.json"),
      stress(documents.stress, "stress.json");
  require_whole(results);
  for (const View& part : stress.list("parts")) require_verdict(part);
  Page page;
  add_summary(page, results, bench, stress);
  add_claims(page, results);
  add_contacts(page, results);
  add_convergence(page, results);
  add_work_precision(page, bench);
  add_maps(page, results);
  add_stress(page, stress);
  add_bearing(page, results);
  add_origin(page, results, bench, stress);
  return page.document("ehd: verification report");
}

Look look_of_solver(const View& bench, const std::string& solver) {
  static constexpr Look looks[] = {{Line::solid, Marker::circle, 1},
                                   {Line::dashed, Marker::square, 2},
                                   {Line::dotted, Marker::diamond, 3},
                                   {Line::dash_dot, Marker::triangle, 4},
                                   {Line::dotted, Marker::plus, 5}};
  const double number = bench["looks"].number(solver).value_or(0);
  for (const Look& look : looks)
    if (number == look.colour) return look;
  return {Line::dashed, Marker::cross, 6};
}

Look look_of_curve(std::size_t k) {
  static constexpr Line lines[] = {Line::solid, Line::dashed, Line::dash_dot, Line::dotted};
  static constexpr Marker markers[] = {Marker::circle,  Marker::square, Marker::triangle,
                                       Marker::diamond, Marker::plus,   Marker::cross};
  return {lines[k % 4], markers[k % 6], 1 + static_cast<int>(k % 6)};
}

Look look_of_law(const std::string& law) {
  // Laws that are balanced by default first: they stand in most figures, and nearby places differ most.
  std::vector<std::string_view> names;
  for (const bool by_default : {true, false})
    for (const bearing::LawRow& row : bearing::law_rows())
      if (row.is_default == by_default) names.push_back(row.name);
  const auto place = static_cast<std::size_t>(std::find(names.begin(), names.end(), law) - names.begin());
  // A law that only another version of the program knows: its look depends on its name alone.
  if (place == names.size()) return look_of_curve(std::accumulate(law.begin(), law.end(), place));
  return look_of_curve(place);
}

}  // namespace ehd::report
