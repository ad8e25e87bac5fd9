// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/polar_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/report/heading.hpp"

namespace ehd::report {

namespace {

constexpr int spoke_deg = 30;

/// The circle that the loads are drawn in.
struct Dial {
  Point centre;
  double radius = 0;  ///< pixels
  double full = 1;    ///< the value at that radius

  [[nodiscard]] Point at(double angle_deg, double value) const {
    const double angle = angle_deg * std::numbers::pi / 180, r = radius * value / full;
    return {centre.x + r * std::sin(angle), centre.y + r * std::cos(angle)};
  }
};

std::string legend_svg(const PolarPlot& plot, LegendRows& rows) {
  std::string svg;
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const PolarSeries& series = plot.series[k];
    const auto [x, y] = rows.next(28 + 6 + text_width(series.name, 12) + 14);
    svg +=
        fmt::format("<g class=\"key s{}\" data-key=\"{}\"><path class=\"line\" d=\"{}\"{}/>{}{}</g>\n", series.colour,
                    k, path_data({{x, y + 7}, {x + 28, y + 7}}), dash_attribute(series.line),
                    marker_svg(series.marker, {x + 14, y + 7}, true), text_svg({x + 33, y + 11}, series.name, "start"));
  }
  return svg;
}

/// Circles at the ticks, and spokes with their angles.
std::string grid_svg(const Dial& dial, const std::vector<Tick>& ticks) {
  std::string svg;
  for (const Tick& tick : ticks) {
    if (!(tick.value > 0)) continue;
    svg += fmt::format("<circle class=\"grid\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>", pixels(dial.centre.x),
                       pixels(dial.centre.y), pixels(dial.radius * tick.value / dial.full));
  }
  for (int angle = 0; angle < 360; angle += spoke_deg) {
    svg += "<path class=\"grid\" d=\"" + path_data({dial.centre, dial.at(angle, dial.full)}) + "\"/>";
    const Point label = dial.at(angle, dial.full * (1 + 17 / dial.radius));
    const int shown = angle > 180 ? angle - 360 : angle;
    svg += text_svg({label.x, label.y + 4}, fmt::format("{}{}\u00b0", shown < 0 ? "\u2212" : "", std::abs(shown)),
                    "middle", "small soft");
  }
  return svg;
}

/// A closed curve through the loads of one law, with a marker at each.
std::string series_svg(const PolarSeries& series, std::size_t key, const Dial& dial, Place place) {
  struct Spot {
    double angle;
    Point at;
    double value;
  };
  std::vector<Spot> spots;
  for (std::size_t i = 0; i < std::min(series.angle_deg.size(), series.radius.size()); ++i) {
    const double turned = std::fmod(std::fmod(series.angle_deg[i], 360) + 360, 360);
    const Point p = dial.at(turned, std::max(0.0, series.radius[i]));
    if (std::isfinite(p.x + p.y)) spots.push_back({turned, p, series.radius[i]});
  }
  std::sort(spots.begin(), spots.end(), [](const Spot& a, const Spot& b) { return a.angle < b.angle; });
  std::vector<Point> outline;
  std::string marks;
  for (const Spot& spot : spots) {
    outline.push_back(spot.at);
    const std::string hint =
        fmt::format("{:.4g}\u00b0: {:.5g}", spot.angle > 180 ? spot.angle - 360 : spot.angle, spot.value);
    marks += fmt::format("<g class=\"datum\"{}>{}</g>",
                         place == Place::page
                             ? fmt::format(" data-hint=\"{}, {}{}", escaped(markup_to_text(series.name)), hint,
                                           fmt::format("\" data-row=\"{:.7g},{:.7g}\"", spot.angle, spot.value))
                             : std::string(),
                         marker_svg(series.marker, spot.at, true));
  }
  if (!outline.empty()) outline.push_back(outline.front());
  return fmt::format("<g class=\"series s{}\" data-key=\"{}{}\"><path class=\"line\" d=\"{}\"{}/>{}</g>\n",
                     series.colour, key,
                     place == Place::page ? "\" data-name=\"" + escaped(markup_to_text(series.name)) : std::string(),
                     path_data(outline), dash_attribute(series.line), marks);
}

}  // namespace

std::string draw(const PolarPlot& plot, Place place) {
  std::string svg;
  double y = 4;
  if (!plot.heading.empty()) {
    const Heading heading = heading_of(plot.heading, plot.width, y + 13);
    svg += heading.svg;
    y += 20 + heading.more;
  }
  LegendRows legend(10, plot.width, y);
  svg += legend_svg(plot, legend);
  y = legend.last_top() + LegendRows::height + 24;
  std::vector<double> values{0, plot.reaches};
  for (const PolarSeries& series : plot.series) values.insert(values.end(), series.radius.begin(), series.radius.end());
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, value);
  constexpr double least = 1e-300;      // below, a step would be no number
  if (!(largest > least)) largest = 1;  // no load at all
  constexpr int circles = 6;            // at most: with fewer, the outer one may lie far beyond the loads
  constexpr double touching = 1e-9;     // of a step: a load on a circle needs no further one
  const double step = tick_step({0, largest}, circles);
  const Range range{0, step * std::ceil(largest / step - touching)};
  const auto ticks = linear_ticks(range, step);
  const double radius = (plot.width - 84) / 2;
  const Dial dial{.centre = {plot.width / 2, y + radius}, .radius = radius, .full = range.high};
  svg += grid_svg(dial, ticks);
  for (std::size_t k = 0; k < plot.series.size(); ++k) svg += series_svg(plot.series[k], k, dial, place);
  // The scale is drawn last and between two spokes, so that no curve hides it.
  for (const Tick& tick : ticks) {
    if (!(tick.value > 0) || tick.value > range.high * (1 + 1e-9)) continue;
    const Point label = dial.at(-105, tick.value);
    svg += text_svg({label.x, label.y + 4}, tick.label, "middle", "small halo");
  }
  const double bottom = dial.centre.y + radius + 30;
  svg += text_svg({plot.width / 2, bottom + 10}, plot.radius_label);
  return picture({plot.id, plot.title, plot.description, plot.width, bottom + 18, {"azimuth [deg]", plot.radius_label}},
                 svg, place);
}

}  // namespace ehd::report
