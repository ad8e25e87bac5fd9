// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/heat_map.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "tests/check.hpp"
#include "tests/verification/report/markup.hpp"
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
