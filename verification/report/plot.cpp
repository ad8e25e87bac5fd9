// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/plot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace ehd::report {

namespace {

constexpr double font = 12, small_font = 11;
constexpr double legend_row = 17, sample = 28;
constexpr double drawn_to = 0.08;  // pixels by which a simplified line may leave the curve

struct LegendEntry {
  const Series* series = nullptr;
  std::size_t key = 0;  ///< series of one name share it
  double x = 0;
  int row = 0;
};

std::vector<LegendEntry> legend_of(const Panel& panel, double left, double right, std::vector<std::string>& names) {
  std::vector<LegendEntry> entries;
  double x = left;
  int row = 0;
  for (const Series& series : panel.series) {
    if (series.name.empty()) continue;
    auto known = std::find(names.begin(), names.end(), series.name);
    if (known == names.end()) known = names.insert(names.end(), series.name);
    const double width = sample + 6 + text_width(series.name, font) + 16;
    if (x > left && x + width > right) {
      x = left;
      ++row;
    }
    entries.push_back({&series, static_cast<std::size_t>(known - names.begin()), x, row});
    x += width;
  }
  return entries;
}

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

std::string line_svg(Point from, Point to, const char* css) {
  return "<path class=\"" + std::string(css) + "\" d=\"" + path_data({from, to}) + "\"/>";
}

std::string digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
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
  std::vector<Tick> x_ticks, y_ticks, right_ticks;
};

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
  axes.x_ticks = ticks_for(panel.x, axes.x, 6);
  // Six: what range_of widens to whole steps is then whole steps of the ticks.
  const int wanted = panel.height < 150 ? 3 : 6;
  axes.y_ticks = ticks_for(panel.y, axes.y, wanted);
  if (panel.right) {
    axes.right = range_for(*panel.right, values_on(panel, true));
    axes.right_ticks = ticks_for(*panel.right, axes.right, wanted);
  }
  return axes;
}

std::string series_svg(const Series& series, std::size_t key, const Mapping& to_x, const Mapping& to_y, const Box& box,
                       Place place) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i)
    points.push_back({to_x(series.x[i]), to_y(series.y[i])});

  const auto shown = [&](Point p) {
    constexpr double edge = 0.5;
    return p.x >= box.left - edge && p.x <= box.right + edge && p.y >= box.top - edge &&
           p.y <= box.bottom + edge;  // not NaN
  };

  std::string d;
  if (series.line != Line::none) {
    for (const auto& piece : pieces(points, box)) d += path_data(simplified(piece, drawn_to));
  }
  std::string svg =
      "<g class=\"series s" + std::to_string(series.colour) + "\" data-key=\"" + std::to_string(key) + "\"";
  if (place == Place::page) {
    // What the read-out shows: points of the curve with the places where they are drawn.
    std::string values;
    std::vector<std::size_t> index;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (shown(points[i])) index.push_back(i);
    }
    constexpr std::size_t most = 160;
    const std::size_t every = index.size() / most + 1;
    for (std::size_t k = 0; k < index.size(); k += every) {
      const std::size_t i = index[k];
      values += (values.empty() ? "" : " ") + pixels(points[i].x) + "," + pixels(points[i].y) + "," +
                digits(series.x[i]) + "," + digits(series.y[i]);
    }
    svg += " data-name=\"" + escaped(markup_to_text(series.name)) + "\" data-values=\"" + values + "\"" +
           (series.right ? " data-right=\"1\"" : "");
  }
  svg += ">";
  if (!d.empty()) svg += "<path class=\"line\" d=\"" + d + "\"" + dash_attribute(series.line) + "/>";
  Point last;
  bool any = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    if (!shown(p)) continue;
    svg += marker_svg(series.marker, p, i < series.hollow_at.size() ? series.hollow_at[i] : series.hollow);
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
  return "<path class=\"axis\" d=\"" + path_data({a, {a.x, b.y}, b, a}) + "\"/>" +
         text_svg({a.x - 4, (a.y + b.y) / 2 + 4}, number_markup(one.order, 3), "end", "small halo");
}

