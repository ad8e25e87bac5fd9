// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "verification/report/heading.hpp"

namespace ehd::report {

namespace {

constexpr double font = 12, small_font = 11;
constexpr double sample = 28;      // length of a line in the legend
constexpr double stretch = 1.12;   // DejaVu Sans, where Helvetica is missing, is that much wider than text_width()
constexpr double drawn_to = 0.08;  // pixels by which a simplified line may leave the curve

std::vector<double> values_on(const Panel& panel, bool right) {
  std::vector<double> values;
  for (const Series& series : panel.series) {
    if (series.right == right) values.insert(values.end(), series.y.begin(), series.y.end());
  }
  if (right) return values;
  for (const Rule& rule : panel.rules) values.push_back(rule.y);
  for (const SlopeTriangle& one : panel.triangles) {
    values.push_back(one.y);
    values.push_back(one.y * std::pow(one.factor, -one.order));
  }
  return values;
}

Range range_for(const Axis& axis, const std::vector<double>& values) {
  Range range = range_of(values, axis.scale);
  if (axis.low) range.low = *axis.low;
  if (axis.high) range.high = *axis.high;
  if (!(range.low < range.high)) range.high = axis.scale == Scale::linear ? range.low + 1 : range.low * 10;
  return range;
}

std::vector<Tick> ticks_for(const Axis& axis, const Range& range, int wanted) {
  if (axis.scale == Scale::logarithmic) return log_ticks(range, wanted + 2);
  return linear_ticks(range, axis.step.value_or(tick_step(range, wanted)));
}

/// As many ticks as there is room for their labels, at most about `wanted`.
std::vector<Tick> ticks_with_room(const Axis& axis, const Range& range, int wanted, const Mapping& to_pixel,
                                  const std::function<double(const std::string&)>& room) {
  std::vector<Tick> ticks = ticks_for(axis, range, wanted);
  Axis thinner = axis;
  for (int fewer = wanted - 1; fewer > 0 && labels_touch(ticks, to_pixel, room); --fewer) {
    if (thinner.step) *thinner.step *= 2;
    ticks = ticks_for(thinner, range, fewer);
  }
  return ticks;
}

std::string line_svg(Point from, Point to, const char* css) {
  return fmt::format("<path class=\"{}\" d=\"{}\"/>", css, path_data({from, to}));
}

double tick_label_width(const std::vector<Tick>& ticks) {
  double width = 0;
  for (const Tick& tick : ticks) width = std::max(width, text_width(tick.label, small_font));
  return width;
}

struct Drawn {
  std::string svg;
  double height = 0;
};

struct Margins {
  double left = 0, right = 0;
};

struct Ready {  ///< a panel with its axes known
  Range x, y, right;
  std::vector<Tick> x_ticks = {}, y_ticks = {}, right_ticks = {};
};

/// Ranges, and the ticks of the vertical axes. Those of x have to know how wide the frame is.
Ready ready(const Panel& panel) {
  std::vector<double> xs;
  for (const Series& series : panel.series) xs.insert(xs.end(), series.x.begin(), series.x.end());
  for (const SlopeTriangle& one : panel.triangles) {
    xs.push_back(one.x);
    xs.push_back(one.x * one.factor);
  }
  Ready axes;
  axes.x = range_for(panel.x, xs);
  axes.y = range_for(panel.y, values_on(panel, false));
  // Six, so that the whole steps to which range_of widens are steps of the ticks.
  const int wanted = panel.height < 150 ? 3 : 6;
  const auto upward = [&](const Axis& axis, const Range& range) {
    const auto line_height = [](const std::string&) { return small_font + 3; };
    return ticks_with_room(axis, range, wanted, Mapping(axis.scale, range, panel.height, 0), line_height);
  };
  axes.y_ticks = upward(panel.y, axes.y);
  if (panel.right) {
    axes.right = range_for(*panel.right, values_on(panel, true));
    axes.right_ticks = upward(*panel.right, axes.right);
  }
  return axes;
}

std::vector<Tick> x_ticks_in(const Panel& panel, const Range& range, double width) {
  constexpr double gap = 8;
  const auto room = [](const std::string& label) { return stretch * text_width(label, small_font) + gap; };
  return ticks_with_room(panel.x, range, 6, Mapping(panel.x.scale, range, 0, width), room);
}

/// Not so where p is NaN.
bool shown(Point p, const Box& box) {
  constexpr double edge = 0.5;  // pixels: a mark on the frame counts
  return p.x >= box.left - edge && p.x <= box.right + edge && p.y >= box.top - edge && p.y <= box.bottom + edge;
}

/// What the page's script needs to read, zoom and save a curve: its points as "x,y", "-" where it is broken, and which
/// of them have a mark, unless all have one.
std::string page_data(const Series& series, const std::vector<Point>& points, const Box& box) {
  std::string values, marked;
  std::size_t marks = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) values += ' ';
    values += std::isfinite(series.x[i]) && std::isfinite(series.y[i])
                  ? fmt::format("{:.7g},{:.7g}", series.x[i], series.y[i])
                  : "-";
    if (!shown(points[i], box)) continue;
    marked += (marks == 0 ? "" : " ") + std::to_string(i);
    ++marks;
  }
  std::string data = fmt::format(" data-name=\"{}\" data-values=\"{}\"",
                                 escaped(markup_to_text(series.name.empty() ? series.of : series.name)), values);
  if (series.right) data += " data-right=\"1\"";
  if (series.marker != Marker::none && marks < points.size()) data += " data-marked=\"" + marked + "\"";
  return data;
}

