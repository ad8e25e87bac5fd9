// SPDX-License-Identifier: GPL-3.0-or-later
// Curves over an axis, as SVG: panels one above another, linear or logarithmic axes, a second axis on the right.
// Series differ by dash and marker as well as by colour, so that a print in grey can be read.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "verification/report/shapes.hpp"
#include "verification/report/svg.hpp"
#include "verification/report/ticks.hpp"

namespace ehd::report {

struct Series {
  std::string name = {};  ///< markup, for the legend; empty: no entry
  std::vector<double> x = {}, y = {};
  Line line = Line::solid;
  Marker marker = Marker::none;
  int colour = 1;                     ///< 1 to 6
  bool right = false;                 ///< belongs to the axis on the right
  bool hollow = false;                ///< markers
  double size = 1;                    ///< of markers; larger ones are drawn over the others
  std::vector<bool> hollow_at = {};   ///< of single points, where given
  std::string end = {};               ///< markup; a label at the last point
  std::string of = {};                ///< of a series without a name: the series whose legend entry stands for both
  std::optional<Line> key_line = {};  ///< line of the legend entry, where another series draws the line
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

/// Panels one above another. Series of one name in several panels share their legend key.
struct Figure {
  std::string id;
  std::string title, description;  ///< plain text
  std::vector<Panel> panels = {};
  double width = 480;
};

[[nodiscard]] std::string draw(const Figure& figure, Place place);

}  // namespace ehd::report
