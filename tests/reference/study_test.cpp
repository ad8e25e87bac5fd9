// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/study.hpp"

#include <chrono>

#include "contact/interruption.hpp"
#include "reference/map.hpp"
#include "tests/check.hpp"
#include "tests/reference/problems.hpp"

using namespace ehd;
using namespace ehd::testing;
using reference::Level;
using reference::Study;

namespace {

/// Where the films cannot be within the tolerance: every grid is asked for a finer one.
constexpr double unreachable = 1e-14;

struct TimedLevel {
  std::optional<Level> level;
  double seconds = 0;
};

TimedLevel first_level(Study& study, const reference::GradedMap& map) {
  const auto begin = std::chrono::steady_clock::now();
  std::optional<Level> level = study.solve(map.grid(200));
  return {std::move(level), std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(study)

// Time is left, but less than eight times that of the grid before. A sweep tries a row again only where its reason
// names the time.
BOOST_AUTO_TEST_CASE(a_study_that_has_no_time_for_its_next_grid_names_the_time) {
  const Problem problem = barus_problem(20, 10, TruncatedAt{-4});
  Request request = within(unreachable);
  Study unlimited(problem, request);
  const auto map = reference::first_map(-4, unlimited.expected_film());
  const auto grid = [&](int intervals) { return map.grid(intervals); };
  int judged = 0;
  for (int attempt = 0; attempt < 10 && judged == 0; ++attempt) {  // again where the machine was busy
    request.time_limit_s = 4 * first_level(unlimited, map).seconds;
    Study study(problem, request);
    const TimedLevel timed = first_level(study, map);
    if (!timed.level || !study.no_time_to_double()) continue;
    const Solution without = solve_grids(study, grid, {400}, request.tolerance, true, timed.level);
    ++judged;
    BOOST_TEST((without.record.status == StopReason::limit_reached));
    BOOST_TEST(without.record.reason == std::string(time_limit_reason) + " before 400 intervals");
    BOOST_TEST(without.observables.empty());
  }
  BOOST_TEST(judged == 1);
}

BOOST_AUTO_TEST_SUITE_END()
