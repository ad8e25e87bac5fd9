// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure and film of each case by two solvers, and their difference on an axis of its own.
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/text.hpp"
#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

constexpr const char* axis_X = "*X* = *x*/*b*";
constexpr const char* axis_P = "*P* = *p*/*p*_{H}";
constexpr const char* axis_H = "*H* = *h R*/*b*^{2}";

std::vector<double> magnitudes(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return values;
}

/// Three decades below the largest, or down to the stated error. A smaller difference means nothing.
std::optional<double> lowest_shown(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (const auto* values : {&a, &b}) {
    for (const double value : *values) {
      if (std::isfinite(value)) largest = std::max(largest, value);
    }
  }
  constexpr double decades = 1e-5, round_off = 1e-16;
  return largest > 0 ? std::optional(std::max(largest * decades, round_off)) : std::nullopt;
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

/// H at the node nearest to X = 0; 0 where there is none.
double film_at_centre(const ContactCurves& curves) {
  double nearest = std::numeric_limits<double>::infinity(), film = 0;
  for (std::size_t i = 0; i < std::min(curves.X.size(), curves.H.size()); ++i) {
    if (!(std::abs(curves.X[i]) < nearest) || !std::isfinite(curves.H[i])) continue;
    nearest = std::abs(curves.X[i]);
    film = curves.H[i];
  }
  return film;
}

}  // namespace

Figure contact_figure(const std::string& id, const std::string& title, const std::vector<ContactCurves>& curves) {
  Figure figure{.id = id,
                .title = title,
                .description = "Pressure P = p/p_H (left axis) and film H = h R/b^2 (right axis) over X = x/b."};
  Panel panel;
  // From where the pressure begins to where it has ended, with a margin on both sides.
  constexpr double felt = 0.02, margin = 0.15;
  double low = std::numeric_limits<double>::infinity(), high = -low, first = low, last = -low, central = 0;
  for (const ContactCurves& one : curves) {
    double top = 0;
    for (const double P : one.P) top = std::isfinite(P) ? std::max(top, P) : top;
    for (std::size_t i = 0; i < std::min(one.X.size(), one.P.size()); ++i) {
      if (!std::isfinite(one.X[i])) continue;
      first = std::min(first, one.X[i]);
      last = std::max(last, one.X[i]);
      if (!(one.P[i] > felt * top)) continue;
      low = std::min(low, one.X[i]);
      high = std::max(high, one.X[i]);
    }
    central = std::max(central, film_at_centre(one));
  }
  panel.x = {.label = axis_X};
  if (low < high) {
    const double wide = high - low;
    panel.x.low = std::max(first, std::min(low - margin * wide, -1.5));
    panel.x.high = std::min(last, std::max(high + margin * wide, 1.5));
  }
  panel.y = {.label = axis_P, .low = 0};
  panel.right = Axis{.label = axis_H, .low = 0};
  // Outside the contact the film opens far beyond its height inside. The figure ends at four times that height.
  constexpr double shown_films = 4;
  if (central > 0) {
    double tallest = 0;
    for (const ContactCurves& one : curves) {
      for (std::size_t i = 0; i < std::min(one.X.size(), one.H.size()); ++i) {
        if (one.X[i] >= panel.x.low.value_or(-1e9) && one.X[i] <= panel.x.high.value_or(1e9) && std::isfinite(one.H[i]))
          tallest = std::max(tallest, one.H[i]);
      }
    }
    constexpr double no_film = 1e-9;  // of the tallest: a dry contact's rounding
    panel.right->high =
        range_of({0, central > no_film * tallest ? std::min(tallest, shown_films * central) : tallest}, Scale::linear)
            .high;
  }
  for (const ContactCurves& one : curves)
    if (one.P_cut && panel.rules.empty()) panel.rules.push_back({*one.P_cut, "above: unresolved"});
  for (const ContactCurves& one : curves) {
    const std::string name = literal(one.name);
    // One solver: P solid, H dashed. The curves of two solvers lie on each other: each curve has a dash of its own.
    const bool alone = curves.size() == 1, upper = &one == &curves.front();
    panel.series.push_back({.name = "*P* " + name,
                            .x = one.X,
                            .y = one.P,
                            .line = upper ? Line::solid : Line::dashed,
                            .colour = upper ? 1 : 2});
    panel.series.push_back({.name = "*H* " + name,
                            .x = one.X,
                            .y = one.H,
                            .line = alone   ? Line::dashed
                                    : upper ? Line::dash_dot
                                            : Line::dotted,
                            .colour = upper ? 3 : 4,
                            .right = true});
  }
  figure.panels.push_back(std::move(panel));
  return figure;
}

void add_contacts(Page& page, const View& results) {
  page.section("contacts", "Pressure and film");
  const auto cases = results["figures"].list("cases");
  if (cases.empty()) {
    page.absent("Pressures and films of the cases are", "ehd verify --output DIR");
    return;
  }
  page.paragraph(
      "Each case by both solvers; the lower panel shows how far they are apart (magnitudes). The dashed rule is the "
      "sum "
      "of the errors that they state of the smallest and the central film. These are extrapolated over the grids; the "
      "fields are those of the finest one, and lie further apart, by its second order: the table has the error of the "
      "films in them. Where the height of a pressure spike is not known, curves end at 1.5 <i>p</i><sub>H</sub>, "
      "unresolved above. Films above the frame are cut off.");
  page.begin_figures();
  Table table;
  table.caption = "Films of the cases (Hertz units, with the error that the solver states)";
  table.columns = {"case",       "solver", "asked",      "status",   "<i>H</i><sub>min</sub>", "<i>H</i><sub>cen</sub>",
                   "fields [%]", "nodes",  "work units", "time [ms]"};
  for (const View& one : cases) {
    const std::string id = one.text("id"), title = one.text("title");
    std::vector<ContactCurves> curves;
    for (const View& solver : one.list("solvers")) {
      const View film = solver["film"];
      const auto known = [&](const char* which) {
        const auto value = film[which].number("hertz");
        return TableCell{value ? escaped(with_error(*value, film[which].number("error"))) : "", "number"};
      };
      table.rows.push_back({{escaped(id), ""},
                            words(solver.text("solver")),
                            {escaped(solver.cell("tolerance", 3)), "number"},
                            verdict_cell(solver.text("status")),
                            known("minimum"),
                            known("central"),
                            number_cell(scaled(solver.number("field_error"), 100), 2),
                            integer_cell(solver.number("nodes")),
                            number_cell(solver.number("work_units"), 3),
                            number_cell(scaled(solver.number("wall_s"), 1e3), 3)});
      curves.push_back({.name = solver.text("solver"),
                        .X = solver.numbers("X"),
                        .P = solver.numbers("P"),
                        .H = solver.numbers("H"),
                        .P_cut = solver.number("pressure_cut")});
    }
    Figure figure = contact_figure("fig-case-" + id, "Pressure and film of " + id, curves);
    figure.panels.front().height = 220;
    const View difference = one["difference"];
    if (difference.exists()) {
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
    }
    std::string caption = "<b>" + escaped(id) + "</b>";
    if (one.has("version")) caption += "@" + escaped(one.cell("version"));
    if (!title.empty()) caption += ": " + escaped(title);
    page.figure(std::move(figure), caption + ". " + description_of(one) + ".");
  }
  page.end_figures();
  page.add(table);
}

}  // namespace ehd::report