Drawn draw_panel(const Panel& panel, const Ready& axes, const Margins& margins, double width, double top, Place place,
                 std::vector<std::string>& names) {
  const double left = margins.left, right = width - margins.right;
  std::string svg;
  double y = top;
  if (!panel.title.empty()) {
    y += 16;
    svg += text_svg({8, y - 3}, panel.title, "start", "head");
    y += 2;
  }
  const auto legend = legend_of(panel, left, width - 6, names);
  for (const LegendEntry& entry : legend) {
    const double at = y + legend_row * entry.row + 11;
    const Series& series = *entry.series;
    svg += "<g class=\"key s" + std::to_string(series.colour) + "\" data-key=\"" + std::to_string(entry.key) + "\">";
    const Line line = series.key_line.value_or(series.line);
    if (line != Line::none)
      svg += "<path class=\"line\" d=\"" + path_data({{entry.x, at - 4}, {entry.x + sample, at - 4}}) + "\"" +
             dash_attribute(line) + "/>";
    svg += marker_svg(series.marker, {entry.x + sample / 2, at - 4}, series.hollow) +
           text_svg({entry.x + sample + 5, at}, series.name, "start") + "</g>\n";
  }
  if (!legend.empty()) y += legend_row * (legend.back().row + 1);
  y += 8;
  const Box box{left, y, right, y + panel.height};

  const Mapping to_x(panel.x.scale, axes.x, box.left, box.right),
      to_y(panel.y.scale, axes.y, panel.y.downward ? box.top : box.bottom, panel.y.downward ? box.bottom : box.top);
  std::string grid, marks, labels;
  for (const Tick& tick : axes.x_ticks) {
    const double at = to_x(tick.value);
    if (!(at >= box.left - 0.5 && at <= box.right + 0.5)) continue;
    const bool major = !tick.label.empty();
    if (major) grid += path_data({{at, box.top}, {at, box.bottom}});
    marks += path_data({{at, box.bottom}, {at, box.bottom - (major ? 5.0 : 3.0)}});
    if (major) labels += text_svg({at, box.bottom + 15}, tick.label, "middle", "small");
  }
  for (const Tick& tick : axes.y_ticks) {
    const double at = to_y(tick.value);
    if (!(at >= box.top - 0.5 && at <= box.bottom + 0.5)) continue;
    const bool major = !tick.label.empty();
    if (major) grid += path_data({{box.left, at}, {box.right, at}});
    marks += path_data({{box.left, at}, {box.left + (major ? 5.0 : 3.0), at}});
    if (major) labels += text_svg({box.left - 6, at + 4}, tick.label, "end", "small");
  }
  const Mapping to_right(panel.right ? panel.right->scale : Scale::linear, panel.right ? axes.right : Range{},
                         box.bottom, box.top);
  for (const Tick& tick : axes.right_ticks) {
    const double at = to_right(tick.value);
    if (!(at >= box.top - 0.5 && at <= box.bottom + 0.5)) continue;
    const bool major = !tick.label.empty();
    marks += path_data({{box.right, at}, {box.right - (major ? 5.0 : 3.0), at}});
    if (major) labels += text_svg({box.right + 6, at + 4}, tick.label, "start", "small");
  }
  svg += "<g class=\"frame\"";
  if (place == Place::page) {
    svg += " data-box=\"" + pixels(box.left) + "," + pixels(box.top) + "," + pixels(box.right) + "," +
           pixels(box.bottom) + "\" data-x=\"" + escaped(markup_to_text(panel.x.label)) + "\" data-y=\"" +
           escaped(markup_to_text(panel.y.label)) + "\"" +
           (panel.right ? " data-right=\"" + escaped(markup_to_text(panel.right->label)) + "\"" : "");
  }
  svg += "><path class=\"grid\" d=\"" + grid + "\"/><path class=\"axis\" d=\"" + marks +
         "\"/><path class=\"axis\" d=\"" +
         path_data({{box.left, box.top},
                    {box.right, box.top},
                    {box.right, box.bottom},
                    {box.left, box.bottom},
                    {box.left, box.top}}) +
         "\"/>" + labels + "</g>\n";
  const double middle = (box.top + box.bottom) / 2;
  const auto upright = [&](double at, const std::string& label) {
    return text_svg({at, middle}, label, "middle", "axis-label",
                    " transform=\"rotate(-90 " + pixels(at) + " " + pixels(middle) + ")\"");
  };
  svg += upright(14, panel.y.label);
  if (panel.right) svg += upright(width - 6, panel.right->label);
  double end = box.bottom + 18;
  if (!panel.x.label.empty() && !panel.x.silent) {
    svg += text_svg({(box.left + box.right) / 2, box.bottom + 33}, panel.x.label, "middle", "axis-label");
    end = box.bottom + 38;
  }

  std::string over;  // labels, not to be hidden by curves
  for (const Rule& rule : panel.rules) {
    const double at = to_y(rule.y);
    if (!(at >= box.top && at <= box.bottom)) continue;
    svg += line_svg({box.left, at}, {box.right, at}, "rule");
    if (!rule.label.empty())
      over += text_svg({box.right - 5, at + (at - box.top > 16 ? -4 : 13)}, rule.label, "end", "small halo");
  }
  for (const SlopeTriangle& one : panel.triangles) svg += triangle_svg(one, to_x, to_y);
  bool drawn = false;
  for (const Series& series : panel.series) {
    const auto known = std::find(names.begin(), names.end(), series.name.empty() ? series.of : series.name);
    const auto key = static_cast<std::size_t>(known - names.begin());
    svg += series_svg(series, key, to_x, series.right ? to_right : to_y, box, place);
    drawn = drawn || !series.x.empty();
  }
  svg += over;
  if (!drawn) svg += text_svg({(box.left + box.right) / 2, middle}, "no data", "middle", "soft");
  return {svg, end - top};
}

}  // namespace

