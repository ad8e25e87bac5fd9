// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "contact/text.hpp"
#include "verification/report/mosaic.hpp"
#include "verification/report/polar_plot.hpp"
#include "verification/report/report.hpp"
#include "workflow/shown_pressure.hpp"

namespace ehd::cli {

namespace {

using report::Axis;
using report::BearingCurves;
using report::Figure;
using report::OverAzimuth;
using report::Panel;
using report::PolarPlot;

constexpr double micro = 1e6, mega = 1e-6, kilo = 1e-3;
constexpr std::size_t longest_title = 240;  // several lines
constexpr std::size_t most_columns = 3;     // of a picture of several bearings
constexpr double width_of_several = 400;    // of a picture among them

std::string shown(const std::string& title) { return report::literal(shortened(one_line(title), longest_title)); }

void scale(Axis& axis, double unit, const std::string& label) {
  axis.label = label;
  if (axis.low) *axis.low *= unit;
  if (axis.high) *axis.high = report::range_of({0, *axis.high * unit}, axis.scale).high;
}

/// From Hertz units to um and MPa.
void to_SI(Panel& panel, const Scales& scales) {
  const double x = micro * *scales.half_width_m, p = mega * scales.hertz_pressure_Pa,
               h = micro * *scales.film_m_per_hertz_film();
  const auto low = panel.x.low, high = panel.x.high;
  panel.x = {.label = "*x* [\u00b5m]",
             .low = low ? std::optional(*low * x) : low,
             .high = high ? std::optional(*high * x) : high};
  scale(panel.y, p, "pressure *p* [MPa]");
  scale(*panel.right, h, "film *h* [\u00b5m]");
  for (report::Rule& rule : panel.rules) rule.y *= p;
  for (report::Series& series : panel.series) {
    (series.name.empty() ? series.of : series.name) = series.right ? "film *h*" : "pressure *p*";
    for (double& value : series.x) value *= x;
    for (double& value : series.y) value *= series.right ? h : p;
  }
}

/// The laws of a bearing that balanced.
std::vector<BearingCurves> curves_of(const std::vector<BearingResult>& results) {
  std::vector<BearingCurves> laws;
  for (const BearingResult& result : results) {
    if (result.rollers.empty()) continue;
    BearingCurves curves{
        .law = std::string(to_string(result.law)), .azimuth_deg = {}, .force_N = {}, .displacement_m = {}};
    for (const RollerRow& roller : result.rollers) {
      curves.azimuth_deg.push_back(roller.azimuth_deg);
      curves.force_N.push_back(roller.inner.force_N);
      curves.displacement_m.push_back(roller.inner.displacement_m);
    }
    laws.push_back(std::move(curves));
  }
  return laws;
}

/// Forces above displacements. `bearing`: its name in the titles of both; empty where it stands alone.
Figure over_azimuth(const std::string& id, const std::string& bearing, const std::vector<BearingCurves>& laws) {
  const bool alone = bearing.empty();
  const std::string force = alone ? "Contact force over the azimuth" : bearing + ": contact force",
                    displacement = alone ? "Displacement over the azimuth" : bearing + ": displacement";
  Figure figure{.id = id,
                .title = force,
                .description =
                    "Contact force and displacement of each roller at the inner raceway over its azimuth, "
                    "a curve a law."};
  figure.panels = {report::azimuth_panel(OverAzimuth::force, force, laws),
                   report::azimuth_panel(OverAzimuth::displacement, displacement, laws)};
  return figure;
}

/// `largest_N`: what the outer circle reaches at least.
PolarPlot polar_plot(const std::string& id, const std::string& heading, const std::vector<BearingCurves>& laws,
                     double largest_N) {
  PolarPlot plot{.id = id,
                 .title = "Loads round the bearing",
                 .description = "Contact force of each roller at the inner raceway as radius, azimuth as angle.",
                 .heading = heading,
                 .radius_label = "contact force *f*_{i} [kN]",
                 .series = {},
                 .reaches = kilo * largest_N};
  for (const BearingCurves& law : laws) {
    const report::Look look = report::look_of_law(law.law);
    report::PolarSeries series{.name = report::literal(law.law),
                               .angle_deg = law.azimuth_deg,
                               .radius = law.force_N,
                               .line = look.line,
                               .marker = look.marker,
                               .colour = look.colour};
    for (double& force : series.radius) force *= kilo;
    plot.series.push_back(std::move(series));
  }
  return plot;
}

double largest_force_N(const std::vector<BearingCurves>& laws) {
  double largest = 0;
  for (const BearingCurves& law : laws)
    for (const double force : law.force_N) largest = std::max(largest, force);
  return largest;
}

/// The loads round each bearing, all to the same radius.
std::vector<std::string> polar_tiles(const std::vector<std::string>& names,
                                     const std::vector<std::vector<BearingCurves>>& bearings) {
  double largest = 0;
  for (const auto& laws : bearings) largest = std::max(largest, largest_force_N(laws));
  std::vector<std::string> tiles;
  for (std::size_t k = 0; k < bearings.size(); ++k) {
    PolarPlot plot = polar_plot(fmt::format("polar-{}", k), names[k], bearings[k], largest);
    plot.width = width_of_several;
    tiles.push_back(draw(plot, report::Place::page));
  }
  return tiles;
}

/// All panels of one kind show the same range.
void share_axes(std::vector<Figure>& figures) {
  for (std::size_t panel = 0; panel < 2; ++panel) {
    std::vector<double> values{0};
    for (const Figure& figure : figures)
      for (const report::Series& series : figure.panels[panel].series)
        values.insert(values.end(), series.y.begin(), series.y.end());
    const report::Range range = report::range_of(values, report::Scale::linear);
    for (Figure& figure : figures) figure.panels[panel].y.low = range.low, figure.panels[panel].y.high = range.high;
  }
}

}  // namespace

std::string contact_picture(const ContactRun& run, const std::string& title) {
  const Fields& fields = run.solution.fields;
  const std::optional<double> cut = pressure_cut(run);
  Array P = fields.P;
  if (cut) P = P.min(*cut);
  const auto values = [](const auto& field) { return std::vector<double>(field.begin(), field.end()); };
  std::optional<report::Point> vague;
  if (const auto spike = vague_spike(run)) vague = {*spike->place, spike->value};
  const report::ContactCurves curves{.name = run.solver.empty() ? "Hertz" : run.solver,
                                     .X = values(fields.X),
                                     .P = values(P),
                                     .H = values(fields.H),
                                     .P_cut = cut,
                                     .vague_spike = vague};
  Figure figure = report::contact_figure("contact", "Pressure and film of " + title, {curves});
  figure.width = 560;
  Panel& panel = figure.panels.front();
  panel.height = 300;
  panel.title = shown(title);
  if (run.scales && run.scales->half_width_m && run.scales->film_m_per_hertz_film()) {
    to_SI(panel, *run.scales);
    figure.description = "Pressure in MPa (left axis) and film in um (right axis) over x in um.";
  }
  if (vague || cut) figure.description += " The height of the pressure spike is not known.";
  return draw(figure, report::Place::file);
}

std::optional<std::string> bearing_picture(const std::vector<Case>& cases,
                                           const std::vector<std::vector<BearingResult>>& results) {
  const bool alone = cases.size() == 1;
  std::vector<Figure> figures;
  std::vector<std::string> names;
  std::vector<std::vector<BearingCurves>> bearings;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    std::vector<BearingCurves> laws = curves_of(results[k]);
    if (laws.empty()) continue;
    names.push_back(shown(cases[k].id));
    Figure figure = over_azimuth(fmt::format("bearing-{}", k), alone ? "" : names.back(), laws);
    figure.width = alone ? 520 : width_of_several;
    for (Panel& panel : figure.panels) panel.height = alone ? 170 : 160;
    figures.push_back(std::move(figure));
    bearings.push_back(std::move(laws));
  }
  if (figures.empty()) return std::nullopt;
  share_axes(figures);
  std::vector<std::string> tiles;
  const std::string down = "the external load points down";
  const bool polar = bearings.size() <= most_columns;
  if (alone)
    tiles = {
        draw(polar_plot("polar", "Contact force of each roller; " + down, bearings.front(), 0), report::Place::page)};
  else if (polar)
    tiles = polar_tiles(names, bearings);
  for (const Figure& figure : figures) tiles.push_back(draw(figure, report::Place::page));
  const report::Picture frame{.id = "bearing",
                              .title = "Forces and displacements of the rollers",
                              .description = "Contact force and displacement of each roller, a curve a law."};
  return report::mosaic(frame,
                        alone   ? shown(cases.front().id + ": " + cases.front().title)
                        : polar ? "Contact forces and displacements over the azimuth; " + down
                                : "Contact forces and displacements over the azimuth",
                        tiles, alone ? 2 : std::min(bearings.size(), most_columns));
}

}  // namespace ehd::cli
