// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/heat_map.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "tests/check.hpp"
#include "tests/verification/report/markup.hpp"
#include "verification/report/contour_lines.hpp"
#include "verification/report/polar_plot.hpp"

using namespace ehd::report;
using namespace ehd::testing;
using ehd::verification::Tolerance;
using ehd::verification::test::count_of;
using ehd::verification::test::unbalanced;

namespace {

std::vector<double> values_of(std::size_t columns, std::size_t rows, const std::function<double(double, double)>& f) {
  std::vector<double> values;
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) values.push_back(f(static_cast<double>(i), static_cast<double>(j)));
  }
  return values;
}

HeatMap map_of(const std::vector<std::optional<double>>& values) {
  HeatMap map{.id = "made",
              .title = "Made",
              .description = "Made",
              .x_label = "*M*",
              .y_label = "*L*",
              .x = {1, 10, 100},
              .y = {0, 5},
              .cells = {}};
  for (const auto& value : values) map.cells.push_back({.value = value, .text = value ? "v" : "", .hint = "a hint"});
  return map;
}

/// Values of an attribute, in the order of the text.
std::vector<double> attributes_of(const std::string& svg, const std::string& element, const std::string& name) {
  std::vector<double> values;
  for (std::size_t at = 0; (at = svg.find(element, at)) != std::string::npos; ++at) {
    const std::size_t from = svg.find(name + "=\"", at) + name.size() + 2;
    values.push_back(std::stod(svg.substr(from)));
  }
  return values;
}

