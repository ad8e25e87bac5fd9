// SPDX-License-Identifier: GPL-3.0-or-later
// The bearing: loads and displacements over the azimuth, as in the paper's figures.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "bearing/equilibrium.hpp"
#include "contact/text.hpp"
#include "verification/report/bearing_tables.hpp"
#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

constexpr const char* axis_psi = "azimuth *\u03c8* [deg]";
constexpr const char* axis_force = "contact force *f*_{i} [kN]";
constexpr const char* axis_displacement = "displacement *\u03b4*_{i} [\u00b5m]";

struct Bearing {
  std::string id, title, clearance_text;
  double clearance_m = 0;
  View view;
  std::vector<BearingCurves> laws;
};

std::vector<Bearing> bearings_of(const View& figures) {
  std::vector<Bearing> bearings;
  for (const View& one : figures.list("bearing")) {
    Bearing bearing{.id = one.text("id"),
                    .title = one.text("title"),
                    .clearance_text = {},
                    .clearance_m = one.number("clearance_m").value_or(0),
                    .view = one,
                    .laws = {}};
    bearing.clearance_text = plain(bearing.clearance_m * micro, 4);
    for (const View& law : one.list("laws")) {
      BearingCurves curves{.law = law.text("law"), .azimuth_deg = {}, .force_N = {}, .displacement_m = {}};
      for (const View& roller : law.list("rollers")) {
        const auto azimuth = roller.number("azimuth_deg"), force = roller["inner"].number("force_N"),
                   displacement = roller["inner"].number("displacement_m");
        if (!azimuth || !force || !displacement) continue;
        curves.azimuth_deg.push_back(*azimuth);
        curves.force_N.push_back(*force);
        curves.displacement_m.push_back(*displacement);
      }
      bearing.laws.push_back(std::move(curves));
    }
    bearings.push_back(std::move(bearing));
  }
  return bearings;
}

std::string clearance_label(const std::string& micrometres) { return "*P*_{d} = " + micrometres + " \u00b5m"; }

/// Groups of bearings with the same rollers, load and speed, which differ in clearance alone.
std::vector<std::vector<Bearing>> families(const std::vector<Bearing>& bearings) {
  std::vector<std::vector<Bearing>> groups;
  for (const Bearing& one : bearings) {
    const auto same = [&](const Bearing& other) {
      return one.view.number("radial_load_N") == other.view.number("radial_load_N") &&
             one.view.number("speed_rpm") == other.view.number("speed_rpm") && !one.laws.empty() &&
             !other.laws.empty() && one.laws.front().azimuth_deg.size() == other.laws.front().azimuth_deg.size() &&
             one.laws.size() == other.laws.size();
    };
    const auto group =
        std::find_if(groups.begin(), groups.end(), [&](const auto& members) { return same(members.front()); });
    if (group == groups.end())
      groups.push_back({one});
    else
      group->push_back(one);
  }
  for (auto& group : groups)
    std::stable_sort(group.begin(), group.end(),
                     [](const Bearing& a, const Bearing& b) { return a.clearance_m < b.clearance_m; });
  return groups;
}

std::string operation(const View& bearing) {
  std::string text;
  if (const auto load = bearing.number("radial_load_N"))
    text += "<i>F</i><sub>r</sub> = " + escaped(plain(*load * kilo, 4)) + " kN";
  if (const auto speed = bearing.number("speed_rpm"))
    text += (text.empty() ? "" : ", ") + escaped(plain(*speed, 6)) + " rpm";
  return text;
}

/// One scale for panels of one quantity, so that they can be compared.
void align(const std::vector<Panel*>& panels) {
  std::vector<double> values;
  for (const Panel* panel : panels)
    for (const Series& series : panel->series) values.insert(values.end(), series.y.begin(), series.y.end());
  const Range range = range_of(values, Scale::linear);
  for (Panel* panel : panels) {
    if (!panel->y.low) panel->y.low = range.low;
    panel->y.high = range.high;
  }
}