std::optional<std::pair<Point, Point>> clipped(Point from, Point to, const Box& box) {
  if (!std::isfinite(from.x + from.y + to.x + to.y)) return std::nullopt;
  double enter = 0, leave = 1;
  const double dx = to.x - from.x, dy = to.y - from.y;
  const auto cut = [&](double direction, double distance) {  // keeps where direction * t <= distance
    if (direction == 0) return distance >= 0;
    const double t = distance / direction;
    if (direction < 0) enter = std::max(enter, t);
    if (direction > 0) leave = std::min(leave, t);
    return enter <= leave;
  };
  if (!cut(-dx, from.x - box.left) || !cut(dx, box.right - from.x) || !cut(-dy, from.y - box.top) ||
      !cut(dy, box.bottom - from.y))
    return std::nullopt;
  const auto at = [&](double t) { return Point{from.x + t * dx, from.y + t * dy}; };
  return std::pair{enter == 0 ? from : at(enter), leave == 1 ? to : at(leave)};
}

std::vector<std::vector<Point>> pieces(const std::vector<Point>& points, const Box& box) {
  std::vector<std::vector<Point>> result;
  bool open = false;  // the last piece ends at points[i - 1]
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto inside = clipped(points[i - 1], points[i], box);
    if (!inside) {
      open = false;
      continue;
    }
    if (!open) result.push_back({inside->first});
    result.back().push_back(inside->second);
    open = inside->second.x == points[i].x && inside->second.y == points[i].y;
  }
  return result;
}