/// Every segment of the path data "M1 2L3 4...".
std::vector<std::pair<Point, Point>> segments_of(const std::string& data) {
  std::vector<std::pair<Point, Point>> segments;
  Point last;
  for (std::size_t at = 0; at < data.size() && (data[at] == 'M' || data[at] == 'L');) {
    std::size_t read = 0;
    const double x = std::stod(data.substr(at + 1), &read);
    const Point now{x, std::stod(data.substr(at + 1 + read))};
    if (data[at] == 'L') segments.emplace_back(last, now);
    last = now;
    at = data.find_first_of("ML", at + 1);
  }
  return segments;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(report_heat_map)

BOOST_AUTO_TEST_CASE(the_contour_of_a_plane_is_straight_and_whole) {
  const auto lines = contour_lines(values_of(6, 5, [](double x, double y) { return 2 * x + 3 * y; }), 6, 5, 9.5);
  BOOST_REQUIRE(lines.size() == 1u);
  // Cut where 2x + 3y = 9.5 leaves the grid 0..5 x 0..4, and at every grid line between.
  for (const Point& p : lines.front()) EHD_CHECK(ehd::error(2 * p.x + 3 * p.y, 9.5), Tolerance::round_off(8, 4));
  const Point a = lines.front().front(), b = lines.front().back();
  EHD_CHECK(ehd::error(std::min(a.y, b.y), 0), Tolerance::round_off(8, 4));
  EHD_CHECK(ehd::error(std::min(a.x, b.x), 0), Tolerance::round_off(8, 4));
}

BOOST_AUTO_TEST_CASE(the_contour_of_a_cone_closes_round_its_circle) {
  constexpr double radius = 7.3;
  const auto lines =
      contour_lines(values_of(21, 21, [](double x, double y) { return std::hypot(x - 10, y - 10); }), 21, 21, radius);
  BOOST_REQUIRE(lines.size() == 1u);
  BOOST_TEST((lines.front().front().x == lines.front().back().x && lines.front().front().y == lines.front().back().y));
  // On an edge the chord of the distance lies above it by at most h^2/8 times its second derivative, 1/r.
  const Tolerance chord = Tolerance::asymptotic(
      1 / (8 * (radius - 1)), "h^2/8 times the second derivative of the distance on the innermost edge");
  for (const Point& p : lines.front()) EHD_CHECK(std::abs(std::hypot(p.x - 10, p.y - 10) - radius), chord);
}

BOOST_AUTO_TEST_CASE(a_saddle_has_two_lines_that_do_not_cross) {
  const auto lines = contour_lines({1, 0, 0, 1}, 2, 2, 0.4);
  BOOST_REQUIRE(lines.size() == 2u);
  // The middle, 0.5, is above 0.4: the high corners (0, 0) and (1, 1) are joined, each line cuts off a low one.
  for (const auto& line : lines) {
    const double sum = line[0].x + line[1].x - line[0].y - line[1].y;
    BOOST_TEST(std::abs(sum) > 1);
  }
}

BOOST_AUTO_TEST_CASE(squares_with_a_hole_have_no_contour) {
  BOOST_TEST(contour_lines({0, not_a_number, 0, 1}, 2, 2, 0.5).empty());
  BOOST_TEST(contour_lines({0, 1}, 2, 1, 0.5).empty());
  BOOST_TEST(contour_lines({}, 0, 0, 0.5).empty());
  BOOST_TEST(contour_lines({0, 0, 0, 0}, 2, 2, 0.5).empty());
}

BOOST_AUTO_TEST_CASE(a_map_has_a_cell_a_value_and_blanks_where_none_is_known) {
  HeatMap map = map_of({1.0, 2.0, std::nullopt, not_a_number, 5.0, 6.0});
  map.cells[4].hatched = true;
  const std::string svg = draw(map, Place::page);
  BOOST_TEST(unbalanced(svg) == "");
  BOOST_TEST(count_of(svg, "class=\"cell\" fill=\"#") == 4u);
  BOOST_TEST(count_of(svg, "class=\"blank\"/>") == 2u);
  BOOST_TEST(count_of(svg, "url(#made-hatch)") == 2u);  // the cell, the key
  BOOST_TEST(count_of(svg, "data-hint") == 6u);
  BOOST_TEST(count_of(svg, "nan") == 0u);
}

// WCAG 2.1 AA asks for a contrast of 4.5 between a number and its cell. Its formula, written here once more.
BOOST_AUTO_TEST_CASE(every_number_can_be_read_on_its_cell) {
  const auto luminance = [](const std::string& hex) {
    double sum = 0;
    const double weights[] = {0.2126, 0.7152, 0.0722};
    for (std::size_t i = 0; i < 3; ++i) {
      const double part = std::stoi(hex.substr(2 * i, 2), nullptr, 16) / 255.0;
      sum += weights[i] * (part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4));
    }
    return sum;
  };
  int numbers = 0;
  for (const Colours colours : {Colours::sequential, Colours::diverging}) {
    HeatMap map;
    map.id = "made";
    map.colours = colours;
    map.limit = 1;
    map.y = {1};
    for (int i = 0; i <= 100; ++i) {
      map.x.push_back(i + 1);
      map.cells.push_back({.value = -1 + 0.02 * i, .text = "7"});
    }
    const std::string svg = draw(map, Place::file);
    const std::string word = "style=\"fill:#";
    for (std::size_t at = 0; (at = svg.find(word, at)) != std::string::npos; ++at) {
      const std::size_t stroke = svg.find(";stroke:#", at);
      const double ink = svg.compare(at + word.size(), 3, "fff") == 0 ? 1 : 0;
      const double cell = luminance(svg.substr(stroke + 9, 6));
      const double contrast = (std::max(ink, cell) + 0.05) / (std::min(ink, cell) + 0.05);
      BOOST_TEST(contrast >= 4.5);
      ++numbers;
    }
  }
  BOOST_TEST(numbers == 202);
}

BOOST_AUTO_TEST_CASE(maps_without_data_or_of_one_value_are_drawn) {
  for (const bool logarithmic : {false, true}) {
    for (const Colours colours : {Colours::sequential, Colours::diverging}) {
      for (const std::optional<double> value :
           {std::optional<double>(), std::optional(3.0), std::optional(-3.0), std::optional(0.0)}) {
        HeatMap map = map_of({value, value, value, value, value, value});
        map.logarithmic = logarithmic;
        map.colours = colours;
        map.contours = {{0.5, Line::solid, "1"}, {2, Line::dashed, "2"}};
        const std::string svg = draw(map, Place::file);
        BOOST_TEST(unbalanced(svg) == "");
        BOOST_TEST(count_of(svg, "nan") == 0u);
      }
    }
  }
}