void align(std::vector<Figure>& figures) {
  std::vector<Panel*> panels;
  for (Figure& figure : figures) panels.push_back(&figure.panels.front());
  align(panels);
}

/// delta_i over psi of one law at all clearances.
Panel clearances_panel(const std::vector<Bearing>& group, const std::string& law) {
  std::vector<BearingCurves> curves;
  std::vector<std::string> names;
  for (const Bearing& bearing : group) {
    for (const BearingCurves& one : bearing.laws) {
      if (one.law != law) continue;
      curves.push_back(one);
      names.push_back(clearance_label(bearing.clearance_text));
    }
  }
  Panel panel = azimuth_panel(OverAzimuth::displacement, literal(law), curves);
  for (std::size_t k = 0; k < panel.series.size(); ++k) {
    Series& series = panel.series[k];
    const Look look = look_of_curve(k);
    series.name = names[k];
    series.line = look.line;
    series.marker = look.marker;
    series.colour = look.colour;
  }
  return panel;
}

/// One figure a bearing: f_i over psi, a curve a law.
std::vector<Figure> force_figures(const std::vector<Bearing>& group) {
  std::vector<Figure> figures;
  for (const Bearing& bearing : group) {
    Figure figure{.id = "fig-force-" + bearing.id,
                  .title = "Contact forces of " + bearing.id,
                  .description = "Contact force of each roller at the inner raceway over its azimuth, a curve a law."};
    figure.panels.push_back(azimuth_panel(OverAzimuth::force, clearance_label(bearing.clearance_text), bearing.laws));
    figures.push_back(std::move(figure));
  }
  align(figures);
  return figures;
}

void add_force(Page& page, const Bearing& bearing, Figure figure) {
  page.figure(std::move(figure),
              fmt::format("<b>{}</b>: contact force over azimuth (the paper's figure 2), inner raceway, {}.",
                          escaped(bearing.id), markup_to_html(clearance_label(bearing.clearance_text))));
}

void add_displacements(Page& page, const Bearing& first) {
  Figure displacement{
      .id = "fig-displacement-" + first.id,
      .title = "Displacements of " + first.id,
      .description =
          "Displacement of each roller at the inner raceway over its azimuth, a curve a law; negative is a gap."};
  displacement.panels.push_back(
      azimuth_panel(OverAzimuth::displacement, clearance_label(first.clearance_text), first.laws));
  page.figure(
      std::move(displacement),
      fmt::format("<b>{}</b>: displacement over azimuth (the paper's figure 3), {}; negative where there is a gap.",
                  escaped(first.id), markup_to_html(clearance_label(first.clearance_text))));
}

/// One figure a law: delta_i over psi, a curve a clearance.
void add_clearances(Page& page, const std::vector<Bearing>& group) {
  const Bearing& first = group.front();
  std::vector<Figure> figures;
  for (const BearingCurves& law : first.laws) {
    Figure figure{.id = fmt::format("fig-clearance-{}-{}", first.id, law.law),
                  .title = "Displacements at all clearances, " + law.law,
                  .description = "Displacement of each roller over its azimuth under the law " + law.law +
                                 ", a curve a clearance."};
    figure.panels.push_back(clearances_panel(group, law.law));
    figures.push_back(std::move(figure));
  }
  align(figures);
  for (std::size_t k = 0; k < figures.size(); ++k)
    page.figure(std::move(figures[k]), "Displacement over azimuth at all clearances (the paper's figure 4), law <b>" +
                                           escaped(first.laws[k].law) + "</b>.");
}

