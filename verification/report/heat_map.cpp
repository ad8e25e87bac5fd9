// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/heat_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "verification/report/contour_lines.hpp"
#include "verification/report/heading.hpp"

namespace ehd::report {

namespace {

constexpr double row_height = 22;      // pixels, at least
constexpr double number_size = 10.5;   // of the type in a cell, where the cell is wide enough
constexpr double other_type = 1.12;    // DejaVu Sans, where Helvetica is missing, is that much wider than text_width()
constexpr double around_number = 2.5;  // pixels between a number and a contour line

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
  std::size_t columns = 0, rows = 0;  ///< as drawn
  bool upright = false;               ///< i runs upward and j to the right
  [[nodiscard]] double cell_width() const { return (box.right - box.left) / static_cast<double>(columns); }
  [[nodiscard]] double cell_height() const { return (box.bottom - box.top) / static_cast<double>(rows); }
  [[nodiscard]] Point at(Point index) const {
    if (upright) std::swap(index.x, index.y);
    return {box.left + (index.x + 0.5) * cell_width(), box.bottom - (index.y + 0.5) * cell_height()};
  }
  [[nodiscard]] Point at(std::size_t i, std::size_t j) const {
    return at(Point{static_cast<double>(i), static_cast<double>(j)});
  }
};

double size_of_number(const std::string& text, double cell_width) {
  return number_size *
         std::min(1.0, (cell_width - 3) / std::max(1.0, other_type * text_width(literal(text), number_size)));
}

/// The boxes of the numbers, with some air: contour lines stay outside.
std::vector<Box> number_boxes(const HeatMap& map, const CellGrid& grid) {
  constexpr double height = 0.36;  // of the type: half of a digit
  std::vector<Box> boxes;
  for (std::size_t at = 0; at < std::min(map.cells.size(), map.x.size() * map.y.size()); ++at) {
    const std::string& text = map.cells[at].text;
    if (text.empty()) continue;
    const double size = size_of_number(text, grid.cell_width());
    const Point centre = grid.at(at % map.x.size(), at / map.x.size());
    const double across = other_type * text_width(literal(text), size) / 2 + around_number,
                 up = height * size + around_number;
    boxes.push_back({centre.x - across, centre.y - up, centre.x + across, centre.y + up});
  }
  return boxes;
}

/// The labels of contour lines stand right of the map or above it, where a line ends: on the map they would hide a
/// number.
class ContourLabels {
 public:
  explicit ContourLabels(const CellGrid& grid) : grid_(grid) {}

  /// The label of a level at one of the ends of its lines; empty where there is no place.
  [[nodiscard]] std::string at_one_of(const std::vector<Point>& ends, const std::string& label) {
    const double width = other_type * text_width(label, 11);
    for (const Point& end : ends) {
      const bool right = grid_.box.right - end.x < 0.6 * grid_.cell_width();
      if (!right && end.y - grid_.box.top > 0.6 * grid_.cell_height()) continue;
      const Point from = right ? Point{grid_.box.right + 5, end.y + 4} : Point{end.x - width / 2, grid_.box.top - 4};
      const Box box{from.x - 3, from.y - 10, from.x + width + 3, from.y + 2};
      const bool free = std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) {
        return box.left < other.right && other.left < box.right && box.top < other.bottom && other.top < box.bottom;
      });
      if (!free) continue;
      taken_.push_back(box);
      return text_svg(from, label, "start", "small contour-label");
    }
    return "";
  }

 private:
  const CellGrid& grid_;
  std::vector<Box> taken_;
};

struct Contours {
  std::string svg;
  std::set<Line> lines = {};  ///< that are drawn: the others have no entry in the legend
};
Contours contours_svg(const HeatMap& map, const CellGrid& grid) {
  std::vector<double> values;
  for (const Cell& cell : map.cells) {
    const double value = cell.value.value_or(std::numeric_limits<double>::quiet_NaN());
    values.push_back(map.logarithmic ? (value > 0 ? std::log(value) : std::numeric_limits<double>::quiet_NaN())
                                     : value);
  }
  constexpr double least = 4;  // pixels of a piece of a line
  const std::vector<Box> numbers = number_boxes(map, grid);
  ContourLabels labels(grid);
  Contours drawn;
  for (const ContourLevel& level : map.contours) {
    std::string d;
    std::vector<Point> ends;
    const double at = map.logarithmic ? std::log(level.value) : level.value;
    for (const auto& line : contour_lines(values, map.x.size(), map.y.size(), at)) {
      std::vector<Point> points;
      for (const Point& index : line) points.push_back(grid.at(index));
      for (const auto& piece : pieces_outside(points, numbers, least)) d += path_data(piece);
      ends.push_back(points.front());
      ends.push_back(points.back());
    }
    if (d.empty()) continue;
    drawn.lines.insert(level.line);
    drawn.svg += fmt::format(
        "<path class=\"contour-halo\" stroke-width=\"4\" d=\"{}\"/><path class=\"contour\" stroke-width=\"{}\" "
        "d=\"{}\"{}/>",
        d, level.line == Line::solid ? "2" : "1.4", d, dash_attribute(level.line));
    if (!level.label.empty()) drawn.svg += labels.at_one_of(ends, level.label);
  }
  return drawn;
}