std::string series_svg(const Series& series, std::size_t key, const Mapping& to_x, const Mapping& to_y, const Box& box,
                       Place place) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i)
    points.push_back({to_x(series.x[i]), to_y(series.y[i])});

  std::string d;
  if (series.line != Line::none) {
    for (const auto& piece : pieces(points, box)) d += path_data(simplified(piece, drawn_to));
  }
  std::string svg = fmt::format("<g class=\"series s{}\" data-key=\"{}\"", series.colour, key);
  if (place == Place::page) svg += page_data(series, points, box);
  svg += ">";
  if (!d.empty()) svg += fmt::format("<path class=\"line\" d=\"{}\"{}/>", d, dash_attribute(series.line));
  Point last;
  bool any = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    if (!shown(p, box)) continue;
    svg += marker_svg(series.marker, p, i < series.hollow_at.size() ? series.hollow_at[i] : series.hollow, series.size);
    last = p;
    any = true;
  }
  if (any && !series.end.empty()) {
    const double width = text_width(series.end, small_font);
    const bool fits = last.x + 6 + width <= box.right;
    svg += text_svg({fits ? last.x + 6 : last.x - 6, last.y + (fits ? 4 : -6)}, series.end, fits ? "start" : "end",
                    "small halo label");
  }
  return svg + "</g>\n";
}

std::string triangle_svg(const SlopeTriangle& one, const Mapping& to_x, const Mapping& to_y) {
  const Point a{to_x(one.x), to_y(one.y)};
  const Point b{to_x(one.x * one.factor), to_y(one.y * std::pow(one.factor, -one.order))};
  if (!std::isfinite(a.x + a.y + b.x + b.y)) return "";
  return fmt::format("<g class=\"slope\"><path class=\"axis\" d=\"{}\"/>{}</g>", path_data({a, {a.x, b.y}, b, a}),
                     text_svg({a.x - 4, (a.y + b.y) / 2 + 4}, number_markup(one.order, 3), "end", "small halo"));
}

/// The names of the series in rows above the frame. Series of one name share a key: the name's place in `names`.
Drawn legend_svg(const Panel& panel, double left, double right, double top, std::vector<std::string>& names) {
  LegendRows rows(left, right, top);
  std::string svg;
  for (const Series& series : panel.series) {
    if (series.name.empty()) continue;
    auto known = std::find(names.begin(), names.end(), series.name);
    if (known == names.end()) known = names.insert(names.end(), series.name);
    const Point corner = rows.next(sample + 6 + stretch * text_width(series.name, font) + 16);
    const double x = corner.x, y = corner.y + 7;
    svg += fmt::format("<g class=\"key s{}\" data-key=\"{}\">", series.colour, known - names.begin());
    const Line line = series.key_line.value_or(series.line);
    if (line != Line::none)
      svg +=
          fmt::format("<path class=\"line\" d=\"{}\"{}/>", path_data({{x, y}, {x + sample, y}}), dash_attribute(line));
    svg += marker_svg(series.marker, {x + sample / 2, y}, series.hollow, series.size) +
           text_svg({x + sample + 5, y + 4}, series.name, "start") + "</g>\n";
  }
  return {svg, svg.empty() ? 0 : rows.last_top() + LegendRows::height - top};
}

/// Grid, ticks and labels of a panel, as path data and texts.
struct AxisMarks {
  std::string grid, ticks, labels;
};

constexpr double major_tick = 5, minor_tick = 3;  // pixels
constexpr double tick_edge = 0.5;                 // pixels by which a tick may lie outside the frame

void add_x_ticks(AxisMarks& marks, const std::vector<Tick>& ticks, const Mapping& to_x, const Box& box) {
  for (const Tick& tick : ticks) {
    const double at = to_x(tick.value);
    if (!(at >= box.left - tick_edge && at <= box.right + tick_edge)) continue;
    const bool major = !tick.label.empty();
    marks.ticks += path_data({{at, box.bottom}, {at, box.bottom - (major ? major_tick : minor_tick)}});
    if (!major) continue;
    marks.grid += path_data({{at, box.top}, {at, box.bottom}});
    marks.labels += text_svg({at, box.bottom + 15}, tick.label, "middle", "small");
  }
}