/// One radial scale for all, so that the plots can be compared.
void add_polars(Page& page, const std::vector<Bearing>& group) {
  page.begin_figures("polars");
  double largest = 0;
  for (const Bearing& bearing : group)
    for (const BearingCurves& law : bearing.laws)
      for (const double force : law.force_N)
        if (std::isfinite(force)) largest = std::max(largest, force * kilo);
  for (const Bearing& bearing : group) {
    PolarPlot plot{
        .id = "fig-polar-" + bearing.id,
        .title = "Load distribution of " + bearing.id + " round the bearing",
        .description =
            "Contact force of each roller at the inner raceway as radius, azimuth as angle, the load pointing down.",
        .heading = clearance_label(bearing.clearance_text),
        .radius_label = axis_force,
        .series = {},
        .reaches = largest};
    for (const BearingCurves& law : bearing.laws) {
      const Look look = look_of_law(law.law);
      plot.series.push_back({.name = literal(law.law),
                             .angle_deg = law.azimuth_deg,
                             .radius = scaled(law.force_N, kilo),
                             .line = look.line,
                             .marker = look.marker,
                             .colour = look.colour});
    }
    page.figure(std::move(plot),
                "<b>" + escaped(bearing.id) + "</b>: load distribution; the load points down, towards 0\u00b0.");
  }
  page.end_figures();
}

/// The number with its error in brackets; `digits` digits where no error is known.
TableCell number_with_error(const std::optional<double>& value, const std::optional<double>& absolute_error,
                            int digits) {
  if (!value || !std::isfinite(*value) || !absolute_error) return number_cell(value, digits);
  return {with_absolute_error(*value, absolute_error), "number"};
}

/// One row of the table of balances: a law of a bearing.
std::vector<TableCell> balance_row(const std::string& id, const View& law) {
  double force = 0, film = std::numeric_limits<double>::infinity();
  std::vector<double> forces;
  for (const View& roller : law.list("rollers")) {
    forces.push_back(roller["inner"].number("force_N").value_or(0));
    force = std::max(force, forces.back());
    for (const char* raceway : {"inner", "outer"})
      film = std::min(film, roller[raceway].number("film_minimum_m").value_or(film));
  }
  const auto errors = errors_of_balance(law);
  const auto displacement_error = errors ? std::optional(errors->displacement_m * micro) : std::nullopt;
  const auto force_error = errors ? std::optional(errors->largest_force_N * kilo) : std::nullopt;
  const auto film_error = errors ? scaled(errors->smallest_film, film * micro) : std::nullopt;
  const auto loaded =
      std::count_if(forces.begin(), forces.end(), [&](double one) { return bearing::is_loaded(one, force); });
  const View fit = law["fit"]["inner"];
  return {words(id),
          words(law.text("law")),
          verdict_cell(law.text("status")),
          number_with_error(scaled(law.number("displacement_m"), micro), displacement_error, 4),
          number_with_error(force * kilo, force_error, 4),
          integer_cell(static_cast<double>(loaded)),
          number_with_error(film * micro, film_error, 3),
          number_cell(scaled(fit.number("K_N_per_m"), 1 / micro), 5),
          number_cell(fit.number("dF_N"), 4),
          number_cell(fit.number("residual_N"), 3)};
}

void add_balances(Page& page, const std::vector<Bearing>& group) {
  Table table;
  table.caption =
      "Balance, and fit of the inner raceway: <i>f</i> = <i>K</i> <i>\u03b4</i> + \u0394<i>F</i>. In brackets: the "
      "error, in units of the last digit";
  table.columns = {"case",
                   "law",
                   "status",
                   "ring displacement [\u00b5m]",
                   "largest force [kN]",
                   "loaded rollers",
                   "thinnest film [\u00b5m]",
                   "<i>K</i> [N/\u00b5m]",
                   "\u0394<i>F</i> [N]",
                   "residual [N]"};
  for (const Bearing& bearing : group)
    for (const View& law : bearing.view.list("laws")) table.rows.push_back(balance_row(bearing.id, law));
  page.add(table);
}

void add_family(Page& page, const std::vector<Bearing>& group) {
  const Bearing& first = group.front();
  const std::string what = first.id + (group.size() > 1 ? " and its clearances" : "");
  page.heading(escaped(what) + (operation(first.view).empty() ? "" : ": " + operation(first.view)));
  if (!first.title.empty()) page.paragraph(escaped(first.title) + ".");
  add_balances(page, group);
  auto forces = force_figures(group);
  page.begin_figures();
  add_force(page, first, std::move(forces.front()));
  add_displacements(page, first);
  page.end_figures();
  page.begin_fold("Load distributions round the bearing" + std::string(group.size() > 1 ? ", and all clearances" : ""));
  if (group.size() > 1) {
    page.begin_figures();
    for (std::size_t k = 1; k < group.size(); ++k) add_force(page, group[k], std::move(forces[k]));
    add_clearances(page, group);
    page.end_figures();
  }
  add_polars(page, group);
  page.end_fold();
}