std::vector<Point> simplified(const std::vector<Point>& points, double distance) {
  if (points.size() < 3) return points;
  std::vector<bool> keep(points.size(), false);
  keep.front() = keep.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    const double dx = points[last].x - points[first].x, dy = points[last].y - points[first].y;
    const double length = std::hypot(dx, dy);
    double furthest = distance;
    std::size_t at = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double ax = points[i].x - points[first].x, ay = points[i].y - points[first].y;
      const double t = length > 0 ? std::clamp((ax * dx + ay * dy) / (length * length), 0.0, 1.0) : 0;
      const double away = std::hypot(ax - t * dx, ay - t * dy);
      if (away > furthest) {
        furthest = away;
        at = i;
      }
    }
    if (at == 0) continue;
    keep[at] = true;
    open.emplace_back(first, at);
    open.emplace_back(at, last);
  }
  std::vector<Point> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (keep[i]) result.push_back(points[i]);
  }
  return result;
}

std::string path_data(const std::vector<Point>& points) {
  if (points.size() < 2) return "";
  std::string d;
  for (std::size_t i = 0; i < points.size(); ++i)
    d += (i == 0 ? "M" : "L") + pixels(points[i].x) + " " + pixels(points[i].y);
  return d;
}

std::string marker_svg(Marker marker, Point at, bool hollow) {
  const std::string css = std::string(" class=\"mark") + (hollow ? " hollow" : "") + "\"";
  const auto shape = [&](const std::vector<Point>& corners) {
    return "<path" + css + " d=\"" + path_data(corners) + "Z\"/>";
  };
  const auto strokes = [&](Point a, Point b, Point c, Point d) {
    return "<path" + css + " d=\"" + path_data({a, b}) + path_data({c, d}) + "\"/>";
  };
  const double x = at.x, y = at.y;
  switch (marker) {
    case Marker::none: return "";
    case Marker::circle: return "<circle" + css + " cx=\"" + pixels(x) + "\" cy=\"" + pixels(y) + "\" r=\"3.2\"/>";
    case Marker::square: return shape({{x - 3, y - 3}, {x + 3, y - 3}, {x + 3, y + 3}, {x - 3, y + 3}});
    case Marker::triangle: return shape({{x, y - 4}, {x + 3.6, y + 2.8}, {x - 3.6, y + 2.8}});
    case Marker::diamond: return shape({{x, y - 4.2}, {x + 4.2, y}, {x, y + 4.2}, {x - 4.2, y}});
    case Marker::cross: return strokes({x - 3.2, y - 3.2}, {x + 3.2, y + 3.2}, {x - 3.2, y + 3.2}, {x + 3.2, y - 3.2});
    case Marker::plus: return strokes({x - 4, y}, {x + 4, y}, {x, y - 4}, {x, y + 4});
  }
  return "";
}

std::string dash_attribute(Line line) {
  switch (line) {
    case Line::dashed: return " stroke-dasharray=\"7 4\"";
    case Line::dotted: return " stroke-dasharray=\"1.8 3\"";
    case Line::dash_dot: return " stroke-dasharray=\"9 3 2 3\"";
    case Line::solid:
    case Line::none: break;
  }
  return "";
}

std::string text_svg(Point at, const std::string& markup, const std::string& anchor, const std::string& css,
                     const std::string& more) {
  return "<text x=\"" + pixels(at.x) + "\" y=\"" + pixels(at.y) + "\"" +
         (anchor == "start" ? "" : " text-anchor=\"" + anchor + "\"") + (css.empty() ? "" : " class=\"" + css + "\"") +
         more + ">" + markup_to_svg(markup) + "</text>";
}

std::string draw(const Figure& figure, Place place) {
  Margins margins{.left = 0, .right = 14};
  std::vector<Ready> axes;
  for (const Panel& panel : figure.panels) {
    axes.push_back(ready(panel));
    margins.left = std::max(margins.left, 14 + 12 + tick_label_width(axes.back().y_ticks));
    if (panel.right) margins.right = std::max(margins.right, 20 + 12 + tick_label_width(axes.back().right_ticks));
  }
  margins.left = std::max(margins.left, 46.0);
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
