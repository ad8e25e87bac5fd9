// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_errors.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "tests/check.hpp"
#include "tests/made_bearing.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd {

namespace {

/// By a solver that states an error of 1e-3 and is off by `share` of it; roller 1 stands at `first_deg`.
std::vector<BearingResult> balanced(const std::vector<bearing::Law>& laws, double share = 0, double first_deg = 0) {
  ContactMemory memory([share](const Problem& problem, const Request&) { return made::contact(problem, 1e-3, share); });
  Case one = made::needle_bearing(4e-6);
  std::get<BearingCase>(one.body).geometry.first_azimuth_deg = first_deg;
  return run_bearing(one, {.laws = laws}, memory);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bearing_errors)

// The line's error is its distance from the curve, and more. A dry law is solved to rounding.
BOOST_AUTO_TEST_CASE(a_law_with_films_has_errors_where_the_law_ehd_is_balanced_too) {
  const auto three = balanced({bearing::Law::hertz, bearing::Law::ehd_linear, bearing::Law::ehd});
  BOOST_TEST(!three[0].errors.has_value());
  BOOST_REQUIRE((three[1].errors && three[2].errors));
  const double apart_m = std::abs(three[1].displacement_m - three[2].displacement_m);
  BOOST_TEST(apart_m > 0);
  BOOST_TEST(three[1].errors->displacement_m > apart_m);
  BOOST_TEST(three[2].errors->displacement_m > 0);
  BOOST_TEST(three[2].errors->any_force_N >= three[2].errors->largest_force_N);
  BOOST_REQUIRE(three[2].errors->smallest_film.has_value());
  BOOST_TEST(*three[2].errors->smallest_film > 0);
  BOOST_TEST(!balanced({bearing::Law::ehd_linear}).front().errors.has_value());
  BOOST_TEST(balanced({bearing::Law::ehd}).front().errors.has_value());
}

// Wrong films move the ring across the load only where the rollers are not symmetric to it.
BOOST_AUTO_TEST_CASE(the_errors_cover_a_solver_that_is_wrong_by_its_stated_error_along_and_across_the_load) {
  for (const double first_deg : {0.0, 3.0}) {
    const BearingResult truth = balanced({bearing::Law::ehd}, 0, first_deg).front();
    const BearingResult wrong = balanced({bearing::Law::ehd}, 1, first_deg).front();
    BOOST_REQUIRE(truth.errors.has_value());
    const double along_m = std::abs(wrong.displacement_m - truth.displacement_m);
    const double across_m = std::abs(wrong.displacement_lateral_m - truth.displacement_lateral_m);
    BOOST_TEST(along_m > 0);
    BOOST_TEST(along_m <= truth.errors->displacement_m);
    BOOST_TEST(across_m <= truth.errors->displacement_lateral_m);
    BOOST_TEST((across_m > 0) == (first_deg > 0));
    BOOST_TEST((truth.errors->displacement_lateral_m > 0) == (first_deg > 0));
    BOOST_TEST(truth.errors->displacement_lateral_m < 2 * truth.errors->displacement_m);
  }
}

BOOST_AUTO_TEST_CASE(a_sum_with_an_infinite_source_is_not_known) {
  BOOST_TEST(!sum_of({}).has_value());
  const BudgetRow one{.displacement_m = 1e-8, .largest_force_N = 2, .any_force_N = 3};
  BudgetRow film{.displacement_m = 2e-8, .largest_force_N = 4, .any_force_N = 5, .smallest_film = 1e-3};
  const auto sum = sum_of({one, film});
  BOOST_REQUIRE(sum.has_value());
  EHD_CHECK(error(sum->displacement_m, 3e-8), Tolerance::round_off(2));
  BOOST_TEST(sum->largest_force_N == 6);
  BOOST_TEST(sum->any_force_N == 8);
  BOOST_TEST((sum->smallest_film == 1e-3));
  for (double* const number : {&film.displacement_m, &film.any_force_N, &*film.smallest_film}) {
    const double before = *number;
    *number = std::numeric_limits<double>::infinity();
    BOOST_TEST(!sum_of({one, film}).has_value());
    *number = before;
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd
