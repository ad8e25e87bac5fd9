// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that hold for both solvers of fast/; the test file of each solver calls them.
#pragma once

#include <vector>

#include "contact/solver.hpp"
#include "tests/check.hpp"
#include "tests/fast/problems.hpp"

namespace ehd {

/// Laws that are trivial are never evaluated, and quantities that are not wanted are not returned.
template <Solver S>
void check_that_nothing_needless_is_computed(const S& solver) {
  const Solution trivial = solver.solve(barus_problem(10, 0, TruncatedAt{-4}), {.tolerance = 1e-2});
  BOOST_CHECK_EQUAL(trivial.record.cost.viscosity_points, 0);
  BOOST_CHECK_EQUAL(trivial.record.cost.density_points, 0);
  const Solution barus = solver.solve(barus_problem(10, 5, TruncatedAt{-4}), {.tolerance = 1e-2});
  BOOST_CHECK_GT(barus.record.cost.viscosity_points, 0);
  BOOST_CHECK_EQUAL(barus.record.cost.density_points, 0);

  Problem problem = roelands_problem(20, 10, TruncatedAt{-4});
  problem.wanted = {Quantity::film_central};
  const Solution one = solver.solve(problem, {.tolerance = 1e-2});
  BOOST_CHECK_EQUAL(one.observables.size(), 1u);
  BOOST_CHECK(one.observables.contains(Quantity::film_central));
}

/// GMRES steps per Newton step, on all problems and grids.
template <Solver S>
void check_krylov_steps(const S& solver, const std::vector<Problem>& problems, const std::vector<int>& grids) {
  std::size_t rows = 0;
  for (const Problem& problem : problems) {
    for (const int n : grids) {
      const Cost cost = solver.solve(problem, {.tolerance = {}, .nodes = n}).record.cost;
      BOOST_TEST_CONTEXT("M " << problem.groups.M << " L " << problem.groups.L << " n " << n) {
        EHD_CHECK(static_cast<double>(cost.krylov_iterations) / static_cast<double>(cost.newton_iterations),
                  verification::Tolerance::required(
                      2.5, "the method: 1..2 GMRES steps a Newton step to M = 200, a few more from the start"));
      }
      ++rows;
    }
  }
  BOOST_REQUIRE_EQUAL(rows, problems.size() * grids.size());
  BOOST_REQUIRE_GT(rows, 0u);
}

}  // namespace ehd
