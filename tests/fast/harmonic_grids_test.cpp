// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/harmonic_grids.hpp"

#include <cmath>

#include "tests/check.hpp"
#include "tests/fast/maps.hpp"
#include "tests/fast/problems.hpp"

using namespace ehd;
using verification::Tolerance;

BOOST_AUTO_TEST_SUITE(harmonic_grids)

BOOST_AUTO_TEST_CASE(a_moved_spike_moves_the_nodes_there_by_a_part_of_a_cell) {
  int rows = 0;
  for (const auto& [name, shape] : named_shapes) {
    BOOST_TEST_CONTEXT(name) {
      const fast::Map map(shape);
      for (const double step : {-0.4 / 64, 0.2 / 64}) {
        const fast::Map moved = with_moved_spike(map, step);
        EHD_CHECK(std::abs(map(shape.spike) - moved(shape.spike) - step) * 64,
                  Tolerance::required(1e-2, "of a cell of 64: maps a fifth of a cell apart are to be evenly spread"));
      }
      ++rows;
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 5);
}

BOOST_AUTO_TEST_CASE(grids_beside_have_as_many_intervals_at_other_places) {
  const Problem problem = roelands_problem(5, 15, TruncatedAt{-4});
  fast::Workspace first, second;
  const Request request{.tolerance = {}, .nodes = 128};
  fast::HarmonicGrids grids(problem, request, 1e-8, first), beside(problem, request, 1e-8, second);
  BOOST_REQUIRE(grids.climb());
  BOOST_REQUIRE(beside.climb_beside(grids, grids.size(), 0.4));
  BOOST_REQUIRE_EQUAL(beside.size(), grids.size());
  for (std::size_t k = 0; k < grids.size(); ++k) {
    BOOST_TEST(beside[k].intervals() == grids[k].intervals());
    EHD_CHECK(beside.residual(k), Tolerance::required(1e-8, "the residual that the grids are asked for"));
  }
  BOOST_TEST(grids.run().workspace.grids.map()->shape().spike != beside.run().workspace.grids.map()->shape().spike);
  BOOST_REQUIRE(beside.refine(256));
  BOOST_TEST(beside[beside.size() - 1].intervals() == 256);
  BOOST_TEST(!beside.refine(256));
}

BOOST_AUTO_TEST_SUITE_END()
