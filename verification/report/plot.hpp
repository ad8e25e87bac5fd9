// SPDX-License-Identifier: GPL-3.0-or-later
// Curves over an axis, as SVG: panels one above another, linear or logarithmic axes, a second axis on the right.
// Series differ by dash and marker as well as by colour, so that a print in grey can be read.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "verification/report/svg.hpp"
#include "verification/report/ticks.hpp"

namespace ehd::report {

enum class Line { solid, dashed, dotted, dash_dot, none };
enum class Marker { none, circle, square, triangle, diamond, cross, plus };

struct Series {
  std::string name = {};  ///< markup; the legend's text, nothing for a series without an entry
  std::vector<double> x = {}, y = {};
  Line line = Line::solid;
  Marker marker = Marker::none;
  int colour = 1;                    ///< 1 to 6
  bool right = false;                ///< belongs to the axis on the right
  bool hollow = false;               ///< markers
  std::vector<bool> hollow_at = {};  ///< of single points, where given
  std::string end = {};              ///< markup; a label at the last point
  std::string of = {};  ///< without a name: the name of the series whose entry in the legend stands for both
  std::optional<Line> key_line = {};  ///< in the legend, where the line belongs to another series
};

/// A dashed line across the panel at a value of y.
struct Rule {
  double y = 0;
  std::string label = {};  ///< markup
};

/// A triangle whose long side has the slope `order` in a log-log panel: from (x, y) to x times `factor`.
struct SlopeTriangle {
  double x = 0, y = 0, factor = 2, order = 2;
};

struct Panel {
  std::string title = {};  ///< markup
  Axis x, y;
  std::optional<Axis> right = {};
  std::vector<Series> series = {};
  std::vector<Rule> rules = {};
  std::vector<SlopeTriangle> triangles = {};
  double height = 240;  ///< of the frame, pixels
};

/// Panels share the legend of the figure where it has one: entries of the same name are shown once.
struct Figure {
  std::string id;
  std::string title, description;  ///< plain text
  std::vector<Panel> panels = {};
  double width = 480;
};

[[nodiscard]] std::string draw(const Figure& figure, Place place);

// -- parts that have their own tests -------------------------------------------------------------------------------

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

/// Fewer points, none of the old ones further than `distance` from the new line (Douglas and Peucker).
[[nodiscard]] std::vector<Point> simplified(const std::vector<Point>& points, double distance);

/// "M1 2L3 4", nothing for fewer than two points.
[[nodiscard]] std::string path_data(const std::vector<Point>& points);

/// SVG of a marker around a point.
[[nodiscard]] std::string marker_svg(Marker marker, Point at, bool hollow);
/// The stroke-dasharray attribute of a line, empty for a solid one.
[[nodiscard]] std::string dash_attribute(Line line);
/// A <text>; `anchor`: start, middle, end.
[[nodiscard]] std::string text_svg(Point at, const std::string& markup, const std::string& anchor = "middle",
                                   const std::string& css = "", const std::string& more = "");

}  // namespace ehd::report