/// A cell's number in dark or white ink. Its rim has the cell's colour, so that hatching does not cross the number.
std::string number_svg(const Cell& cell, const std::optional<Rgb>& colour, Point centre, double width) {
  // Where white and black have the same contrast to the cell, 4.58; elsewhere the better one has more. AA asks for 4.5.
  constexpr double dark = 0.179;
  const bool white = colour && luminance(*colour) < dark;
  const std::string ink =
      colour ? fmt::format(" style=\"fill:{};stroke:{}\"", white ? "#fff" : "#000", hex(*colour)) : std::string();
  return text_svg({centre.x, centre.y + 3.6}, literal(cell.text), "middle", "cell-text",
                  fmt::format("{} font-size=\"{}\"", ink, pixels(size_of_number(cell.text, width))));
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
  bool hatched = false, blank = false;
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
      const Point centre = grid.at(i, j);
      const std::string rectangle =
          fmt::format("x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"", pixels(centre.x - w / 2),
                      pixels(centre.y - h / 2), pixels(w), pixels(h));
      const auto colour = palette(cell.value);
      drawn.blank = drawn.blank || !colour;
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
  const auto& across = grid.upright ? map.y : map.x;
  const auto& upward = grid.upright ? map.x : map.y;
  std::string svg;
  for (std::size_t i = 0; i < across.size(); ++i) {
    const double at = box.left + (static_cast<double>(i) + 0.5) * grid.cell_width();
    svg += text_svg({at, box.bottom + 14}, number_markup(across[i]), "middle", "small");
  }
  for (std::size_t j = 0; j < upward.size(); ++j) {
    const double at = box.bottom - (static_cast<double>(j) + 0.5) * grid.cell_height();
    svg += text_svg({box.left - 6, at + 4}, number_markup(upward[j]), "end", "small");
  }
  const double middle = (box.top + box.bottom) / 2;
  return svg +
         text_svg({(box.left + box.right) / 2, box.bottom + 31}, grid.upright ? map.y_label : map.x_label, "middle",
                  "axis-label") +
         text_svg({16, middle}, grid.upright ? map.x_label : map.y_label, "middle", "axis-label",
                  " transform=\"rotate(-90 16 " + pixels(middle) + ")\"");
}

/// The legend of lines and hatching, in rows below the map.
struct Keys {
  std::string svg;
  double bottom = 0;
};
Keys keys_svg(const HeatMap& map, const CellGrid& grid, const std::string& hatch, const Cells& cells,
              const std::set<Line>& lines) {
  LegendRows rows(grid.box.left, map.width, grid.box.bottom + 38);
  std::string svg;
  for (const auto& [line, label] : map.keys) {
    if (!lines.contains(line)) continue;
    const auto [x, y] = rows.next(44 + other_type * text_width(label, 12));
    svg += fmt::format("<path class=\"axis\" stroke-width=\"1.6\" d=\"{}\"{}/>{}",
                       path_data({{x, y + 8}, {x + 26, y + 8}}), dash_attribute(line),
                       text_svg({x + 31, y + 12}, label, "start"));
  }
  const auto sample = [&](const std::string& label, const std::string& css, const std::string& over) {
    const auto [x, y] = rows.next(40 + other_type * text_width(label, 12));
    const std::string place = fmt::format("x=\"{}\" y=\"{}\" width=\"22\" height=\"13\"", pixels(x), pixels(y + 1));
    svg += fmt::format("<rect class=\"blank\" {}{}/>{}{}", place, css,
                       over.empty() ? "" : fmt::format("<rect {} fill=\"url(#{})\"/>", place, over),
                       text_svg({x + 27, y + 12}, label, "start"));
  };
  if (cells.hatched) sample("hatched: *p*_{H} > 4 GPa, a numerical test", " style=\"fill:#f4f4f4\"", escaped(hatch));
  if (cells.blank) sample("empty: not known", "", "");
  return {svg, rows.last_top() + (svg.empty() ? 0 : 20)};
}

}  // namespace

std::string draw(const HeatMap& map, Place place) {
  const bool labelled =
      std::any_of(map.contours.begin(), map.contours.end(), [](const auto& level) { return !level.label.empty(); });
  const double left = 58, right = map.width - (labelled ? 34 : 10);
  double top = 8;
  std::string svg;
  if (!map.heading.empty()) {
    const Heading heading = heading_of(map.heading, map.width, top + 9);
    svg += heading.svg;
    top += 18 + heading.more;
  }
  if (labelled) top += 13;
  CellGrid grid{{left, top, right, top}, map.x.size(), map.y.size(), map.x.size() > map.y.size()};
  if (grid.upright) std::swap(grid.columns, grid.rows);
  const double name = other_type * text_width(grid.upright ? map.x_label : map.y_label, 12) + 6;
  grid.box.bottom += std::max(name, row_height * static_cast<double>(grid.rows));
  const std::string hatch = map.id + "-hatch";
  const Cells cells = cells_svg(map, grid, hatch, place);
  if (cells.hatched) svg += hatch_svg(hatch);
  const Contours contours = contours_svg(map, grid);
  svg += cells.svg + contours.svg + cells.numbers + axes_svg(map, grid);
  const Keys keys = keys_svg(map, grid, hatch, cells, contours.lines);
  return picture({map.id, map.title, map.description, map.width, keys.bottom, {map.x_label, map.y_label, map.heading}},
                 svg + keys.svg, place);
}

}  // namespace ehd::report
