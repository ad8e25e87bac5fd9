// SPDX-License-Identifier: GPL-3.0-or-later
// Loads round a bearing in polar coordinates.
#pragma once

#include <string>
#include <vector>

#include "verification/report/plot.hpp"

namespace ehd::report {

struct PolarSeries {
  std::string name;  ///< markup
  std::vector<double> angle_deg, radius;
  Line line = Line::solid;
  Marker marker = Marker::circle;
  int colour = 1;
};
/// Angle 0 points down (the load), angles grow counterclockwise; the radius is linear from 0.
struct PolarPlot {
  std::string id;
  std::string title, description;  ///< plain text
  std::string heading = {};        ///< markup
  std::string radius_label;        ///< markup, with the unit
  std::vector<PolarSeries> series;
  double width = 380;
  double reaches = 0;  ///< the outer circle is at this radius or beyond
};
[[nodiscard]] std::string draw(const PolarPlot& plot, Place place);

}  // namespace ehd::report
