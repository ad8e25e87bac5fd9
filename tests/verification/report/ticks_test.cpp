// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/check.hpp"

using namespace ehd::report;
using namespace ehd::testing;

namespace {

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
  std::vector<std::string> result;
  for (const Tick& tick : ticks) {
    if (!tick.label.empty()) result.push_back(tick.label);
  }
  return result;
}

/// Tick positions are multiples of a step: a few roundings.
const ehd::verification::Tolerance tick_rounding = ehd::verification::Tolerance::round_off(4, 1);

}  // namespace

BOOST_AUTO_TEST_SUITE(report_ticks)

BOOST_AUTO_TEST_CASE(steps_are_1_2_or_5_times_a_power_of_ten) {
  for (const double size : {1e-7, 0.03, 1.0, 4.4, 12345.0}) {
    for (const int wanted : {3, 5, 6}) {
      const double step = tick_step({0, size}, wanted),
                   mantissa = step / std::pow(10, std::floor(std::log10(step * (1 + 1e-12))));
      const double nearest = mantissa < 1.5 ? 1 : mantissa < 3.5 ? 2 : 5;
      EHD_CHECK(ehd::error(mantissa, nearest), tick_rounding);
      BOOST_TEST(size / step <= wanted * (1 + 1e-9));
      BOOST_TEST(size / step >= wanted / 2.5 * (1 - 1e-9));  // the next smaller step is at most 2.5 times finer
    }
  }
}

BOOST_AUTO_TEST_CASE(linear_labels_have_the_decimals_that_the_step_needs) {
  const std::vector<std::string> expected{"\u22120.50", "\u22120.25", "0.00", "0.25", "0.50"};
  BOOST_TEST(labels(linear_ticks({-0.5, 0.5}, 0.25)) == expected, boost::test_tools::per_element());
  const std::vector<std::string> whole{"0", "30", "60", "90"};
  BOOST_TEST(labels(linear_ticks({0, 100}, 30)) == whole, boost::test_tools::per_element());
  const auto ends = linear_ticks({0, 0.3}, 0.1);  // 3 * 0.1 > 0.3 by tick_rounding
  BOOST_TEST(ends.size() == 4u);
  BOOST_TEST(linear_ticks({0, 1e9}, 1).empty());  // a billion ticks are a mistake
  BOOST_TEST(linear_ticks({0, 1}, 0).empty());
  BOOST_TEST(linear_ticks({0, 1}, not_a_number).empty());
}

BOOST_AUTO_TEST_CASE(log_axes_label_decades_and_below_two_of_them_2_and_5) {
  const std::vector<std::string> many{"10^{\u22128}", "10^{\u22126}", "10^{\u22124}", "10^{\u22122}"};
  BOOST_TEST(labels(log_ticks({1e-9, 1e-2}, 4)) == many, boost::test_tools::per_element());
  const std::vector<std::string> plainly{"0.1", "1", "10", "100", "1000"};
  BOOST_TEST(labels(log_ticks({0.05, 5000})) == plainly, boost::test_tools::per_element());
  const std::vector<std::string> few{"50", "100", "200", "500", "1000", "2000"};
  BOOST_TEST(labels(log_ticks({45, 2500})) == few, boost::test_tools::per_element());
  for (const Tick& tick : log_ticks({3e-5, 2e3}))
    BOOST_TEST((tick.value >= 3e-5 * (1 - 1e-9) && tick.value <= 2e3 * (1 + 1e-9)));
  BOOST_TEST(labels(log_ticks({1.0, 1.5})).size() >= 3u);  // not a decade in it: linear steps
  BOOST_TEST(log_ticks({0, 1}).empty());
  BOOST_TEST(log_ticks({1, 1}).empty());
}

