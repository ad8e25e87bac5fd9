// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure and film of each case by two solvers, and their difference on an axis of its own.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/text.hpp"
#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

std::vector<double> magnitudes(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return values;
}

/// Five decades below the largest, at least round-off. A smaller difference means nothing.
std::optional<double> lowest_shown(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (const auto* values : {&a, &b}) {
    for (const double value : *values) {
      if (std::isfinite(value)) largest = std::max(largest, value);
    }
  }
  constexpr double five_decades = 1e-5, round_off = 1e-16;
  return largest > 0 ? std::optional(std::max(largest * five_decades, round_off)) : std::nullopt;
}

std::string description_of(const View& one) {
  std::string text;
  const auto add = [&](const std::string& part) {
    if (!part.empty()) text += (text.empty() ? "" : ", ") + part;
  };
  if (one.has("M")) add("<i>M</i> = " + markup_to_html(number_markup(*one.number("M"))));
  if (one.has("L")) add("<i>L</i> = " + markup_to_html(number_markup(*one.number("L"))));
  add(escaped(one.text("viscosity")));
  add(escaped(one.text("density")));
  if (const View inlet = one["inlet"]; inlet.exists()) {
    const std::string at = inlet.cell();
    add(at == "flooded" ? "flooded"
                        : "inlet cut at <i>X</i> = " + markup_to_html(number_markup(inlet.number().value_or(0))));
  }
  if (const auto pressure = one.number("p_H_Pa"))
    add("<i>p</i><sub>H</sub> = " + markup_to_html(number_markup(*pressure / 1e9, 3)) + " GPa");
  if (const auto width = one.number("half_width_m"))
    add("<i>b</i> = " + markup_to_html(number_markup(*width * 1e6, 3)) + " \u00b5m");
  if (const auto source = one.text("source"); !source.empty()) add("source: " + escaped(source));
  return text;
}

/// What the table says of a case: `found` is how far the films of the last solver are from those of the first.
struct Compared {
  View truth, solver;
  std::optional<double> stated, found, allowed;  ///< relative; stated by the solver, allowed by both together
  std::string status;                            ///< of the solver, or of the truth where only that one failed
};

std::optional<double> larger(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? std::max(*a, *b) : a ? a : b;
}

Compared compared(const View& one) {
  const auto solvers = one.list("solvers");
  Compared result;
  if (solvers.empty()) return result;
  result.truth = solvers.front();
  result.solver = solvers.back();
  const View film = result.solver["film"], difference = one["difference"];
  result.stated = larger(film["minimum"].number("error"), film["central"].number("error"));
  const auto magnitude = [&](const char* key) {
    auto value = difference.number(key);
    if (value) value = std::abs(*value);
    return value;
  };
  result.found = larger(magnitude("film_minimum"), magnitude("film_central"));
  result.allowed = difference.number("stated");
  result.status = result.solver.text("status");
  if (result.status == "converged") result.status = result.truth.text("status");
  return result;
}

TableCell digits_cell(const std::optional<double>& error) {
  const auto digits = digits_of(error);
  return {digits ? digits_text(*digits) : "", "number"};
}

std::vector<ContactCurves> curves_of(const View& one) {
  std::vector<ContactCurves> curves;
  for (const View& solver : one.list("solvers"))
    curves.push_back({.name = solver.text("solver"),
                      .X = solver.numbers("X"),
                      .P = solver.numbers("P"),
                      .H = solver.numbers("H"),
                      .P_cut = solver.number("pressure_cut")});
  return curves;
}

Figure case_figure(const View& one, const std::vector<ContactCurves>& curves) {
  const std::string id = one.text("id");
  Figure figure = contact_figure("fig-case-" + id, "Pressure and film of " + id, curves);
  figure.panels.front().height = 220;
  const View difference = one["difference"];
  if (!difference.exists()) return figure;
  const auto X = difference.numbers("X"), P = magnitudes(difference.numbers("P")),
             H = magnitudes(difference.numbers("H_relative"));
  Panel apart;
  apart.height = 110;
  apart.x = figure.panels.front().x;
  figure.panels.front().x.silent = true;
  apart.y = {.label = "difference", .scale = Scale::logarithmic, .low = lowest_shown(P, H)};
  apart.series.push_back({.name = "|\u0394*P*|", .x = X, .y = P, .colour = 1});
  apart.series.push_back({.name = "|\u0394*H*|/*H*", .x = X, .y = H, .line = Line::dashed, .colour = 2});
  if (const auto stated = difference.number("stated"); stated && *stated > 0)
    apart.rules.push_back({*stated, "stated, films"});
  figure.panels.push_back(std::move(apart));
  figure.description += " Below: the magnitude of " + difference.text("of") + ".";
  return figure;
}

TableCell film_cell(const View& solver, const char* which) {
  const View film = solver["film"][which];
  const auto value = film.number("hertz");
  return {value ? escaped(with_error(*value, film.number("error"))) : "", "number"};
}

