// SPDX-License-Identifier: GPL-3.0-or-later
// Values at floor 0 from two and three floors: exact for the terms that floors have, and honest about others.
#include "reference/hp/discretised.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "tests/check.hpp"

namespace ehd::reference::hp {

using verification::Tolerance;

namespace {

constexpr double at_zero = 0.25;

/// At floors r and r s times the lowest one.
template <class Value>
std::vector<AtFloor> floors_of(const Value& value, double lowest, double r, double s) {
  std::vector<AtFloor> floors;
  for (const double floor : {lowest, r * lowest, r * s * lowest}) floors.push_back({floor, value(floor)});
  return floors;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hp_discretised)

BOOST_AUTO_TEST_CASE(three_floors_give_a_line_and_its_logarithm) {
  const auto value = [](double floor) { return at_zero - 30 * floor + 7 * floor * std::log(floor); };
  for (const auto& [lowest, r, s] : {std::array{1e-6, 10., 10.}, {1e-9, 10., 100.}, {1e-8, 3., 5.}, {1e-7, 40., 4.}}) {
    const AtZero zero = carried_to_zero(floors_of(value, lowest, r, s));
    EHD_CHECK(std::abs(zero.value - at_zero), Tolerance::round_off(16, at_zero));
    // What the line alone misses is stated.
    const std::vector<AtFloor> lines = floors_of(value, lowest, r, s);
    const double slope = (lines[1].value - lines[0].value) / (lines[1].floor - lines[0].floor);
    BOOST_TEST(zero.error >= std::abs(lines[0].value - lowest * slope - at_zero));
  }
}

BOOST_AUTO_TEST_CASE(other_terms_stay_within_the_stated_error) {
  for (const double power : {1.5, 2.0})
    for (const double lowest : {1e-6, 1e-8}) {
      const auto value = [&](double floor) { return at_zero + 3 * floor - 20 * std::pow(floor, power); };
      const AtZero zero = carried_to_zero(floors_of(value, lowest, 10, 10));
      BOOST_TEST(std::abs(zero.value - at_zero) <= zero.error);
    }
}

BOOST_AUTO_TEST_CASE(without_a_confirmation_the_line_counts_and_states_twice_its_move) {
  const auto value = [](double floor) { return at_zero - 30 * floor; };
  const auto two = [&](double lowest) {
    auto floors = floors_of(value, lowest, 10, 10);
    floors.pop_back();
    return floors;
  };
  const auto check = [](const AtZero& zero, double safety, double lowest) {
    EHD_CHECK(std::abs(zero.value - at_zero), Tolerance::round_off(16, at_zero));
    EHD_CHECK(std::abs(zero.error / (safety * 30 * lowest) - 1), Tolerance::round_off(16, at_zero / (30 * lowest)));
  };
  check(carried_to_zero(two(1e-7)), 2, 1e-7);
  check(carried_to_zero(two(1e-5)), 2, 1e-5);
  check(carried_to_zero(floors_of(value, 1e-5, 10, 10)), 2, 1e-5);  // three floors above 1e-6
  check(carried_to_zero(floors_of(value, 1e-7, 10, 10)), 0.2, 1e-7);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::reference::hp
