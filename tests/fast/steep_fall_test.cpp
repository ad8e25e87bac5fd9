// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/steep_fall.hpp"

#include "fast/mapped.hpp"
#include "tests/check.hpp"
#include "tests/fast/problems.hpp"

using namespace ehd;
using verification::Tolerance;

namespace {

/// A pressure that rises to 3 at node 5, falls to .1 within the next two cells, and then falls slowly.
struct Example {
  Array X{{0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.75, 0.9, 1.0}};
  Array P{{0.5, 0.6, 0.8, 1.2, 2.0, 3.0, 1.3, 0.1, 0.05, 0.0}};
};

}  // namespace

BOOST_AUTO_TEST_SUITE(steep_fall)

BOOST_AUTO_TEST_CASE(the_jump_has_the_integral_of_the_fall) {
  const Example example;
  const auto fall = fast::steep_fall(example.X, example.P);
  BOOST_REQUIRE(fall.has_value());
  BOOST_CHECK_EQUAL(fall->top, 5);
  BOOST_CHECK_EQUAL(fall->bottom, 7);
  const double integral = 0.1 * (3.0 + 1.3) / 2 + 0.15 * (1.3 + 0.1) / 2;
  EHD_CHECK(error((fall->jump - 0.5) * 3.0 + (0.75 - fall->jump) * 0.1, integral), Tolerance::round_off(16));
  for (const Eigen::Index cell : {4, 7}) BOOST_TEST(!fall->covers(cell));
  for (const Eigen::Index cell : {5, 6}) BOOST_TEST(fall->covers(cell));
}

BOOST_AUTO_TEST_CASE(nodes_of_any_width_keep_the_integral) {
  const Example example;
  const auto fall = fast::steep_fall(example.X, example.P);
  BOOST_REQUIRE(fall.has_value());
  for (const int cells : {5, 10, 40}) {
    const double h = 0.25 / cells;
    double sum = 0;
    for (int i = 0; i < cells; ++i) sum += h * fall->mean(0.5 + (i + 0.5) * h, h);
    EHD_CHECK(error(sum, (fall->jump - 0.5) * 3.0 + (0.75 - fall->jump) * 0.1), Tolerance::round_off(64));
  }
}

BOOST_AUTO_TEST_CASE(a_fall_over_more_cells_or_to_the_exit_is_not_steep) {
  Example wide;
  wide.P[6] = 2.2;
  wide.P[7] = 1.1;
  BOOST_TEST(!fast::steep_fall(wide.X, wide.P).has_value());
  const Array to_the_exit{{0.5, 0.6, 0.8, 1.2, 2.0, 2.5, 2.8, 2.9, 3.0, 0.0}};
  BOOST_TEST(!fast::steep_fall(wide.X, to_the_exit).has_value());
}

BOOST_AUTO_TEST_CASE(newton_takes_few_steps_on_fine_grids_behind_a_narrow_spike) {
  long all = 0;
  for (const double M : {500.0, 1000.0}) {
    BOOST_TEST_CONTEXT("M " << M) {
      const Solution solution =
          fast::Mapped{}.solve(barus_problem(M, 30, Flooded{}), {.tolerance = {std::nullopt, 1e-6}});
      BOOST_REQUIRE(solution.record.status == StopReason::converged);
      int fine = 0;
      for (const GridRecord& grid : solution.record.grids) {
        if (grid.nodes < 512) continue;
        BOOST_TEST(grid.newton_iterations <= 12);  // with a cubic through the fall 14 to 28
        ++fine;
      }
      BOOST_TEST(fine > 2);
      all += solution.record.cost.newton_iterations;
    }
  }
  BOOST_TEST(all <= 180);  // 193 where a new map gets a cubic in place of the jump
}

BOOST_AUTO_TEST_SUITE_END()
