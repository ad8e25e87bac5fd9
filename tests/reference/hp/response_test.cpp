// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hp/response.hpp"

#include <algorithm>

#include "tests/check.hpp"
#include "tests/reference/problems.hpp"

namespace {

using namespace ehd;
using namespace ehd::testing;
using reference::hp::response;
using verification::Tolerance;

}  // namespace

BOOST_AUTO_TEST_SUITE(hp_response)

// Computed independently, inlet cut at -50.
BOOST_AUTO_TEST_CASE(stiffness_at_rest_has_the_digits_of_another_program) {
  const Response found = response(roelands_problem(5, 5, TruncatedAt{-50}), {.frequencies = {0}});
  BOOST_TEST((found.status == StopReason::converged));
  BOOST_REQUIRE(found.slow.has_value());
  EHD_CHECK(error(found.slow->kappa_0, 3.8279353), Tolerance::published_digits("3.8279353"));
  EHD_CHECK(error(found.frequencies.at(0).kappa.real(), found.slow->kappa_0), Tolerance::round_off(1e4));
  BOOST_TEST(found.highest_certified.value() == 0.0);
}

BOOST_AUTO_TEST_CASE(a_moderate_load_has_the_digits_of_another_program) {
  const Response found = response(roelands_problem(20, 10, TruncatedAt{-50}), {.frequencies = {}});
  BOOST_REQUIRE(found.slow.has_value());
  EHD_CHECK(error(found.slow->kappa_0, 4.3454066), Tolerance::published_digits("4.3454066"));
}

BOOST_AUTO_TEST_CASE(answers_keep_the_order_of_the_request_and_the_tolerance) {
  const Response found = response(roelands_problem(5, 5, TruncatedAt{-4}),
                                  {.frequencies = {7, 0.5, 2}, .waviness = {{2, 1}, {1, 0}}, .tolerance = 1e-6});
  BOOST_TEST((found.status == StopReason::converged));
  BOOST_TEST(found.frequencies.at(0).Omega == 7.0);
  BOOST_TEST(found.frequencies.at(1).Omega == 0.5);
  BOOST_TEST(found.waviness.at(1).waviness.wavelength == 1.0);
  BOOST_TEST(found.highest_certified.value() == 7.0);
  const auto asked = Tolerance::required(1e-6, "the tolerance of the request");
  for (const Stiffness& at : found.frequencies) EHD_CHECK(at.error, asked);
  for (const WavinessResponse& at : found.waviness) EHD_CHECK(at.error, asked);
}

// The tail of a flooded inlet limits what is known at high frequencies, and no mesh helps.
BOOST_AUTO_TEST_CASE(a_frequency_beyond_what_is_known_names_the_highest_certified_one) {
  const Problem problem = roelands_problem(5, 5, Flooded{});
  const Response found = response(problem, {.frequencies = {1, 1000}});
  BOOST_TEST((found.status == StopReason::tolerance_not_met));
  BOOST_TEST(!found.reason.empty());
  BOOST_TEST((found.frequencies.at(0).status == StopReason::converged));
  BOOST_TEST((found.frequencies.at(1).status == StopReason::tolerance_not_met));
  BOOST_TEST(found.frequencies.at(1).error > 1e-8);
  const double highest = found.highest_certified.value();
  BOOST_TEST(highest > 1);
  BOOST_TEST(highest < 1000);
  const Response again = response(problem, {.frequencies = {highest}});
  BOOST_TEST((again.status == StopReason::converged));
}

// Barus at (20, 10), incompressible: the descent ends on a floor of the fluidity.
BOOST_AUTO_TEST_CASE(the_move_from_a_floor_is_part_of_the_error) {
  const Response found = response(barus_problem(20, 10, TruncatedAt{-4}), {.frequencies = {1}, .tolerance = 1e-5});
  BOOST_TEST((found.status == StopReason::converged));
  BOOST_TEST(found.notes.size() == 1U);
  BOOST_TEST(found.frequencies.at(0).error > 1e-10);
}

// About the first steady state of this contact kappa_1 is known to 3e-4 only.
BOOST_AUTO_TEST_CASE(where_the_floor_hides_kappa_1_the_descent_goes_on) {
  const Response found = response(barus_problem(100, 14, TruncatedAt{-4}), {.frequencies = {}, .tolerance = 1e-4});
  BOOST_TEST((found.status == StopReason::converged));
  BOOST_REQUIRE(found.slow.has_value());
  EHD_CHECK(found.slow->error_1, Tolerance::required(1e-4, "the tolerance of the request"));
}

BOOST_AUTO_TEST_CASE(a_limit_that_the_start_meets_ends_as_a_limit) {
  const Response found = response(barus_problem(100, 14, TruncatedAt{-4}), {.frequencies = {}, .max_iterations = 2});
  BOOST_TEST((found.status == StopReason::limit_reached));
}

BOOST_AUTO_TEST_CASE(limits_end_the_solve_without_numbers) {
  const Response found = response(roelands_problem(20, 10, Flooded{}), {.frequencies = {1}, .time_limit_s = 0});
  BOOST_TEST((found.status == StopReason::limit_reached));
  BOOST_TEST(!found.slow.has_value());
  BOOST_TEST(!found.highest_certified.has_value());
  BOOST_TEST((found.frequencies.at(0).status != StopReason::converged));
  BOOST_TEST(found.cost.wall_s > 0);
}

BOOST_AUTO_TEST_SUITE_END()
