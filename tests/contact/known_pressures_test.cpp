// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/known_pressures.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/check.hpp"

namespace {

using namespace ehd;
using verification::Tolerance;

/// A dome of height 1, and a spike of this height at X = 0.9 that is as wide as so many cells.
Fields with_spike(double height, double cells) {
  constexpr int intervals = 200;
  Fields fields;
  fields.X = Array::LinSpaced(intervals + 1, -1, 1);
  const double width = cells * 2 / intervals;
  fields.P = (1 - fields.X.square()).max(0).sqrt();
  const double dome = std::sqrt(1 - 0.81);
  fields.P += (height - dome) * (-((fields.X - 0.9) / width).square()).exp();
  return fields;
}

struct Judged {
  Observables seen;
  std::vector<std::string> notes;
};
Judged judged(double spike, double spike_error, double cells, std::size_t grids, const Wanted& wanted) {
  Judged found;
  found.seen = {{Quantity::pressure_maximum, {.value = 1, .place = 0.0, .error = 1e-4}},
                {Quantity::pressure_spike, {.value = spike, .place = 0.9, .error = spike_error}}};
  keep_known_pressures(found.seen, wanted, with_spike(spike, cells), grids, 10, found.notes);
  return found;
}
const Wanted both{Quantity::pressure_maximum, Quantity::pressure_spike};

}  // namespace

BOOST_AUTO_TEST_SUITE(known_pressures)

BOOST_AUTO_TEST_CASE(the_last_three_moves_of_a_height_count_less_and_less) {
  EHD_CHECK(std::abs(error_of_moves({1, 1.1, 1.14, 1.15}) - 3.0 / 4 * 0.1), Tolerance::round_off(20));
  BOOST_TEST(error_of_moves({1}) == 0);
}

BOOST_AUTO_TEST_CASE(a_spike_that_does_not_settle_has_no_error) {
  const auto error = [](const std::vector<double>& values) {
    const GridEstimate found = estimate(values, 2);
    return peak_error(Quantity::pressure_spike, values, found, found.error);
  };
  BOOST_TEST(error({0.6, 0.65, 0.71, 0.76}) == std::numeric_limits<double>::infinity());
  BOOST_TEST(std::isfinite(error({0.9, 0.94, 0.95, 0.9525})));
}

BOOST_AUTO_TEST_CASE(a_known_lower_spike_leaves_the_maximum) {
  const Judged found = judged(0.9, 0.01, 10, 5, both);
  BOOST_TEST(found.seen.contains(Quantity::pressure_maximum));
  BOOST_TEST(found.seen.contains(Quantity::pressure_spike));
  BOOST_TEST(found.notes.empty());
}

BOOST_AUTO_TEST_CASE(an_unknown_spike_that_may_be_higher_takes_the_maximum_along) {
  const Judged vague = judged(0.9, 0.2, 10, 5, both);
  BOOST_TEST(vague.seen.empty());
  BOOST_TEST(vague.notes.size() == 2);
  BOOST_TEST(judged(0.5, 0.2, 10, 5, both).seen.contains(Quantity::pressure_maximum));  // half as high again: 0.75
}

BOOST_AUTO_TEST_CASE(a_spike_on_three_grids_is_unknown) {
  BOOST_TEST(!judged(0.9, 0.01, 10, 3, both).seen.contains(Quantity::pressure_spike));
}

BOOST_AUTO_TEST_CASE(a_spike_between_two_nodes_is_unknown) {
  const Judged found = judged(0.9, 0.01, 1, 5, both);
  BOOST_TEST(found.seen.empty());
}

BOOST_AUTO_TEST_CASE(what_nobody_wants_goes_without_a_note) {
  const Judged found = judged(0.9, 0.2, 10, 5, {Quantity::pressure_maximum});
  BOOST_TEST(found.notes.size() == 1);
}

BOOST_AUTO_TEST_SUITE_END()
