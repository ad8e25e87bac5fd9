// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/plot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "tests/check.hpp"
#include "tests/verification/report/markup.hpp"
#include "verification/report/report.hpp"

using namespace ehd::report;
using namespace ehd::testing;
using ehd::verification::test::count_of;
using ehd::verification::test::unbalanced;

namespace {

const ehd::verification::Tolerance rounding = ehd::verification::Tolerance::round_off(8, 10);

Figure figure_of(const std::vector<double>& x, const std::vector<double>& y, Scale scale = Scale::linear) {
  Figure figure{.id = "made", .title = "Made", .description = "Made"};
  Panel panel;
  panel.x = {.label = "*x* [m]", .scale = scale};
  panel.y = {.label = "*y* [N]", .scale = scale};
  panel.series.push_back({.name = "one", .x = x, .y = y, .marker = Marker::circle});
  figure.panels.push_back(panel);
  return figure;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(report_plot)

BOOST_AUTO_TEST_CASE(segments_are_cut_at_the_box) {
  const ehd::report::Box box{0, 0, 10, 5};
  const auto crossing = clipped({-5, 2}, {15, 4}, box);
  BOOST_REQUIRE(crossing.has_value());
  EHD_CHECK(ehd::error(crossing->first.x, 0), rounding);
  EHD_CHECK(ehd::error(crossing->first.y, 2.5), rounding);
  EHD_CHECK(ehd::error(crossing->second.x, 10), rounding);
  EHD_CHECK(ehd::error(crossing->second.y, 3.5), rounding);
  BOOST_TEST(!clipped({-5, -1}, {15, -2}, box).has_value());
  BOOST_TEST(!clipped({-1, 4}, {1, 8}, box).has_value());  // past the corner
  BOOST_TEST(!clipped({not_a_number, 1}, {1, 1}, box).has_value());
  BOOST_TEST(!clipped({0, 1}, {infinity, 1}, box).has_value());
  const auto inside = clipped({1, 1}, {2, 2}, box);
  BOOST_REQUIRE(inside.has_value());
  BOOST_TEST((inside->first.x == 1 && inside->second.y == 2));  // not moved at all
}

BOOST_AUTO_TEST_CASE(a_curve_that_leaves_and_returns_is_two_pieces) {
  const ehd::report::Box box{0, 0, 10, 10};
  BOOST_TEST(pieces({{1, 5}, {2, 5}, {3, 20}, {4, 5}, {5, 5}}, box).size() == 2u);
  BOOST_TEST(pieces({{1, 5}, {2, 5}, {3, not_a_number}, {4, 5}, {5, 5}}, box).size() == 2u);
  BOOST_TEST(pieces({{1, 5}, {2, 6}, {3, 7}}, box).size() == 1u);
  BOOST_TEST(pieces({{1, 5}}, box).empty());
  BOOST_TEST(pieces({}, box).empty());
}

BOOST_AUTO_TEST_CASE(a_simplified_curve_stays_within_the_distance) {
  std::vector<Point> curve;
  for (int i = 0; i <= 400; ++i) curve.push_back({1.0 * i, 100 * std::sin(0.02 * i)});
  constexpr double distance = 0.1;
  const auto fewer = simplified(curve, distance);
  BOOST_TEST(fewer.size() < curve.size() / 4);
  double furthest = 0;
  std::size_t at = 0;
  for (const Point& point : curve) {
    while (at + 2 < fewer.size() && fewer[at + 1].x < point.x) ++at;
    const Point a = fewer[at], b = fewer[at + 1];
    furthest = std::max(furthest, std::abs((b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x)) /
                                      std::hypot(b.x - a.x, b.y - a.y));
  }
  EHD_CHECK(furthest, ehd::verification::Tolerance::required(distance, "the distance asked for"));
  BOOST_TEST(simplified({{0, 0}, {1, 0}, {2, 0}}, distance).size() == 2u);
}

BOOST_AUTO_TEST_CASE(odd_data_make_a_picture_without_nan) {
  for (const Scale scale : {Scale::linear, Scale::logarithmic}) {
    for (const auto& [x, y] : std::vector<std::pair<std::vector<double>, std::vector<double>>>{
             {{}, {}},
             {{1}, {2}},
             {{not_a_number, not_a_number}, {1, 2}},
             {{1, 2, 3}, {not_a_number, infinity, -infinity}},
             {{1, 2, 3}, {1, not_a_number, 3}},
             {{0, -1, 2}, {0, -1, 5}},
             {{1, 2}, {7, 7}},
             {{1e-300, 1e300}, {1e-300, 1e300}},
             {{-1.7e308, 1.7e308}, {1, 2}},
             {{1, 2, 3}, {1}}}) {
      for (const Place place : {Place::page, Place::file}) {
        const std::string svg = draw(figure_of(x, y, scale), place);
        BOOST_TEST(unbalanced(svg) == "");
        for (const char* word : {"\"nan", " nan", "nan,", ">nan", "inf,", "inf ", "\"inf"})
          BOOST_TEST(count_of(svg, word) == 0u, word << " in a picture");
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(one_point_is_a_mark_and_no_data_a_word) {
  BOOST_TEST(count_of(draw(figure_of({1}, {2}), Place::file), "<circle") == 2u);  // in the legend, in the plot
  BOOST_TEST(count_of(draw(figure_of({}, {}), Place::file), "no data") == 1u);
  BOOST_TEST(count_of(draw(figure_of({1, 2}, {2, 3}), Place::file), "no data") == 0u);
}

BOOST_AUTO_TEST_CASE(values_for_the_read_out_are_in_the_page_only) {
  const Figure figure = figure_of({1, 2.5}, {2, 1e-5});
  BOOST_TEST(count_of(draw(figure, Place::page), "data-values=\"1,2 2.5,1e-05\"") == 1u);
  BOOST_TEST(count_of(draw(figure, Place::file), "data-values") == 0u);
}

// The script draws a zoomed curve from these: where it breaks, and which points have a mark.
BOOST_AUTO_TEST_CASE(values_name_breaks_and_the_points_that_have_marks) {
  Figure figure = figure_of({1, 2, 3, 4}, {2, not_a_number, 90, 3});
  BOOST_TEST(count_of(draw(figure, Place::page), "data-values=\"1,2 - 3,90 4,3\"") == 1u);
  figure.panels.front().y.high = 10;  // the third point lies above the frame
  const std::string svg = draw(figure, Place::page);
  BOOST_TEST(count_of(svg, "data-values=\"1,2 - 3,90 4,3\"") == 1u);  // saved all the same
  BOOST_TEST(count_of(svg, "data-marked=\"0 3\"") == 1u);
  BOOST_TEST(count_of(svg, "<circle") == 3u);  // and the legend's
}

BOOST_AUTO_TEST_CASE(a_frame_names_its_ends_from_left_and_from_below) {
  Figure figure = figure_of({1, 100}, {2, 8}, Scale::logarithmic);
  Panel& panel = figure.panels.front();
  panel.x.low = 1;
  panel.x.high = 100;
  panel.y = {.label = "down", .low = 0, .high = 10, .downward = true};
  const std::string svg = draw(figure, Place::page);
  BOOST_TEST(count_of(svg, "data-x-range=\"1,100\" data-x-log=\"1\"") == 1u);
  BOOST_TEST(count_of(svg, "data-y-range=\"10,0\"") == 1u);
  BOOST_TEST(count_of(svg, "data-y-log") == 0u);
}

// A panel that stands beside two others, with eleven decades; and some with few.
BOOST_AUTO_TEST_CASE(labels_of_ticks_do_not_touch_in_a_narrow_panel) {
  for (const auto& [x, fewest] : std::vector<std::pair<std::vector<double>, std::size_t>>{
           {{5e-11, 2e-3}, 3}, {{1e-12, 1e-2}, 3}, {{0.013, 0.9}, 2}, {{3e-4, 2e-2}, 2}, {{2e-6, 3e-5}, 2}}) {
    Figure figure = figure_of(x, {1, 2}, Scale::logarithmic);
    for (const double width : {240.0, 360.0, 480.0}) {
      figure.width = width;
      const std::string svg = draw(figure, Place::file);
      const std::size_t begin = svg.find("<g class=\"ticks-text\">"), end = svg.find("</g>", begin);
      const std::string texts = svg.substr(begin, end - begin);
      std::vector<std::pair<double, double>> taken;
      for (std::size_t at = 0; (at = texts.find("<text x=\"", at)) != std::string::npos; ++at) {
        const std::string text = texts.substr(at, texts.find("</text>", at) - at);
        if (count_of(text, "text-anchor=\"middle\"") == 0) continue;  // of y
        // The power stands in a span of its own, smaller.
        std::string label;
        for (std::size_t i = 0, inside = 0; i < text.size(); ++i) {
          if (text[i] == '<') inside = 1;
          if (inside == 0) label += text[i];
          if (text[i] == '>') inside = 0;
        }
        const double place = std::stod(text.substr(9)), half = text_width(label, 11) / 2;
        taken.emplace_back(place - half, place + half);
      }
      std::sort(taken.begin(), taken.end());
      BOOST_TEST(taken.size() >= fewest, taken.size() << " labels, width " << width << ", from " << x.front());
      for (std::size_t i = 1; i < taken.size(); ++i)
        BOOST_TEST(taken[i].first > taken[i - 1].second, "width " << width << ", from " << x.front());
    }
  }
}

// The label of a rule stands where no curve passes: at the other end, or on the other side.
BOOST_AUTO_TEST_CASE(the_label_of_a_rule_avoids_the_curves) {
  const auto anchor = [](const std::vector<double>& y, const std::vector<double>& x = {0, 1, 2, 3}) {
    Figure figure = figure_of(x, y);
    figure.panels.front().y.low = 0;
    figure.panels.front().y.high = 10;
    figure.panels.front().rules.push_back({5, "a rule"});
    const std::string svg = draw(figure, Place::file);
    const std::size_t at = svg.rfind("<text", svg.find("a rule"));
    return svg.substr(at, svg.find("a rule") - at);
  };
  BOOST_TEST(count_of(anchor({1, 1, 1, 1}), "text-anchor=\"end\"") == 1u);
  BOOST_TEST(count_of(anchor({1, 1, 1, 5}), "text-anchor=\"end\"") == 0u);
  // Between the ends, where curves are in the way at both.
  const auto x = [](const std::string& text) { return std::stod(text.substr(text.find(" x=\"") + 4)); };
  const std::string between = anchor({5, 5, 1, 1, 5, 5}, {0, 0.6, 0.7, 2.3, 2.4, 3});
  BOOST_TEST(count_of(between, "text-anchor=\"end\"") == 0u);
  BOOST_TEST(x(between) > x(anchor({1, 1, 1, 5})) + 50);
  const auto y = [](const std::string& text) { return std::stod(text.substr(text.find(" y=\"") + 4)); };
  const std::string above = anchor({1, 1, 1, 1}), below = anchor({5.3, 5.3, 5.3, 5.3});
  BOOST_TEST(count_of(below, "text-anchor=\"end\"") == 1u);
  BOOST_TEST(y(below) > y(above));
}

BOOST_AUTO_TEST_CASE(a_line_ends_before_a_hole_and_goes_on_behind_it) {
  using ehd::report::Box;
  const std::vector<Point> line{{0, 5}, {6, 5}, {20, 5}};
  const auto parts = pieces_outside(line, {Box{12, 4, 14, 6}, Box{2, 4, 4, 6}}, 0);
  BOOST_REQUIRE(parts.size() == 3u);
  EHD_CHECK(ehd::error(parts[0].back().x, 2), rounding);
  EHD_CHECK(ehd::error(parts[1].front().x, 4), rounding);
  BOOST_TEST(parts[1].size() == 3u);  // over the corner at 6
  EHD_CHECK(ehd::error(parts[1].back().x, 12), rounding);
  EHD_CHECK(ehd::error(parts[2].front().x, 14), rounding);
  BOOST_TEST(pieces_outside(line, {Box{12, 4, 14, 6}, Box{2, 4, 4, 6}}, 3).size() == 2u);  // the first has 2
  BOOST_TEST(pieces_outside(line, {Box{0, 4, 20, 6}}, 0).empty());
  BOOST_TEST(pieces_outside(line, {}, 0).size() == 1u);
}

BOOST_AUTO_TEST_CASE(half_a_bearing_is_shown_only_where_the_other_half_is_its_mirror_image) {
  BearingCurves even{.law = "hertz",
                     .azimuth_deg = {0, 60, 120, 180, 240, -60},
                     .force_N = {5e3, 2e3, 0, 0, 0, 2e3},
                     .displacement_m = {3e-6, 1e-6, -1e-6, -2e-6, -1e-6, 1e-6}};
  const Panel half = azimuth_panel(OverAzimuth::force, "", {even});
  BOOST_TEST(half.x.low.value() == 0.0);
  BOOST_TEST(half.series.front().x == (std::vector<double>{0, 60, 120, 180}), boost::test_tools::per_element());
  // One roller carries less than its mirror image: both have to be seen, each at its own place.
  BearingCurves askew = even;
  askew.force_N.back() = 1e3;
  const Panel whole = azimuth_panel(OverAzimuth::force, "", {even, askew});
  BOOST_TEST(whole.x.low.value() == -180.0);
  const Series& series = whole.series.back();
  BOOST_TEST(series.x == (std::vector<double>{-120, -60, 0, 60, 120, 180}), boost::test_tools::per_element());
  BOOST_TEST(series.y == (std::vector<double>{0, 1, 5, 2, 0, 0}), boost::test_tools::per_element());
  // A cage turned by 20 degrees has no roller at -psi at all.
  BearingCurves turned = even;
  for (double& psi : turned.azimuth_deg) psi += 20;
  BOOST_TEST(azimuth_panel(OverAzimuth::displacement, "", {turned}).x.low.value() == -180.0);
}

BOOST_AUTO_TEST_CASE(legend_entries_do_not_overlap) {
  Figure figure = figure_of({1, 2}, {3, 4});
  for (int i = 0; i < 8; ++i)
    figure.panels.front().series.push_back(
        {.name = "a solver with a long name " + std::to_string(i), .x = {1, 2}, .y = {1, 2}});
  const std::string svg = draw(figure, Place::file);
  double row = -1, end = 0;
  std::size_t entries = 0;
  for (std::size_t at = 0; (at = svg.find("class=\"key", at)) != std::string::npos; ++at) {
    const std::size_t text = svg.find("<text x=\"", at);
    const double x = std::stod(svg.substr(text + 9)), y = std::stod(svg.substr(svg.find("y=\"", text) + 3));
    const std::size_t from = svg.find('>', text) + 1;
    if (y == row) BOOST_TEST(x > end);
    row = y;
    end = x + text_width(literal(svg.substr(from, svg.find('<', from) - from)), 12);
    BOOST_TEST(end <= figure.width);
    ++entries;
  }
  BOOST_TEST(entries == 9u);
}

BOOST_AUTO_TEST_SUITE_END()
