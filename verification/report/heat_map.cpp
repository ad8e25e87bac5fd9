// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/heat_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ehd::report {

namespace {

constexpr double row_height = 27;  // pixels

using Rgb = std::array<double, 3>;

Rgb between(const Rgb& a, const Rgb& b, double share) {
  Rgb mixed{};
  for (std::size_t i = 0; i < 3; ++i) mixed[i] = a[i] + share * (b[i] - a[i]);
  return mixed;
}

/// Lightness falls evenly, so that the map stays readable in grey.
Rgb sequential(double share) {
  constexpr Rgb light{247, 250, 252}, middle{122, 174, 208}, dark{14, 58, 110};
  return share < 0.5 ? between(light, middle, 2 * share) : between(middle, dark, 2 * share - 1);
}

/// Blue below, orange above. In grey the two look alike; the sign stands in the cell.
Rgb diverging(double share) {
  constexpr Rgb below{34, 92, 160}, middle{250, 250, 250}, above{176, 78, 10};
  return share < 0 ? between(middle, below, -share) : between(middle, above, share);
}

/// Relative luminance (WCAG 2.1).
double luminance(const Rgb& colour) {
  const auto linear = [](double part) {
    part /= 255;
    return part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2]);
}

std::string hex(const Rgb& colour) {
  const auto byte = [](double part) { return static_cast<unsigned>(std::lround(part)) & 0xffU; };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour[0]), byte(colour[1]), byte(colour[2]));
}

/// The colour of each value, from the range of all.
class Palette {
 public:
  explicit Palette(const HeatMap& map) : map_(map) {
    for (const Cell& cell : map.cells) {
      const double value = shown(cell.value);
      if (!std::isfinite(value)) continue;
      low_ = std::min(low_, value);
      high_ = std::max(high_, value);
    }
  }
  [[nodiscard]] std::optional<Rgb> operator()(const std::optional<double>& value) const {
    const double at = shown(value);
    if (!std::isfinite(at)) return std::nullopt;
    if (map_.colours == Colours::diverging)
      return diverging(std::clamp(map_.limit > 0 ? at / map_.limit : 0.0, -1.0, 1.0));
    return sequential(high_ > low_ ? (at - low_) / (high_ - low_) : 0.3);
  }