// All labels of an axis are powers of ten, or none is.
BOOST_AUTO_TEST_CASE(labels_of_a_log_axis_look_alike) {
  const std::vector<std::string> powers{"2\u2009\u00b7\u200910^{\u22126}", "5\u2009\u00b7\u200910^{\u22126}",
                                        "10^{\u22125}", "2\u2009\u00b7\u200910^{\u22125}"};
  BOOST_TEST(labels(log_ticks({2e-6, 3e-5})) == powers, boost::test_tools::per_element());
  const std::vector<std::string> plainly{"0.0005", "0.001", "0.002", "0.005", "0.01", "0.02"};
  BOOST_TEST(labels(log_ticks({4e-4, 3e-2})) == plainly, boost::test_tools::per_element());
  const std::vector<std::string> decades{"0.001", "0.01"};
  BOOST_TEST(labels(log_ticks({4e-4, 3e-2}, 3)) == decades, boost::test_tools::per_element());  // no room for 2 and 5
}

BOOST_AUTO_TEST_CASE(labels_touch_where_their_boxes_overlap) {
  const Mapping to_pixel(Scale::linear, {0, 10}, 100,
                         0);  // downwards: the order of the pixels is not that of the ticks
  const auto room = [](const std::string& label) { return 10.0 * static_cast<double>(label.size()); };
  BOOST_TEST(!labels_touch({{0, "ab"}, {2, "ab"}, {4.5, "abc"}}, to_pixel, room));
  BOOST_TEST(labels_touch({{0, "ab"}, {2, "ab"}, {4.4, "abc"}}, to_pixel, room));
  BOOST_TEST(!labels_touch({{0, "ab"}, {1, ""}, {2, "ab"}}, to_pixel, room));  // a minor tick has no label
  BOOST_TEST(!labels_touch({}, to_pixel, room));
}

BOOST_AUTO_TEST_CASE(a_range_holds_every_value_that_has_a_place) {
  const Range linear = range_of({0.3, not_a_number, -1.7, infinity}, Scale::linear);
  BOOST_TEST((linear.low <= -1.7 && linear.high >= 0.3 && std::isfinite(linear.high)));
  // A logarithmic range goes beyond the values by part of a decade: less than a whole one at either end.
  constexpr double smallest = 1e-6, largest = 1e-2, decade = 10;
  const Range logarithmic = range_of({smallest, 0, -5, not_a_number, largest}, Scale::logarithmic);
  BOOST_TEST(logarithmic.low <= smallest);
  BOOST_TEST(logarithmic.low > smallest / decade);
  BOOST_TEST(logarithmic.high >= largest);
  BOOST_TEST(logarithmic.high < largest * decade);
  for (const Scale scale : {Scale::linear, Scale::logarithmic}) {
    for (const std::vector<double>& values :
         {std::vector<double>{}, {not_a_number}, {7.0}, {7.0, 7.0}, {0.0}, {-3.0}, {1e-300, 1e300}, {-1e300, 1e300}}) {
      const Range range = range_of(values, scale);
      BOOST_TEST((std::isfinite(range.low) && std::isfinite(range.high) && range.low < range.high));
    }
  }
}

BOOST_AUTO_TEST_CASE(mappings_meet_the_ends_and_have_no_place_for_zero_on_a_log_axis) {
  const Mapping linear(Scale::linear, {-1, 3}, 100, 20), logarithmic(Scale::logarithmic, {1e-4, 1e4}, 0, 80);
  EHD_CHECK(ehd::error(linear(-1), 100), tick_rounding);
  EHD_CHECK(ehd::error(linear(1), 60), tick_rounding);
  EHD_CHECK(ehd::error(logarithmic(1), 40), tick_rounding);
  EHD_CHECK(ehd::error(logarithmic(10), 50), tick_rounding);
  for (const double value : {0.0, -1.0, not_a_number, infinity}) BOOST_TEST(std::isnan(logarithmic(value)));
  for (const double value : {not_a_number, infinity}) BOOST_TEST(std::isnan(linear(value)));
}

BOOST_AUTO_TEST_SUITE_END()
