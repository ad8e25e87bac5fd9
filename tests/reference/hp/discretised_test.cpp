// SPDX-License-Identifier: GPL-3.0-or-later
// Values at floor 0 from two and three floors: exact for the terms that floors have, and honest about others.
#include "reference/hp/discretised.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "tests/check.hpp"
#include "tests/reference/hp/solved.hpp"
#include "tests/reference/problems.hpp"

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
    // The stated error covers what a straight line would miss.
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

BOOST_AUTO_TEST_CASE(values_that_go_to_and_fro_are_not_extrapolated) {
  // Film of Barus oil at (172.9, 22.45), cut at -5.388, on coarse meshes: the line through the lower two is noise.
  const AtZero zero = carried_to_zero({{1.458e-8, 0.0162535975}, {7.085e-8, 0.01625355856}, {2.793e-7, 0.01625356376}});
  BOOST_TEST(zero.value == 0.0162535975);
  BOOST_TEST(zero.error == 0.0162535975 - 0.01625355856);  // the largest distance from it
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

BOOST_AUTO_TEST_CASE(films_that_are_carried_to_floor_0_are_nearer_than_those_of_the_floor) {
  // Couette film at (20, 10), cut at -4, Barus, from 1e-9, stated error 6e-10.
  const double truth = 0.1033155300687, truth_error = 1e-9;
  const Problem problem = testing::barus_problem(20, 10, TruncatedAt{-4});
  Meter meter = testing::generous();
  const auto floors = descent(problem, testing::coarse_top(problem, 0.1, 0.1, 0.1), {.film = 1e-9, .defect = 1e-2},
                              {.settled = 1e-9, .newton = {.iterations = 25, .step = 1e-11}}, meter);
  std::vector<AtFloor> three;
  for (auto at = floors.rbegin(); at != floors.rend() && three.size() < 3; ++at)
    if (at->floor >= (three.empty() ? 1e-8 : 3 * three.back().floor)) three.push_back({at->floor, at->run.state.flux});
  BOOST_REQUIRE_EQUAL(three.size(), 3U);
  BOOST_REQUIRE(three.front().floor <= 1e-6);  // carried by three floors
  const AtZero zero = carried_to_zero(three);
  const double before = std::abs(three.front().value / truth - 1), after = std::abs(zero.value / truth - 1);
  BOOST_TEST(before > 20 * truth_error);  // else this says nothing
  EHD_CHECK(after, Tolerance::calibrated(before / 5 + truth_error, "the error states a fifth of the move"));
  BOOST_TEST(zero.error / truth >= before / 6);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::reference::hp