 private:
  [[nodiscard]] double shown(const std::optional<double>& value) const {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    if (!value || !std::isfinite(*value)) return nothing;
    if (!map_.logarithmic) return *value;
    return *value > 0 ? std::log(*value) : nothing;
  }
  const HeatMap& map_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

/// From the indices (i, j) of contour_lines, which may be fractions, to pixels: cell centres are evenly spaced.
struct CellGrid {
  Box box;
  std::size_t columns = 0, rows = 0;
  [[nodiscard]] double cell_width() const { return (box.right - box.left) / static_cast<double>(columns); }
  [[nodiscard]] double cell_height() const { return (box.bottom - box.top) / static_cast<double>(rows); }
  [[nodiscard]] Point at(Point index) const {
    return {box.left + (index.x + 0.5) * cell_width(), box.bottom - (index.y + 0.5) * cell_height()};
  }
};

std::string contours_svg(const HeatMap& map, const CellGrid& grid) {
  std::vector<double> values;
  for (const Cell& cell : map.cells) {
    const double value = cell.value.value_or(std::numeric_limits<double>::quiet_NaN());
    values.push_back(map.logarithmic ? (value > 0 ? std::log(value) : std::numeric_limits<double>::quiet_NaN())
                                     : value);
  }
  std::string svg;
  std::vector<Point> labels;
  for (const ContourLevel& level : map.contours) {
    std::string d;
    std::vector<Point> ends;
    const double at = map.logarithmic ? std::log(level.value) : level.value;
    for (const auto& line : contour_lines(values, map.x.size(), map.y.size(), at)) {
      std::vector<Point> points;
      for (const Point& index : line) points.push_back(grid.at(index));
      d += path_data(points);
      ends.push_back(points.front());
      ends.push_back(points.back());
    }
    if (d.empty()) continue;
    svg += fmt::format(
        "<path class=\"contour-halo\" stroke-width=\"4\" d=\"{}\"/><path class=\"contour\" stroke-width=\"1.6\" "
        "d=\"{}\"{}/>",
        d, d, dash_attribute(level.line));
    if (level.label.empty()) continue;
    // The label stands right of the map, at the line's rightmost end: on the map it would hide a number.
    const Point end = *std::max_element(ends.begin(), ends.end(), [](Point a, Point b) { return a.x < b.x; });
    if (grid.box.right - end.x > grid.cell_width()) continue;
    const Point place{grid.box.right + 5, end.y + 4};
    const bool free =
        std::none_of(labels.begin(), labels.end(), [&](Point other) { return std::abs(other.y - place.y) < 12; });
    if (!free) continue;
    svg += text_svg(place, level.label, "start", "small");
    labels.push_back(place);
  }
  return svg;
}

/// A cell's number in dark or white ink. Its rim has the cell's colour, so that contour lines do not cross the number.
std::string number_svg(const Cell& cell, const std::optional<Rgb>& colour, Point centre, double width) {
  // Where white and black have the same contrast to the cell, 4.58; elsewhere the better one has more. AA asks for 4.5.
  constexpr double dark = 0.179;
  const bool white = colour && luminance(*colour) < dark;
  const std::string ink =
      colour ? fmt::format(" style=\"fill:{};stroke:{}\"", white ? "#fff" : "#000", hex(*colour)) : std::string();
  const double size = std::min(10.5, 10.5 * (width - 3) / std::max(1.0, text_width(literal(cell.text), 10.5)));
  return text_svg({centre.x, centre.y + 3.6}, literal(cell.text), "middle", "cell-text",
                  fmt::format("{} font-size=\"{}\"", ink, pixels(size)));
}

/// What the page's script needs: the read-out, and x, y, value to save.
std::string page_data(const Cell& cell, double x, double y) {
  return fmt::format(" data-hint=\"{}\" data-row=\"{}\"", escaped(cell.hint),
                     cell.value && std::isfinite(*cell.value) ? fmt::format("{:.7g},{:.7g},{:.9g}", x, y, *cell.value)
                                                              : fmt::format("{:.7g},{:.7g},", x, y));
}

struct Cells {
  std::string svg;
  std::string numbers;  ///< drawn over the contour lines
  bool hatched = false;
};
Cells cells_svg(const HeatMap& map, const CellGrid& grid, const std::string& hatch, Place place) {
  const Palette palette(map);
  const double w = grid.cell_width(), h = grid.cell_height();
  Cells drawn;
  for (std::size_t j = 0; j < map.y.size(); ++j) {
    for (std::size_t i = 0; i < map.x.size(); ++i) {
      const std::size_t at = j * map.x.size() + i;
      if (at >= map.cells.size()) continue;
      const Cell& cell = map.cells[at];
      const Point centre = grid.at({static_cast<double>(i), static_cast<double>(j)});
      const std::string rectangle =
          fmt::format("x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"", pixels(centre.x - w / 2),
                      pixels(centre.y - h / 2), pixels(w), pixels(h));
      const auto colour = palette(cell.value);
      drawn.svg += fmt::format("<g class=\"datum\"{}><rect {}{}/>",
                               place == Place::page ? page_data(cell, map.x[i], map.y[j]) : "", rectangle,
                               colour ? " class=\"cell\" fill=\"" + hex(*colour) + "\"" : " class=\"blank\"");
      if (cell.hatched && colour) {
        drawn.svg += fmt::format("<rect {} class=\"cell\" fill=\"url(#{})\"/>", rectangle, escaped(hatch));
        drawn.hatched = true;
      }
      if (!cell.text.empty()) drawn.numbers += number_svg(cell, colour, centre, w);
      drawn.svg += "</g>\n";
    }
  }
  return drawn;
}

std::string hatch_svg(const std::string& hatch) {
  return "<defs><pattern id=\"" + escaped(hatch) +
         "\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><path "
         "d=\"M0 0L0 6\" stroke=\"#000\" stroke-width=\"1.1\" stroke-opacity=\".38\"/></pattern></defs>";
}

/// Numbers and names along both axes.
std::string axes_svg(const HeatMap& map, const CellGrid& grid) {
  const Box& box = grid.box;
  std::string svg;
  for (std::size_t i = 0; i < map.x.size(); ++i)
    svg +=
        text_svg({grid.at({static_cast<double>(i), 0}).x, box.bottom + 14}, number_markup(map.x[i]), "middle", "small");
  for (std::size_t j = 0; j < map.y.size(); ++j)
    svg +=
        text_svg({box.left - 6, grid.at({0, static_cast<double>(j)}).y + 4}, number_markup(map.y[j]), "end", "small");
  const double middle = (box.top + box.bottom) / 2;
  return svg + text_svg({(box.left + box.right) / 2, box.bottom + 31}, map.x_label) +
         text_svg({16, middle}, map.y_label, "middle", "", " transform=\"rotate(-90 16 " + pixels(middle) + ")\"");
}

/// The legend of lines and hatching, in rows below the map.
struct Keys {
  std::string svg;
  double bottom = 0;
};
Keys keys_svg(const HeatMap& map, const CellGrid& grid, const std::string& hatch, bool hatched) {
  LegendRows rows(grid.box.left, map.width, grid.box.bottom + 38);
  std::string svg;
  for (const auto& [line, label] : map.keys) {
    const auto [x, y] = rows.next(44 + text_width(label, 12));
    svg += fmt::format("<path class=\"axis\" stroke-width=\"1.6\" d=\"{}\"{}/>{}",
                       path_data({{x, y + 8}, {x + 26, y + 8}}), dash_attribute(line),
                       text_svg({x + 31, y + 12}, label, "start"));
  }
  if (hatched) {
    const std::string label = "hatched: *p*_{H} > 4 GPa, a numerical test";
    const auto [x, y] = rows.next(40 + text_width(label, 12));
    const std::string place = fmt::format("x=\"{}\" y=\"{}\" width=\"22\" height=\"13\"", pixels(x), pixels(y + 1));
    svg += fmt::format("<rect class=\"blank\" {} style=\"fill:#f4f4f4\"/><rect {} fill=\"url(#{})\"/>{}", place, place,
                       escaped(hatch), text_svg({x + 27, y + 12}, label, "start"));
  }
  return {svg, rows.last_top() + (svg.empty() ? 0 : 20)};
}

}  // namespace