// A plane over 9 x 5 nodes, every number four digits wide: its lines cross the map through and between the numbers.
BOOST_AUTO_TEST_CASE(contour_lines_end_before_the_numbers) {
  HeatMap map{.id = "made",
              .title = "Made",
              .description = "Made",
              .x_label = "*M*",
              .y_label = "*L*",
              .x = {},
              .y = {},
              .cells = {}};
  for (int i = 0; i < 9; ++i) map.x.push_back(i + 1);
  for (int j = 0; j < 5; ++j) map.y.push_back(j);
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 9; ++i) map.cells.push_back({.value = 2.0 * i + 3 * j, .text = "1234"});
  for (const double level : {4.0, 8.5, 12.0, 17.0}) map.contours.push_back({.value = level});
  const std::string svg = draw(map, Place::file);
  const std::string number = "class=\"cell-text\"", line = "class=\"contour\"";
  std::vector<ehd::report::Box> numbers;
  for (std::size_t at = 0; (at = svg.find(number, at)) != std::string::npos; ++at) {
    const std::string text = svg.substr(svg.rfind("<text", at), svg.find('>', at) - svg.rfind("<text", at));
    const double x = std::stod(text.substr(text.find("x=\"") + 3)), y = std::stod(text.substr(text.find(" y=\"") + 4)),
                 size = std::stod(text.substr(text.find("font-size=\"") + 11)), half = text_width("1234", size) / 2;
    constexpr double digit = 0.7;  // height over the size of the type
    numbers.push_back({x - half, y - digit * size, x + half, y});
  }
  BOOST_REQUIRE(numbers.size() == 45u);
  std::size_t segments = 0;
  for (std::size_t at = 0; (at = svg.find(line, at)) != std::string::npos; ++at) {
    const std::size_t from = svg.find(" d=\"", at) + 4;
    for (const auto& [a, b] : segments_of(svg.substr(from, svg.find('"', from) - from))) {
      ++segments;
      for (const auto& box : numbers)
        BOOST_TEST(!clipped(a, b, box).has_value(), "a line through the number at " << box.left << ", " << box.bottom);
    }
  }
  BOOST_TEST(segments >= 20u);
}

BOOST_AUTO_TEST_CASE(the_longer_axis_runs_upward) {
  const HeatMap map = map_of({1.0, 2.0, 3.0, 4.0, 5.0, 6.0});  // three values of x, two of y
  const std::string svg = draw(map, Place::page);
  const auto x = attributes_of(svg, "class=\"cell\" fill", "x"),
             data = attributes_of(svg, "class=\"datum\"", "data-row");
  BOOST_TEST(data == (std::vector<double>{1, 10, 100, 1, 10, 100}), boost::test_tools::per_element());  // as before
  std::vector<double> left, top;
  for (std::size_t at = 0; (at = svg.find("<g class=\"datum\"", at)) != std::string::npos; ++at) {
    const std::size_t rectangle = svg.find("<rect x=\"", at);
    left.push_back(std::stod(svg.substr(rectangle + 9)));
    top.push_back(std::stod(svg.substr(svg.find(" y=\"", rectangle) + 4)));
  }
  BOOST_REQUIRE(left.size() == 6u);
  BOOST_TEST((left[0] == left[1] && left[1] == left[2] && left[3] == left[4] && left[0] < left[3]));
  BOOST_TEST((top[0] > top[1] && top[1] > top[2] && top[0] == top[3]));
}