/// One row of the table of cases; its figure is below it.
void add_case(Page& page, const View& one, Table& table) {
  const std::string id = one.text("id"), title = one.text("title");
  const auto curves = curves_of(one);
  Figure figure = case_figure(one, curves);
  std::string caption = "<b>" + escaped(id) + "</b>";
  if (one.has("version")) caption += "@" + escaped(one.cell("version"));
  if (!title.empty()) caption += ": " + escaped(title);
  const Opener opener =
      page.opener("figure-of-" + id,
                  fmt::format("{}<span class=\"unseen\">Figure of {}</span>",
                              curves.empty() ? "" : contact_spark(curves.back()), escaped(id)),
                  "Figure of " + escaped(id),
                  page.figure_html(std::move(figure), fmt::format("{}. {}.", caption, description_of(one))));
  table.below.push_back(opener.fold);
  table.ids.push_back(page.unique("case-" + id));
  const Compared both = compared(one);
  const bool beyond = both.found && both.allowed && *both.found > *both.allowed;
  const bool truth = both.truth.text("status") == "converged";
  table.rows.push_back({words(id),
                        {opener.link, ""},
                        number_cell(one.number("M"), 4),
                        number_cell(one.number("L"), 4),
                        film_cell(truth ? both.truth : both.solver, "minimum"),
                        film_cell(truth ? both.truth : both.solver, "central"),
                        digits_cell(certain_error(one)),
                        number_cell(both.stated, 2),
                        {number_cell(both.found, 2).html, beyond ? "number fail" : "number"},
                        verdict_cell(both.status),
                        milliseconds_cell(both.solver.number("wall_s")),
                        milliseconds_cell(both.truth.number("wall_s"))});
}

/// What each solver was asked and did, a row each.
void add_solves(Page& page, const std::vector<View>& cases) {
  Table table;
  table.caption = "Films by each solver (Hertz units, with the error that it states)";
  table.columns = {"case",       "solver", "asked",      "status",   "<i>H</i><sub>min</sub>", "<i>H</i><sub>cen</sub>",
                   "fields [%]", "nodes",  "work units", "time [ms]"};
  for (const View& one : cases)
    for (const View& solver : one.list("solvers"))
      table.rows.push_back({{escaped(one.text("id")), ""},
                            words(solver.text("solver")),
                            {escaped(solver.cell("tolerance", 3)), "number"},
                            verdict_cell(solver.text("status")),
                            film_cell(solver, "minimum"),
                            film_cell(solver, "central"),
                            number_cell(scaled(solver.number("field_error"), 100), 2),
                            integer_cell(solver.number("nodes")),
                            number_cell(solver.number("work_units"), 3),
                            milliseconds_cell(solver.number("wall_s"))});
  page.add_folded("Every solve: tolerance, nodes, work", table);
}

}  // namespace

std::optional<double> certain_error(const View& contact_case) {
  const auto solvers = contact_case.list("solvers");
  if (solvers.empty()) return std::nullopt;
  std::optional<double> largest;
  for (const char* which : {"minimum", "central"}) {
    const auto difference = contact_case["difference"].number(std::string("film_") + which),
               stated = solvers.front()["film"][which].number("error");
    if (difference && stated) largest = std::max(largest.value_or(0), std::abs(*difference) + *stated);
  }
  return largest;
}

void add_contacts(Page& page, const View& results) {
  page.section("contacts", "Cases: pressure and film", "Cases");
  const auto cases = results["figures"].list("cases");
  if (cases.empty()) {
    page.absent("Pressures and films of the cases are", "ehd verify --output DIR");
    return;
  }
  const Compared first = compared(cases.front());
  const std::string truth = escaped(first.truth.text("solver")), solver = escaped(first.solver.text("solver"));
  page.paragraph(fmt::format(
      "Each case by <code>{0}</code>, the truth, and <code>{1}</code>. Difference: the larger one of both "
      "films between the two solvers; beyond what both state together it would be red. Error stated: what "
      "<code>{1}</code> says of its own films. Digits: those of <code>{1}</code> that are certain, from the "
      "difference plus the error that <code>{0}</code> states; 4 digits are an error of 10<sup>\u22124</sup>. "
      "The small picture opens the figure: pressure and film, and below how far the solvers' fields are "
      "apart.",
      truth, solver));
  Table table;
  table.css = "cases";
  table.caption = "Films of the cases (Hertz units)";
  table.columns = {"case",
                   "<i>P</i>, <i>H</i>",
                   "<i>M</i>",
                   "<i>L</i>",
                   "<i>H</i><sub>min</sub>",
                   "<i>H</i><sub>cen</sub>",
                   "digits certain",
                   "error stated",
                   "difference",
                   "status",
                   "<code>" + solver + "</code> [ms]",
                   "<code>" + truth + "</code> [ms]"};
  for (const View& one : cases) add_case(page, one, table);
  page.add(table);
  page.paragraph(
      "In the figures, the dashed rule is the sum of the errors that both solvers state of the smallest and the "
      "central "
      "film. Those two films are extrapolated over the grids. The curves are the fields on the finest grid, which lie "
      "further apart; the table below has the error of their films. Where the height of a pressure spike is not known, "
      "the curve ends at 1.5 <i>p</i><sub>H</sub>. Films above the frame are cut off.");
  add_solves(page, cases);
}

}  // namespace ehd::report
