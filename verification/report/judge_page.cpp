// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/judge_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "contact/quantities.hpp"
#include "verification/report/page.hpp"

namespace ehd::report {

namespace {

using Judgements = std::vector<View>;

const std::string smallest_film(to_string(ehd::Quantity::film_minimum));

std::string name_of(const View& judgement) {
  const View solver = judgement["solver"];
  const std::string version = solver.text("version");
  return solver.text("name") + (version.empty() ? "" : " " + version);
}

/// The name as HTML, which may break at its dots and underscores: it heads a narrow column.
std::string breakable(const std::string& name) {
  std::string html;
  for (const char c : escaped(name)) html += c == '_' || c == '.' ? fmt::format("{}<wbr>", c) : std::string(1, c);
  return html;
}

/// A series of marks for the k-th submission. The first `own` ones are the reader's: large and blue. The others have
/// other colours; after six of them the marks are hollow. No two of thirty look the same.
Series marks_of(const Judgements& judgements, std::size_t k, std::size_t own) {
  static constexpr Marker markers[] = {Marker::circle,  Marker::square, Marker::triangle,
                                       Marker::diamond, Marker::cross,  Marker::plus};
  constexpr double large = 1.9;
  Series series{.name = literal(name_of(judgements[k])), .line = Line::none};
  if (k < own) {
    series.marker = markers[k % 6];
    series.size = large;
    return series;
  }
  const std::size_t other = k - own;
  series.marker = markers[other % 6];
  series.colour = 2 + static_cast<int>(other % 5);
  series.hollow = other / 6 % 2 == 1;
  return series;
}

/// The score of a quantity; an empty View where the case does not certify it.
View score_in(const View& judged_case, std::string_view quantity) {
  for (const View& score : judged_case.list("scores"))
    if (score.text("quantity") == quantity) return score;
  return {};
}

View case_in(const View& judgement, const std::string& id) {
  for (const View& one : judgement.list("cases"))
    if (one.text("case") == id) return one;
  return {};
}

/// Digits and whether the stated error was kept: "3.1", "3.1 !", "missing".
TableCell digits_cell(const View& score) {
  if (!score.exists()) return {"-", "number"};
  if (score.flag("missing").value_or(false)) return {"missing", "number fail"};
  const bool missed = score.text("honesty") == "missed";
  const bool bounded = score.number("error").value_or(0) < score["certified"].number("uncertainty").value_or(0);
  return {fmt::format("{}{:.1f}{}", bounded ? "&gt;" : "", score.number("digits").value_or(0), missed ? "&nbsp;!" : ""),
          missed ? "number fail" : "number"};
}

std::vector<std::string> quantities_in(const View& judgement) {
  std::vector<std::string> names;
  for (const QuantityRow& row : quantity_table()) {
    const auto cases = judgement.list("cases");
    if (std::any_of(cases.begin(), cases.end(), [&](const View& one) { return score_in(one, row.name).exists(); }))
      names.emplace_back(row.name);
  }
  return names;
}

/// Leaves out each column behind the first without anything in it.
void erase_empty_columns(Table& table) {
  for (std::size_t column = table.columns.size(); column-- > 1;) {
    const auto says_nothing = [&](const auto& row) { return row[column].html.empty() || row[column].html == "-"; };
    if (!std::ranges::all_of(table.rows, says_nothing)) continue;
    const auto at = static_cast<std::ptrdiff_t>(column);
    table.columns.erase(table.columns.begin() + at);
    for (auto& row : table.rows) row.erase(row.begin() + at);
  }
}

std::string regime_of(const View& one) {
  const View regime = one["regime"];
  return regime.exists() ? regime.text("load") + ", L " + regime.text("material") : "dry";
}

void add_first_cases(Page& page, const Judgements& judgements) {
  page.section("first", "The first ten cases, from easy to hard");
  page.paragraph(
      "Digits of the smallest film, by solver: -log<sub>10</sub> of the relative error against the certified number. A "
      "case that a submission leaves out is missing and counts as 0. &gt; the case knows no more digits. ! the "
      "error is above the one that the solver states.");
  Table table{.columns = {"case, and what it tests"}};  // one column of words: there is a column a submission beside it
  for (const View& judgement : judgements) table.columns.push_back(breakable(name_of(judgement)));
  for (const View& one : judgements.front().list("cases")) {
    if (!one.has("place")) continue;
    std::vector<TableCell> row{
        {escaped(one.text("case")) + "<br>" + escaped(regime_of(one) + ": " + one.text("tests"))}};
    for (const View& judgement : judgements)
      row.push_back(digits_cell(score_in(case_in(judgement, one.text("case")), smallest_film)));
    table.rows.push_back(std::move(row));
  }
  page.add(table);
}

/// Digits of the smallest film over M, a curve a solver.
void add_picture(Page& page, const Judgements& judgements, std::size_t own) {
  Figure figure{.id = "fig-digits",
                .title = "Digits of the smallest film over the load",
                .description = "A mark is a case; the certified digits bound the score."};
  Panel panel;
  panel.x = {.label = "load *M*", .scale = Scale::logarithmic};
  panel.y = {.label = "digits", .low = 0};
  for (std::size_t k = 0; k < judgements.size(); ++k) {
    Series series = marks_of(judgements, k, own);
    for (const View& one : judgements[k].list("cases")) {
      const View score = score_in(one, smallest_film);
      const auto M = one.number("M"), digits = score.number("digits");
      if (!M || !digits || score.flag("missing").value_or(false)) continue;
      series.x.push_back(*M);
      series.y.push_back(*digits);
    }
    if (!series.x.empty()) panel.series.push_back(std::move(series));
  }
  if (panel.series.empty()) return;
  figure.panels.push_back(std::move(panel));
  page.figure(std::move(figure), "Digits of film.minimum over M, every submitted case.");
}

/// Stated against actual errors of the films: above the line the solver promised less than it kept.
void add_honesty(Page& page, const Judgements& judgements, std::size_t own) {
  Figure figure{.id = "fig-stated",
                .title = "Stated against actual error",
                .description = "A mark is a number whose error was stated; on the line both are equal."};
  Panel panel;
  panel.x = {.label = "actual relative error", .scale = Scale::logarithmic};
  panel.y = {.label = "stated relative error", .scale = Scale::logarithmic};
  double low = 1, high = 0;
  for (std::size_t k = 0; k < judgements.size(); ++k) {
    Series series = marks_of(judgements, k, own);
    for (const View& one : judgements[k].list("cases")) {
      for (const View& score : one.list("scores")) {
        const auto error = score.number("error"), stated = score.number("stated_error"),
                   known = score["certified"].number("uncertainty");
        if (!error || !stated || !known || score.text("honesty") == "undecided") continue;
        const double shown = std::max(*error, *known);
        series.x.push_back(shown);
        series.y.push_back(*stated);
        low = std::min({low, shown, *stated});
        high = std::max({high, shown, *stated});
      }
    }
    if (!series.x.empty()) panel.series.push_back(std::move(series));
  }
  if (!panel.series.empty()) {
    panel.series.push_back({.name = "equal", .x = {low, high}, .y = {low, high}, .line = Line::dashed, .colour = 6});
    figure.panels.push_back(std::move(panel));
    page.figure(std::move(figure),
                "Stated over actual error. A mark below the line promised too much. Numbers whose case knows too few "
                "digits to tell are left out.");
  }
}

void add_gates_and_hints(Page& page, const View& judgement) {
  Table gates{.caption = "Gates of the profiles: passed or failed, never ranked",
              .columns = {"case", "gate", "error", "allowed", "verdict", "quadrature"}};
  for (const View& one : judgement.list("cases"))
    for (const View& gate : one["profile"].list("gates"))
      gates.rows.push_back({words(one.text("case")), words(gate.text("name")), number_cell(gate.number("error"), 2),
                            number_cell(gate.number("tolerance"), 2), verdict_cell(gate.text("verdict")),
                            words(gate.text("quadrature"))});
  erase_empty_columns(gates);
  if (!gates.rows.empty()) page.add(gates);
  for (const View& one : judgement.list("cases"))
    for (const View& hint : one.list("hints"))
      page.paragraph(fmt::format("<b>{}</b>: {}", escaped(one.text("case")), escaped(hint.text())));
}

void add_solver(Page& page, const View& judgement) {
  page.section("solver-" + judgement["solver"].text("name"), escaped(name_of(judgement)));
  const View honesty = judgement["honesty"];
  std::string head = escaped(judgement.text("submission"));
  if (judgement.has("hardware")) head += "; " + escaped(judgement.text("hardware"));
  if (judgement["solver"].has("url")) head += "; " + escaped(judgement["solver"].text("url"));
  page.paragraph(head + fmt::format(". Stated errors: {} met, {} missed, {} undecided.", honesty.cell("met"),
                                    honesty.cell("missed"), honesty.cell("undecided")));
  Table regimes{.caption = "Digits by regime; a missing number counts as 0",
                .columns = {"load", "L", "numbers", "missing", "median", "worst", "median of the given"}};
  for (const View& row : judgement.list("regimes"))
    regimes.rows.push_back({words(row.text("load")), words(row.text("material")), integer_cell(row.number("numbers")),
                            integer_cell(row.number("missing")), number_cell(row.number("median"), 2),
                            number_cell(row.number("worst"), 2), number_cell(row.number("median_given"), 2)});
  erase_empty_columns(regimes);
  page.add(regimes);
  Table digits{.columns = {"case", "regime"}};
  const auto quantities = quantities_in(judgement);
  for (const auto& name : quantities) digits.columns.push_back(escaped(name));
  digits.columns.emplace_back("P, L2");
  digits.columns.emplace_back("time [s], as stated");
  for (const View& one : judgement.list("cases")) {
    std::vector<TableCell> row{words(one.text("case")), words(regime_of(one))};
    for (const auto& name : quantities) row.push_back(digits_cell(score_in(one, name)));
    row.push_back(number_cell(one["profile"].number("pressure_error"), 2));
    row.push_back(number_cell(one.number("wall_s"), 3));
    digits.rows.push_back(std::move(row));
  }
  erase_empty_columns(digits);
  page.add_folded("Digits of every case", digits);
  add_gates_and_hints(page, judgement);
}

}  // namespace

std::string judge_page(const std::vector<Json>& judgements, std::size_t own) {
  Judgements views;
  for (const Json& one : judgements) views.emplace_back(one, "judgement");
  Page page;
  if (!views.empty()) {
    add_first_cases(page, views);
    page.begin_figures();
    add_picture(page, views, own);
    add_honesty(page, views, own);
    page.end_figures();
    for (const View& one : views) add_solver(page, one);
  }
  return page.document("Solvers of the line contact, judged by certified digits");
}

}  // namespace ehd::report