// The script's phone test looks at the width; here: the texts of a map that is as small as maps get.
BOOST_AUTO_TEST_CASE(a_small_map_has_room_for_its_names) {
  HeatMap map = map_of({1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
  map.x_label = "a name that is longer than three rows";
  map.heading = "Dowson and Higginson 1966, film.minimum, Roelands, compressible";
  const std::string svg = draw(map, Place::page);
  const auto heights = attributes_of(svg, "<rect x=", "height");
  BOOST_TEST(3 * heights.front() >= text_width(map.x_label, 12));
  BOOST_TEST(count_of(svg, "class=\"head\"") == 2u);
  BOOST_TEST(count_of(svg, "Higginson 1966,</text>") == 1u);
  BOOST_TEST(count_of(svg, ">film.minimum, Roelands, compressible</text>") == 1u);
  map.heading = "Short";
  BOOST_TEST(count_of(draw(map, Place::page), "class=\"head\"") == 1u);
}

BOOST_AUTO_TEST_CASE(the_legend_of_a_map_has_what_is_drawn) {
  HeatMap map = map_of({1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
  map.contours = {{2.5, Line::solid, ""}, {40, Line::dashed, ""}};
  map.keys = {{Line::solid, "drawn"}, {Line::dashed, "beyond all values"}};
  const std::string svg = draw(map, Place::file);
  BOOST_TEST(count_of(svg, ">drawn<") == 1u);
  BOOST_TEST(count_of(svg, "beyond all values") == 0u);
  BOOST_TEST(count_of(svg, "empty: not known") == 0u);
  map.cells[4].value.reset();
  BOOST_TEST(count_of(draw(map, Place::file), "empty: not known") == 1u);
}

// On the map, a label would hide a number.
BOOST_AUTO_TEST_CASE(labels_of_contour_lines_stand_beside_the_map_or_above_it) {
  HeatMap map = map_of({1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
  map.contours = {{1.5, Line::solid, "1.5"}, {3.5, Line::dashed, "3.5"}, {4.5, Line::solid, "4.5"}};
  const std::string svg = draw(map, Place::file);
  const auto x = attributes_of(svg, "<rect x=", "x"), y = attributes_of(svg, "<rect x=", "y"),
             width = attributes_of(svg, "<rect x=", "width");
  const double right = *std::max_element(x.begin(), x.end()) + width.front(),
               top = *std::min_element(y.begin(), y.end());
  std::size_t labels = 0;
  const std::string word = "contour-label\"";
  for (std::size_t at = 0; (at = svg.find(word, at)) != std::string::npos; ++at, ++labels) {
    const std::string text = svg.substr(svg.rfind("<text", at), 60);
    BOOST_TEST((std::stod(text.substr(text.find("x=\"") + 3)) > right ||
                std::stod(text.substr(text.find(" y=\"") + 4)) < top));
  }
  BOOST_TEST(labels == 2u);  // that of 1.5 ends at the axes
}

BOOST_AUTO_TEST_CASE(polar_plots_share_a_scale_that_all_loads_fill) {
  PolarPlot plot{.id = "made", .title = "Made", .description = "Made", .radius_label = "*f* [kN]", .series = {}};
  plot.series.push_back({.name = "law", .angle_deg = {-90, 0, 90}, .radius = {1, 4, 1}});
  const auto circles = [&](double reaches) {
    plot.reaches = reaches;
    return count_of(draw(plot, Place::page), "<circle class=\"grid\"");
  };
  BOOST_TEST(circles(0) == 4u);     // 1, 2, 3, 4
  BOOST_TEST(circles(11.2) == 6u);  // 2, 4, ... 12
  BOOST_TEST(circles(12) == 6u);
  plot.series.front().radius = {1e-320, 0, not_a_number};
  for (const double reaches : {0.0, 1e-320, 1e300}) BOOST_TEST(circles(reaches) >= 4u);
}

BOOST_AUTO_TEST_CASE(polar_plots_point_the_load_down_and_close) {
  PolarPlot plot{.id = "made", .title = "Made", .description = "Made", .radius_label = "*f* [kN]", .series = {}};
  plot.series.push_back({.name = "law", .angle_deg = {-90, 0, 90, not_a_number}, .radius = {1, 4, 1, 1}});
  const std::string svg = draw(plot, Place::page);
  BOOST_TEST(unbalanced(svg) == "");
  BOOST_TEST(count_of(svg, "nan") == 0u);
  BOOST_TEST(count_of(svg, "class=\"datum\"") == 3u);
  // The outline begins at 0 degrees, in the middle below the centre, and comes back to it.
  const std::size_t series = svg.find("class=\"series"), from = svg.find("d=\"M", series) + 4;
  const std::string outline = svg.substr(from, svg.find('"', from) - from);
  EHD_CHECK(ehd::error(std::stod(outline), plot.width / 2), Tolerance::round_off(8, 10));
  double lowest = 0;
  std::size_t corners = 0;
  for (std::size_t at = outline.find('L'); at != std::string::npos; at = outline.find('L', at + 1), ++corners)
    lowest = std::max(lowest, std::stod(outline.substr(outline.find(' ', at))));
  BOOST_TEST(corners == 3u);
  BOOST_TEST(std::stod(outline.substr(outline.find(' '))) == lowest);
  const double side = std::stod(outline.substr(outline.find(' ', outline.find('L'))));
  BOOST_TEST(lowest > side);
  BOOST_TEST(outline.substr(outline.rfind('L') + 1) == outline.substr(0, outline.find('L')));
  plot.series.front() = {.name = "nothing", .angle_deg = {}, .radius = {}};
  BOOST_TEST(unbalanced(draw(plot, Place::file)) == "");
}

BOOST_AUTO_TEST_SUITE_END()
