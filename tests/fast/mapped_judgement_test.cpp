// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/mapped_judgement.hpp"

#include "tests/check.hpp"

using namespace ehd;

BOOST_AUTO_TEST_SUITE(mapped_judgement)

BOOST_AUTO_TEST_CASE(a_coarse_grid_where_newton_stalls_does_no_harm_to_finer_ones) {
  fast::MappedClimb climb;
  climb.left = {5e-4, 1e-7, 3e-7, 1e-7, 1e-7, 1e-7};  // the limit and its error come from the last five grids
  BOOST_CHECK_EQUAL(fast::iteration_error(climb), 3e-7);
  climb.left = {1e-7, 5e-4, 1e-7, 1e-7, 1e-7, 1e-7};
  BOOST_CHECK_EQUAL(fast::iteration_error(climb), 5e-4);
  climb.left = {2e-6};
  BOOST_CHECK_EQUAL(fast::iteration_error(climb), 2e-6);
}

BOOST_AUTO_TEST_SUITE_END()
