// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/harmonic_grids.hpp"

#include "tests/check.hpp"
#include "tests/fast/problems.hpp"

using namespace ehd;
using verification::Tolerance;

BOOST_AUTO_TEST_SUITE(harmonic_grids)

BOOST_AUTO_TEST_CASE(each_grid_has_twice_the_intervals_and_its_own_moved_nodes) {
  const Problem problem = roelands_problem(5, 15, TruncatedAt{-4});
  fast::Workspace workspace;
  fast::HarmonicGrids grids(problem, {.tolerance = {}, .nodes = 128}, 1e-8, fast::Care::full, workspace);
  BOOST_REQUIRE(grids.climb());
  BOOST_REQUIRE_EQUAL(grids.size(), 2);
  BOOST_REQUIRE(grids.refine(256));
  BOOST_TEST(!grids.refine(256));
  for (std::size_t k = 0; k < grids.size(); ++k) {
    BOOST_TEST(grids[k].intervals() == 64 << k);
    EHD_CHECK(grids.residual(k), Tolerance::required(1e-8, "the residual that the grids are asked for"));
    const fast::MovedNodes& moved = grids.moved(k);
    BOOST_TEST(&moved == &grids.moved(k));
    BOOST_TEST(moved.place.size() == grids[k].intervals() + 1);
    BOOST_TEST(moved.film.allFinite());
  }
}

// Counter of Newton steps. A bearing asks for a residual of 5e-8.
BOOST_AUTO_TEST_CASE(the_climb_ends_at_the_residual_that_is_asked_for) {
  const Problem problem = roelands_problem(5, 5, Flooded{});
  const auto steps = [&](double residual) {
    fast::Workspace workspace;
    fast::HarmonicGrids grids(problem, {.tolerance = {}, .nodes = 256}, residual, fast::Care::least, workspace);
    BOOST_REQUIRE(grids.climb());
    for (std::size_t k = 0; k < grids.size(); ++k)
      EHD_CHECK(grids.residual(k), Tolerance::required(residual, "the residual that the grids are asked for"));
    return grids.run().counters.newton;
  };
  BOOST_TEST(steps(5e-8) + 3 <= steps(1e-10));
}

BOOST_AUTO_TEST_SUITE_END()