std::vector<std::vector<Point>> contour_lines(const std::vector<double>& values, std::size_t columns, std::size_t rows,
                                              double level) {
  if (columns < 2 || rows < 2 || values.size() != columns * rows) return {};
  // Each crossing lies on a grid edge. An edge is named by its lower node and its direction, so that the two squares
  // beside the edge name the same crossing.
  struct Segment {
    std::size_t from, to;  // edges
    bool used = false;
  };
  const auto value = [&](std::size_t i, std::size_t j) { return values[j * columns + i]; };
  const auto edge = [&](std::size_t i, std::size_t j, bool up) { return 2 * (j * columns + i) + (up ? 1U : 0U); };
  std::vector<Segment> segments;
  for (std::size_t j = 0; j + 1 < rows; ++j) {
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const double a = value(i, j), b = value(i + 1, j), c = value(i + 1, j + 1), d = value(i, j + 1);
      if (!std::isfinite(a + b + c + d)) continue;
      const bool above_a = a > level, above_b = b > level, above_c = c > level, above_d = d > level;
      const std::size_t low = edge(i, j, false), right = edge(i + 1, j, true), high = edge(i, j + 1, false),
                        left = edge(i, j, true);
      std::vector<std::size_t> crossed;
      if (above_a != above_b) crossed.push_back(low);
      if (above_b != above_c) crossed.push_back(right);
      if (above_c != above_d) crossed.push_back(high);
      if (above_d != above_a) crossed.push_back(left);
      if (crossed.size() == 2) segments.push_back({crossed[0], crossed[1]});
      if (crossed.size() == 4) {  // a saddle: the mean value decides which corners are joined
        const bool middle = (a + b + c + d) / 4 > level;
        if (middle == above_a) {
          segments.push_back({low, right});
          segments.push_back({high, left});
        } else {
          segments.push_back({low, left});
          segments.push_back({right, high});
        }
      }
    }
  }
  const auto point = [&](std::size_t name) {
    const bool up = name % 2 == 1;
    const std::size_t i = (name / 2) % columns, j = (name / 2) / columns;
    const double from = value(i, j), to = up ? value(i, j + 1) : value(i + 1, j);
    const double share = (level - from) / (to - from);
    return Point{static_cast<double>(i) + (up ? 0 : share), static_cast<double>(j) + (up ? share : 0)};
  };
  std::vector<std::vector<Point>> lines;
  for (Segment& start : segments) {
    if (start.used) continue;
    start.used = true;
    std::vector<std::size_t> chain{start.from, start.to};
    for (int side = 0; side < 2; ++side) {
      for (bool grown = true; grown;) {
        grown = false;
        for (Segment& next : segments) {
          if (next.used || (next.from != chain.back() && next.to != chain.back())) continue;
          next.used = true;
          chain.push_back(next.from == chain.back() ? next.to : next.from);
          grown = true;
          break;
        }
      }
      std::reverse(chain.begin(), chain.end());
    }
    std::vector<Point> line;
    for (const std::size_t name : chain) line.push_back(point(name));
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string draw(const HeatMap& map, Place place) {
  const double left = 58, right = map.width - (map.contours.empty() || map.contours.front().label.empty() ? 10 : 52);
  double top = 8;
  std::string svg;
  if (!map.heading.empty()) {
    svg += text_svg({8, 17}, map.heading, "start", "head");
    top = 26;
  }
  const CellGrid grid{
      {left, top, right, top + row_height * static_cast<double>(map.y.size())}, map.x.size(), map.y.size()};
  const std::string hatch = map.id + "-hatch";
  const Cells cells = cells_svg(map, grid, hatch, place);
  if (cells.hatched) svg += hatch_svg(hatch);
  svg += cells.svg + contours_svg(map, grid) + cells.numbers + axes_svg(map, grid);
  const Keys keys = keys_svg(map, grid, hatch, cells.hatched);
  return picture({map.id, map.title, map.description, map.width, keys.bottom, {map.x_label, map.y_label, map.heading}},
                 svg + keys.svg, place);
}

}  // namespace ehd::report