/// -180 < psi <= 180, rounded, so that azimuths of one roller are equal.
double wrapped_azimuth(double psi_deg) {
  constexpr double same = 1e4;
  double psi = std::remainder(std::round(psi_deg * same) / same, 360);
  if (psi <= -180) psi += 360;
  return psi == 0 ? 0 : psi;
}

/// Every roller has another at -psi that carries the same.
bool mirrored(const std::map<double, double>& values) {
  constexpr double same = 1e-6;  // of the largest: fields are written with some seven digits
  double largest = 0;
  for (const auto& [psi, value] : values) largest = std::max(largest, std::abs(value));
  return std::all_of(values.begin(), values.end(), [&](const auto& roller) {
    const auto other = values.find(roller.first == 180 ? 180 : roller.first == 0 ? 0 : -roller.first);
    return other != values.end() && std::abs(other->second - roller.second) <= same * largest;
  });
}

}  // namespace

Panel azimuth_panel(OverAzimuth quantity, const std::string& title_markup, const std::vector<BearingCurves>& laws) {
  Panel panel;
  panel.title = title_markup;
  panel.x = {.label = axis_psi, .low = 0, .high = 180, .step = 30};
  const bool force = quantity == OverAzimuth::force;
  panel.y = {.label = force ? axis_force : axis_displacement};
  if (force) panel.y.low = 0;
  std::vector<std::map<double, double>> all;
  for (const BearingCurves& law : laws) {
    const auto& values = force ? law.force_N : law.displacement_m;
    std::map<double, double> rollers;
    for (std::size_t i = 0; i < std::min(law.azimuth_deg.size(), values.size()); ++i)
      if (std::isfinite(law.azimuth_deg[i])) rollers.emplace(wrapped_azimuth(law.azimuth_deg[i]), values[i]);
    all.push_back(std::move(rollers));
  }
  // One half is enough where the other is its mirror image. It is not where the cage stands askew.
  const bool half = std::all_of(all.begin(), all.end(), mirrored);
  if (!half) panel.x = {.label = axis_psi, .low = -180, .high = 180, .step = 60};
  for (std::size_t k = 0; k < laws.size(); ++k) {
    const Look look = look_of_law(laws[k].law);
    Series series{
        .name = literal(laws[k].law), .line = look.line, .marker = look.marker, .colour = look.colour, .hollow = true};
    for (const auto& [azimuth, value] : all[k]) {
      if (half && azimuth < 0) continue;
      series.x.push_back(azimuth);
      series.y.push_back(value * (force ? kilo : micro));
    }
    panel.series.push_back(std::move(series));
  }
  if (!force) panel.rules.push_back({0, ""});
  return panel;
}

void add_bearing(Page& page, const View& results) {
  page.section("bearing", "Bearing");
  const View figures = results["figures"];
  const auto bearings = bearings_of(figures);
  if (bearings.empty()) {
    page.absent("Load distributions are", "ehd verify --output DIR");
  } else {
    page.paragraph(
        "Laws: <b>hertz</b>, dry; <b>ehd-linear</b>, the straight line fitted to the solver's relation; <b>ehd</b>, "
        "the solver's own relation. "
        "Azimuth 0\u00b0 is the roller under the load; where one half of the bearing is shown, the other is its mirror "
        "image.");
    for (const auto& group : families(bearings)) add_family(page, group);
  }
  add_dynamics(page, figures.list("dynamics"));
  add_budgets(page, figures.list("bearing"));
  add_statements(page, figures.list("statements"));
  add_study(page, figures["statement_study"]);
  add_force_laws(page, figures.list("force_law"));
}

}  // namespace ehd::report