/// The axis on the right has no grid of its own.
void add_y_ticks(AxisMarks& marks, const std::vector<Tick>& ticks, const Mapping& to_y, const Box& box, bool right) {
  const double edge = right ? box.right : box.left, inwards = right ? -1 : 1;
  for (const Tick& tick : ticks) {
    const double at = to_y(tick.value);
    if (!(at >= box.top - tick_edge && at <= box.bottom + tick_edge)) continue;
    const bool major = !tick.label.empty();
    marks.ticks += path_data({{edge, at}, {edge + inwards * (major ? major_tick : minor_tick), at}});
    if (!major) continue;
    if (!right) marks.grid += path_data({{box.left, at}, {box.right, at}});
    marks.labels += text_svg({edge - 6 * inwards, at + 4}, tick.label, right ? "start" : "end", "small");
  }
}

/// An axis as the page's script reads it: its label, its ends (first the one at the left or at the bottom), its scale.
std::string axis_data(const std::string& name, const Axis& axis, const Range& range) {
  const double first = axis.downward ? range.high : range.low, last = axis.downward ? range.low : range.high;
  return fmt::format(" data-{0}=\"{1}\" data-{0}-range=\"{2:.10g},{3:.10g}\"", name,
                     escaped(markup_to_text(axis.label)), first, last) +
         (axis.scale == Scale::logarithmic ? " data-" + name + "-log=\"1\"" : "");
}

/// The frame with grid, ticks and their labels; in the page also the attributes that the script needs.
std::string frame_svg(const Panel& panel, const Ready& axes, const AxisMarks& marks, const Box& box, Place place) {
  std::string svg = "<g class=\"frame\"";
  if (place == Place::page) {
    svg += fmt::format(" data-box=\"{},{},{},{}\"{}{}{}", pixels(box.left), pixels(box.top), pixels(box.right),
                       pixels(box.bottom), axis_data("x", panel.x, axes.x), axis_data("y", panel.y, axes.y),
                       panel.right ? axis_data("right", *panel.right, axes.right) : "");
  }
  const std::string outline = path_data({{box.left, box.top},
                                         {box.right, box.top},
                                         {box.right, box.bottom},
                                         {box.left, box.bottom},
                                         {box.left, box.top}});
  return fmt::format(
      "{}><path class=\"grid\" d=\"{}\"/><path class=\"axis ticks\" d=\"{}\"/><path class=\"axis\" d=\"{}\"/><g "
      "class=\"ticks-text\">{}</g></g>\n",
      svg, marks.grid, marks.ticks, outline, marks.labels);
}

/// How values become pixels inside a frame.
struct Mappings {
  Mapping x, y, right;
};
Mappings mappings_of(const Panel& panel, const Ready& axes, const Box& box) {
  const double low = panel.y.downward ? box.top : box.bottom, high = panel.y.downward ? box.bottom : box.top;
  return {.x = Mapping(panel.x.scale, axes.x, box.left, box.right),
          .y = Mapping(panel.y.scale, axes.y, low, high),
          .right = Mapping(panel.right ? panel.right->scale : Scale::linear, panel.right ? axes.right : Range{},
                           box.bottom, box.top)};
}

/// Pieces of curves inside a box.
std::size_t curves_in(const Box& box, const Panel& panel, const Mappings& to) {
  std::size_t count = 0;
  for (const Series& series : panel.series) {
    const Mapping& to_y = series.right ? to.right : to.y;
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
      const Point at{to.x(series.x[i]), to_y(series.y[i])};
      const Point from = i > 0 && series.line != Line::none ? Point{to.x(series.x[i - 1]), to_y(series.y[i - 1])} : at;
      if (clipped(from, at, box)) ++count;
    }
  }
  return count;
}

/// The label of a rule: at its right end, at its left one or between them, above it or below, where the fewest curves
/// pass.
std::string rule_label_svg(const Rule& rule, double at, const Panel& panel, const Mappings& to, const Box& box) {
  constexpr double height = 11, mark = 5, edge = 5;  // pixels
  const double width = stretch * text_width(rule.label, small_font);
  struct Spot {
    Point text;
    const char* anchor;
    std::size_t curves;
  };
  std::optional<Spot> best;
  constexpr double places[] = {1, 0, 0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875};  // 0: the left end
  for (const double place : places) {
    const bool right = place == 1;
    for (const bool above : {true, false}) {
      const double first = box.left + edge + 3, last = box.right - edge - width;
      const double base = at + (above ? -4 : height + 2), from = first + place * (last - first);
      if (base - height < box.top || base > box.bottom) continue;
      const Box taken{from - mark, base - height - mark, from + width + mark, base + mark};
      const Spot spot{{right ? box.right - edge : from, base}, right ? "end" : "start", curves_in(taken, panel, to)};
      if (!best || spot.curves < best->curves) best = spot;
    }
  }
  return best ? text_svg(best->text, rule.label, best->anchor, "small halo") : "";
}

