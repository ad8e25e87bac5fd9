// SPDX-License-Identifier: GPL-3.0-or-later
// Elements of figures: lines clipped to a frame, markers, dashes, texts, legend rows.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ehd::report {

enum class Line { solid, dashed, dotted, dash_dot, none };
enum class Marker { none, circle, square, triangle, diamond, cross, plus };

struct Point {
  double x = 0, y = 0;
};
struct Box {
  double left = 0, top = 0, right = 0, bottom = 0;
};

/// The part of a segment inside the box (Liang and Barsky); absent where there is none or an end is not finite.
[[nodiscard]] std::optional<std::pair<Point, Point>> clipped(Point from, Point to, const Box& box);

/// Unbroken pieces of a polyline inside the box; a point that is not finite breaks it.
[[nodiscard]] std::vector<std::vector<Point>> pieces(const std::vector<Point>& points, const Box& box);

/// The pieces of a polyline outside all holes, which do not overlap; those not longer than `least` are left out.
[[nodiscard]] std::vector<std::vector<Point>> pieces_outside(const std::vector<Point>& points,
                                                             const std::vector<Box>& holes, double least);

/// Fewer points; every old one lies within `distance` of the new line (Douglas and Peucker).
[[nodiscard]] std::vector<Point> simplified(const std::vector<Point>& points, double distance);

/// "M1 2L3 4", nothing for fewer than two points.
[[nodiscard]] std::string path_data(const std::vector<Point>& points);

/// SVG of a marker around a point. `size`: in those of usual markers.
[[nodiscard]] std::string marker_svg(Marker marker, Point at, bool hollow, double size = 1);
/// The stroke-dasharray attribute of a line, empty for a solid one.
[[nodiscard]] std::string dash_attribute(Line line);
/// A <text>; `anchor`: start, middle, end.
[[nodiscard]] std::string text_svg(Point at, const std::string& markup, const std::string& anchor = "middle",
                                   const std::string& css = "", const std::string& more = "");

/// Places for legend entries: rows from left to right, a new row where an entry would pass the right end.
class LegendRows {
 public:
  static constexpr double height = 17;  ///< of a row, pixels
  LegendRows(double left, double right, double top) : left_(left), right_(right), place_{left, top} {}
  /// The upper left corner of the next entry.
  [[nodiscard]] Point next(double width);
  [[nodiscard]] double last_top() const { return place_.y; }  ///< of the last row

 private:
  double left_, right_;
  Point place_;
};

}  // namespace ehd::report
