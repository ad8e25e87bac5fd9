// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solver.hpp"

#include <optional>

#include "tests/check.hpp"

using namespace ehd;

BOOST_AUTO_TEST_SUITE(solver)

BOOST_AUTO_TEST_CASE(each_film_is_held_against_what_it_is_asked_for) {
  const ErrorBudget small{.discretisation = 1e-6}, large{.discretisation = 1e-3},
      unknown{.discretisation = testing::infinity}, broken{.discretisation = testing::not_a_number};
  constexpr double between = 1e-4;
  const FilmTolerances both = between, minimum{between, std::nullopt}, central{std::nullopt, between};
  BOOST_TEST(both.met_by(small, small));
  BOOST_TEST(!both.met_by(small, large));
  BOOST_TEST(!both.met_by(large, small));
  BOOST_TEST(minimum.met_by(small, large));
  BOOST_TEST(minimum.met_by(small, unknown));
  BOOST_TEST(!minimum.met_by(large, small));
  BOOST_TEST(central.met_by(large, small));
  BOOST_TEST(!central.met_by(small, large));
  for (const ErrorBudget& bad : {unknown, broken}) {
    BOOST_TEST(!both.met_by(bad, small));
    BOOST_TEST(!both.met_by(small, bad));
  }
}

BOOST_AUTO_TEST_CASE(nothing_asked_for_is_never_met) {
  const FilmTolerances nothing;
  BOOST_TEST(!nothing.any());
  BOOST_TEST(nothing.tightest() == 0);
  BOOST_TEST(!nothing.met_by({}, {}));
}

BOOST_AUTO_TEST_CASE(the_tightest_is_the_smaller_one_that_is_asked_for) {
  BOOST_TEST(FilmTolerances(1e-3).tightest() == 1e-3);
  BOOST_TEST(FilmTolerances(1e-3, 1e-6).tightest() == 1e-6);
  BOOST_TEST(FilmTolerances(std::nullopt, 1e-2).tightest() == 1e-2);
  BOOST_TEST((Request{}.tolerance == FilmTolerances(1e-3)));
}

BOOST_AUTO_TEST_SUITE_END()
