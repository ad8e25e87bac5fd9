// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 6: the path of the steep layer behind the spike, and the mesh that follows it.
#include "reference/hp/steep_layer.hpp"

#include <cmath>
#include <vector>

#include "tests/check.hpp"
#include "tests/reference/hp/solved.hpp"
#include "tests/reference/problems.hpp"

namespace {

using namespace ehd;
using namespace ehd::reference::hp;
using namespace ehd::testing;
using verification::Tolerance;

constexpr double shortest = HomotopyLimits{}.shortest_element;

/// The layer of an oil whose power is q: X = end + 0.7 delta^q.
std::vector<SteepPlace> places_of(double end, double q, const std::vector<double>& floors) {
  std::vector<SteepPlace> places;
  for (const double floor : floors) places.push_back({.floor = floor, .X = end + 0.7 * std::pow(floor, q)});
  return places;
}

/// A contact from a floor of 0.1 down, in small steps.
std::vector<Resolved> floors_of(const Problem& problem, double film) {
  Meter meter = generous();
  std::vector<Resolved> floors{coarse_top(problem, film, 0.1, film)};
  for (const double floor : {0.05, 0.025, 0.012, 6e-3, 3e-3, 1.5e-3, 8e-4, 4e-4}) {
    Resolved start = floors.back();
    start.floor = floor;
    auto next =
        resolved(problem, start, Resolution{}, {.newton = {.iterations = 40, .patience = 40, .step = 1e-6}}, meter);
    BOOST_REQUIRE(next.has_value());
    floors.push_back(std::move(*next));
  }
  return floors;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hp_steep_layer)

BOOST_AUTO_TEST_CASE(three_places_give_end_reach_and_power) {
  int rows = 0;
  for (const double q : {0.4, 0.5, 0.8, 1.3}) {
    const auto places = places_of(0.9, q, {1e-2, 2e-3, 7e-4});
    const auto path = path_of(places);
    BOOST_TEST_CONTEXT("power " << q) {
      BOOST_REQUIRE(path.has_value());
      const Tolerance fitted = Tolerance::required(1e-5, "steep_layer.cpp: a power has 20 binary digits");
      EHD_CHECK(std::abs(path->power - q), fitted);
      EHD_CHECK(std::abs(path->end - 0.9), fitted);
      EHD_CHECK(std::abs(path->reach - 0.7 * std::pow(7e-4, q)), fitted);
      ++rows;
    }
  }
  BOOST_TEST(rows == 4);
}

BOOST_AUTO_TEST_CASE(two_places_are_those_of_barus_oil) {
  const auto path = path_of(places_of(0.9, 0.5, {1e-2, 1e-3}));
  BOOST_REQUIRE(path.has_value());
  BOOST_TEST(path->power == 0.5);
  EHD_CHECK(std::abs(path->end - 0.9), Tolerance::round_off(16, 0.9));
}

BOOST_AUTO_TEST_CASE(places_that_are_on_no_path_have_none) {
  BOOST_TEST(!path_of({}).has_value());
  BOOST_TEST(!path_of({{1e-2, 0.9}}).has_value());
  BOOST_TEST(!path_of({{1e-2, 0.9}, {1e-3, 0.9}}).has_value());                // it stands still
  BOOST_TEST(!path_of({{1e-2, 0.9}, {1e-3, 0.8}, {1e-4, 0.85}}).has_value());  // it turns round
  BOOST_TEST(!path_of({{1e-2, 0.9}, {1e-3, 0.8}, {1e-4, 0.6}}).has_value());   // it goes faster and faster
}

BOOST_AUTO_TEST_CASE(a_layer_on_no_path_is_expected_to_go_on_as_in_its_larger_step) {
  BOOST_TEST(!expected_path({}).has_value());
  BOOST_TEST(!expected_path({{1e-2, 0.9}}).has_value());
  const auto path = expected_path({{1e-2, 0.9}, {1e-3, 0.8}, {1e-4, 0.85}});
  BOOST_REQUIRE(path.has_value());
  EHD_CHECK(std::abs(path->end - 0.75), Tolerance::round_off(16, 1));
  const auto fitted = places_of(0.9, 0.5, {1e-2, 2e-3, 7e-4});
  BOOST_TEST(expected_path(fitted).value().end == path_of(fitted).value().end);
}

BOOST_AUTO_TEST_CASE(a_layer_is_at_the_centre_within_thirty_times_of_what_it_still_goes) {
  BOOST_TEST(!is_at_centre({}));
  BOOST_TEST(!is_at_centre({{1e-6, 1e-4}}));
  for (const double side : {-1.0, 1.0}) {
    const LayerPath path{.end = side * 0.029, .reach = 1e-3, .power = 0.5};
    BOOST_TEST(is_at_centre(path, {.floor = 1e-8, .X = path.end + path.reach}));
    BOOST_TEST(!is_at_centre(path, {.floor = 1e-8, .X = path.end + 0.9 * path.reach}));
    EHD_CHECK(std::abs(unsettled_distance(path) - 5e-3), Tolerance::round_off(16, 1));
  }
}

BOOST_AUTO_TEST_CASE(the_path_tells_where_the_next_floor_has_its_layer) {
  const Problem problem = barus_problem(20, 10, TruncatedAt{-4});
  const auto floors = floors_of(problem, 0.1);
  const std::size_t last = floors.size() - 1;
  const std::vector<SteepPlace> places{steep_place(floors[last - 3]), steep_place(floors[last - 2]),
                                       steep_place(floors[last - 1])};
  const auto path = path_of(places);
  BOOST_REQUIRE(path.has_value());
  const double found = steep_place(floors[last]).X;
  const double told = path->end + path->reach * std::pow(floors[last].floor / places.back().floor, path->power);
  EHD_CHECK(std::abs(told - found) / std::abs(places.back().X - found),
            Tolerance::required(0.25, "a mesh that follows is to leave a small part of the way"));

  const auto start = followed(problem, floors[last - 1], *path, floors[last].floor, shortest);
  BOOST_REQUIRE(start.has_value());
  BOOST_TEST(start->floor == floors[last].floor);
  BOOST_TEST(start->equations->mesh().degrees == floors[last - 1].equations->mesh().degrees);
  BOOST_TEST((start->run.state.P.array() == floors[last - 1].run.state.P.array()).all());
}

BOOST_AUTO_TEST_CASE(breakpoints_near_the_end_come_nearer_and_far_ones_stay) {
  const Problem problem = barus_problem(20, 10, TruncatedAt{-4});
  const Resolved last = coarse_top(problem, 0.1, 0.1, 0.1);
  const double exit = last.run.state.exit, s = last.equations->stretching(exit);
  const auto& before = last.equations->mesh().breakpoints;
  const std::size_t near = before.size() - 3;
  // A path that ends just before a breakpoint.
  const LayerPath path{.end = exit + s * before[near] - 1e-3, .reach = 1e-2, .power = 0.5};
  const auto start = followed(problem, last, path, last.floor / 16, shortest);
  BOOST_REQUIRE(start.has_value());
  const auto& after = start->equations->mesh().breakpoints;
  BOOST_REQUIRE_EQUAL(after.size(), before.size());
  const double u = 1e-3 / (10 * path.reach);
  const double expected = path.end + 1e-3 * (1 - 0.75 / (1 + u * u * u * u));  // (1/16)^(1/2) = 1 - 0.75
  EHD_CHECK(std::abs(exit + s * after[near] - expected), Tolerance::round_off(64, 1));
  BOOST_TEST(after.front() == before.front());
  BOOST_TEST(after.back() == before.back());
  for (std::size_t i = 1; i < after.size(); ++i) BOOST_TEST(after[i] > after[i - 1]);
  EHD_CHECK(std::abs(after[1] / before[1] - 1), Tolerance::required(1e-5, "it is 30 widths away"));

  BOOST_TEST(!followed(problem, last, path, last.floor / 16, 1.0).has_value());  // all elements are shorter
}

BOOST_AUTO_TEST_SUITE_END()
