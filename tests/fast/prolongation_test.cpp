// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/prolongation.hpp"

#include <cmath>

#include "fast/mapped.hpp"
#include "tests/check.hpp"
#include "tests/fast/problems.hpp"

using namespace ehd;
using verification::Tolerance;

namespace {

constexpr double inlet = -4;
constexpr int first = 1024;  ///< intervals of the coarsest grid
/// Width of the fall; the pressure before it rises with e^(2 X).
constexpr double width = 0.06;

double falling(double X, double spike) { return std::exp(2 * (X - spike)) / (1 + std::exp(2 * (X - spike) / width)); }

fast::State with_spike(int n, double spike, double exit, double offset) {
  fast::State state{.P = Array::Zero(n + 1), .offset = offset, .exit = exit, .tail = {}};
  for (int i = 1; i < n; ++i) state.P[i] = falling(inlet + (exit - inlet) * i / n, spike);
  return state;
}

/// Where the pressure has fallen to the level, on equal cells.
double fall_to(double level, const fast::State& state) {
  const Array& P = state.P;
  const double h = (state.exit - inlet) / static_cast<double>(P.size() - 1);
  Eigen::Index i = P.size() - 1;
  while (P[i] < level) --i;
  return inlet + h * (static_cast<double>(i) + (P[i] - level) / (P[i] - P[i + 1]));
}

bool same(const fast::State& a, const fast::State& b) {
  return (a.P == b.P).all() && a.offset == b.offset && a.exit == b.exit;
}

/// Newton steps on each grid of 512 intervals, coarse to fine, added up over the problems.
std::vector<int> newton_steps(const std::vector<Problem>& problems) {
  std::vector<int> steps(4);
  for (const Problem& problem : problems) {
    const Solution solution = fast::Mapped{}.solve(problem, {.tolerance = {}, .nodes = 512});
    BOOST_REQUIRE(solution.record.status == StopReason::converged);
    BOOST_REQUIRE_EQUAL(solution.record.grids.size(), steps.size());
    for (std::size_t k = 0; k < steps.size(); ++k) steps[k] += solution.record.grids[k].newton_iterations;
  }
  return steps;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(prolongation)

BOOST_AUTO_TEST_CASE(one_solution_is_interpolated) {
  fast::Grids grids;
  const fast::State only = with_spike(first, 0.81, 1.13, -0.37);
  fast::Prolongation prolongation;
  prolongation.note(only);
  BOOST_CHECK(same(prolongation.onto(2 * first, grids, inlet), fast::interpolate_to(only, 2 * first)));
}

BOOST_AUTO_TEST_CASE(spike_exit_and_offset_go_on_moving) {
  fast::Grids grids;
  const fast::State before = with_spike(first, 0.81, 1.13, -0.37), last = with_spike(2 * first, 0.77, 1.15, -0.33);
  fast::Prolongation prolongation;
  prolongation.note(before);
  prolongation.note(last);
  const fast::State next = prolongation.onto(4 * first, grids, inlet);
  EHD_CHECK(error(next.exit, 1.15 + 0.02 / 4), Tolerance::round_off(10));
  EHD_CHECK(error(next.offset, -0.33 + 0.04 / 4), Tolerance::round_off(10));
  const double level = last.P.maxCoeff() / 2, h = (last.exit - inlet) / (2 * first);
  EHD_CHECK(
      std::abs(fall_to(level, next) - fall_to(level, last) - 0.4 * (0.77 - 0.81)),
      Tolerance::discretisation(h * h / width, 3));  // linear interpolation of the level's place in three profiles
}

BOOST_AUTO_TEST_CASE(without_a_spike_to_follow_the_last_solution_is_interpolated) {
  fast::Grids grids;
  const auto dry = [](int n, double exit) {
    fast::State state{.P = Array::Zero(n + 1), .offset = -0.6, .exit = exit, .tail = {}};
    for (int i = 1; i < n; ++i) {
      const double X = inlet + (exit - inlet) * i / n;
      state.P[i] = std::sqrt(std::max(0.0, 1 - X * X));
    }
    return state;
  };
  fast::Prolongation smooth, leaping;
  smooth.note(dry(first, 1.03));
  smooth.note(dry(2 * first, 1.02));
  BOOST_CHECK(same(smooth.onto(4 * first, grids, inlet), fast::interpolate_to(dry(2 * first, 1.02), 4 * first)));
  const fast::State far = with_spike(2 * first, 0.4, 1.13, -0.33);
  leaping.note(with_spike(first, 0.81, 1.13, -0.37));
  leaping.note(far);
  BOOST_CHECK(same(leaping.onto(4 * first, grids, inlet), fast::interpolate_to(far, 4 * first)));
}

// Each bound is half way between the counts with and without the saving. Counts of a single contact change by a few
// steps with the order of sums.
BOOST_AUTO_TEST_CASE(newton_steps_are_saved_where_a_spike_marches) {
  std::vector<Problem> problems;
  for (const MoesGroups& moes : {MoesGroups{20, 10}, {100, 10}, {200, 15}, {1000, 10}, {1000, 20}})
    problems.push_back(roelands_problem(moes.M, moes.L, Flooded{}));
  const std::vector<int> steps = newton_steps(problems);
  EHD_CHECK(steps[1], Tolerance::calibrated(60, "128 intervals: 40 from the map's own solution, 81 from 64 intervals"));
  EHD_CHECK(steps[2] + steps[3],
            Tolerance::calibrated(116, "256 and 512: 94 where the spike is carried along, 139 by interpolation alone"));
}

BOOST_AUTO_TEST_SUITE_END()
