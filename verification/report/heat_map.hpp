// SPDX-License-Identifier: GPL-3.0-or-later
// A quantity over two groups as coloured cells with their numbers, contour lines and hatched cells.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/report/plot.hpp"

namespace ehd::report {

enum class Colours {
  sequential,  ///< light to dark
  diverging    ///< around zero, which is white
};

struct Cell {
  std::optional<double> value = {};  ///< shown by the colour; absent: blank
  std::string text = {};             ///< plain, inside the cell
  std::string hint = {};             ///< plain, for the read-out
  bool hatched = false;
};

struct ContourLevel {
  double value = 0;
  Line line = Line::solid;
  std::string label = {};  ///< markup; where the line leaves the map, on the right or above
};

/// The longer axis runs upward, so that the map is as narrow as a phone: x where there are more values of x than of y.
struct HeatMap {
  std::string id;
  std::string title, description;  ///< plain text
  std::string heading = {};        ///< markup, above the map; broken after a comma where it is long
  std::string x_label, y_label;    ///< markup
  std::vector<double> x, y;        ///< ascending, evenly spaced on the map
  std::vector<Cell> cells;         ///< x fastest, from the lowest y
  Colours colours = Colours::sequential;
  bool logarithmic = false;  ///< of the values
  double limit = 0;          ///< diverging: the value of full colour
  std::vector<ContourLevel> contours = {};
  std::vector<std::pair<Line, std::string>> keys = {};  ///< line samples below, markup
  double width = 400;
};
[[nodiscard]] std::string draw(const HeatMap& map, Place place);

}  // namespace ehd::report