/// Rules, slope triangles and curves, and last the labels that no curve may hide.
std::string contents_svg(const Panel& panel, const Mappings& to, const Box& box, Place place,
                         const std::vector<std::string>& names) {
  std::string svg, labels;
  for (const Rule& rule : panel.rules) {
    const double at = to.y(rule.y);
    if (!(at >= box.top && at <= box.bottom)) continue;
    const std::string group = fmt::format("<g class=\"rule-at\" data-value=\"{:.7g}\">", rule.y);
    svg += group + line_svg({box.left, at}, {box.right, at}, "rule") + "</g>";
    if (!rule.label.empty()) labels += group + rule_label_svg(rule, at, panel, to, box) + "</g>";
  }
  for (const SlopeTriangle& one : panel.triangles) svg += triangle_svg(one, to.x, to.y);
  bool drawn = false;
  std::vector<Series> series_by_size = panel.series;
  std::stable_sort(series_by_size.begin(), series_by_size.end(),
                   [](const Series& a, const Series& b) { return a.size < b.size; });
  for (const Series& series : series_by_size) {
    const auto known = std::find(names.begin(), names.end(), series.name.empty() ? series.of : series.name);
    const auto key = static_cast<std::size_t>(known - names.begin());
    svg += series_svg(series, key, to.x, series.right ? to.right : to.y, box, place);
    drawn = drawn || !series.x.empty();
  }
  svg += labels;
  if (!drawn) svg += text_svg({(box.left + box.right) / 2, (box.top + box.bottom) / 2}, "no data", "middle", "soft");
  return svg;
}

Drawn draw_panel(const Panel& panel, const Ready& axes, const Margins& margins, double width, double top, Place place,
                 std::vector<std::string>& names) {
  std::string svg;
  double y = top;
  if (!panel.title.empty()) {
    const Heading title = heading_of(panel.title, width, y + 13);
    svg += title.svg;
    y += 18 + title.more;
  }
  const Drawn legend = legend_svg(panel, margins.left, width - 6, y, names);
  svg += legend.svg;
  y += legend.height;
  y += 8;
  const Box box{margins.left, y, width - margins.right, y + panel.height};

  const Mappings to = mappings_of(panel, axes, box);
  AxisMarks marks;
  add_x_ticks(marks, axes.x_ticks, to.x, box);
  add_y_ticks(marks, axes.y_ticks, to.y, box, false);
  add_y_ticks(marks, axes.right_ticks, to.right, box, true);
  svg += "<g class=\"panel\">" + frame_svg(panel, axes, marks, box, place);

  const double middle = (box.top + box.bottom) / 2;
  const auto upright = [&](double at, const std::string& label) {
    return text_svg({at, middle}, label, "middle", "axis-label",
                    fmt::format(" transform=\"rotate(-90 {} {})\"", pixels(at), pixels(middle)));
  };
  svg += upright(14, panel.y.label);
  if (panel.right) svg += upright(width - 6, panel.right->label);
  double end = box.bottom + 18;
  if (!panel.x.label.empty() && !panel.x.silent) {
    svg += text_svg({(box.left + box.right) / 2, box.bottom + 33}, panel.x.label, "middle", "axis-label");
    end = box.bottom + 38;
  }
  return {svg + contents_svg(panel, to, box, place, names) + "</g>\n", end - top};
}

}  // namespace

std::string draw(const Figure& figure, Place place) {
  Margins margins{.left = 0, .right = 14};
  std::vector<Ready> axes;
  for (const Panel& panel : figure.panels) {
    axes.push_back(ready(panel));
    margins.left = std::max(margins.left, 14 + 16 + tick_label_width(axes.back().y_ticks));
    if (panel.right) margins.right = std::max(margins.right, 20 + 16 + tick_label_width(axes.back().right_ticks));
  }
  margins.left = std::max(margins.left, 46.0);
  for (std::size_t i = 0; i < axes.size(); ++i)
    axes[i].x_ticks = x_ticks_in(figure.panels[i], axes[i].x, figure.width - margins.left - margins.right);
  std::vector<std::string> names;
  std::string content;
  double top = 4;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const Drawn drawn = draw_panel(figure.panels[i], axes[i], margins, figure.width, top, place, names);
    content += drawn.svg;
    top += drawn.height + 8;
  }
  return picture({figure.id, figure.title, figure.description, figure.width, top}, content, place);
}

}  // namespace ehd::report
