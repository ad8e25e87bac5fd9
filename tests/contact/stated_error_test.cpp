// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/stated_error.hpp"

#include "contact/observables.hpp"
#include "tests/check.hpp"

namespace {

using namespace ehd;
using verification::Tolerance;

/// A film of closed form on equal cells: 0.07 at X = 0, 0.05 at X = 0.8.
Solution on_a_grid() {
  Solution solution;
  Fields& fields = solution.fields;
  fields.X = Array::LinSpaced(41, -3.0, 1.0);
  fields.H = 0.05 + 0.02 / 0.64 * (fields.X - 0.8).square();
  fields.P = Array::Constant(41, 0.3);
  fields.density = Array::Constant(41, 1.1);
  return solution;
}

/// The same with reported films that are `minimum` and `central` times those of the fields, known to 1e-3 and 2e-3.
Solution reported(double minimum, double central) {
  Solution solution = on_a_grid();
  solution.observables = observe(solution.fields, {judged_films.begin(), judged_films.end()});
  Reading& smallest = solution.observables.at(Quantity::film_minimum);
  Reading& at_zero = solution.observables.at(Quantity::film_central);
  smallest.value *= minimum;
  at_zero.value *= central;
  smallest.error = 1e-3;
  at_zero.error = 2e-3;
  return solution;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(stated_error)

BOOST_AUTO_TEST_CASE(a_grid_is_fine_enough_where_both_films_are_known_to_less_than_ten_percent) {
  using testing::infinity, testing::not_a_number;
  const ErrorBudget fine{.discretisation = 0.06, .iteration = 0.02, .truncation = 0.0199}, exact{};
  BOOST_TEST(!too_coarse(fine, fine).has_value());
  BOOST_TEST(!too_coarse(exact, exact).has_value());
  for (const double off : {0.1, 1.29, infinity, not_a_number}) {
    const ErrorBudget coarse{.discretisation = off};
    BOOST_TEST(too_coarse(coarse, exact).has_value());
    BOOST_TEST(too_coarse(exact, coarse).has_value());
  }
  const ErrorBudget sum{.discretisation = 0.04, .iteration = 0.04, .truncation = 0.04};
  BOOST_TEST(too_coarse(exact, sum).value() ==
             "the grid is too coarse: the stated error of the films is 12 %, not below 10 %");
}

BOOST_AUTO_TEST_CASE(a_grid_is_solved_where_fields_are_left_however_coarse_it_is) {
  Solution solution = on_a_grid();
  for (const auto& [status, solved] : {std::pair{StopReason::converged, true},
                                       {StopReason::tolerance_not_met, true},
                                       {StopReason::under_resolved, true},
                                       {StopReason::limit_reached, false},
                                       {StopReason::diverged, false}}) {
    solution.record.status = status;
    BOOST_TEST(solved_on_its_grid(solution) == solved);
  }
  solution.fields = {};
  solution.record.status = StopReason::under_resolved;
  BOOST_TEST(!solved_on_its_grid(solution));
}

BOOST_AUTO_TEST_CASE(fields_err_by_their_distance_from_the_reported_film_and_by_its_error) {
  // The film in the fields is 1/0.96 of the reported one, or 1/1.05; the other film is the reported one itself.
  const Tolerance rounding = Tolerance::round_off(100, 1 / 0.04);
  EHD_CHECK(error(field_error(reported(0.96, 1)).value(), 1 / 0.96 - 1 + 1e-3), rounding);
  EHD_CHECK(error(field_error(reported(1, 1.05)).value(), 1 - 1 / 1.05 + 2e-3), rounding);
  EHD_CHECK(error(field_error(reported(1, 1)).value(), 2e-3), rounding);
}

BOOST_AUTO_TEST_CASE(without_fields_films_or_their_errors_the_fields_have_no_error) {
  BOOST_TEST(!field_error(Solution{}).has_value());
  BOOST_TEST(!field_error(on_a_grid()).has_value());
  for (const Quantity film : judged_films) {
    Solution solution = reported(1, 1);
    solution.observables.at(film).error.reset();
    BOOST_TEST(!field_error(solution).has_value());
    solution.observables.erase(film);
    BOOST_TEST(!field_error(solution).has_value());
  }
}

BOOST_AUTO_TEST_CASE(a_pressure_errs_by_five_distances_to_the_farthest_one_beside_it) {
  // Hats on [-1, 1]; their distance in L2 is the difference of their heights.
  const auto hat = [](double height) {
    Fields fields;
    fields.X = Array::LinSpaced(3, -1, 1);
    fields.P = height * (1 - fields.X.abs());
    return fields;
  };
  Solution solution;
  solution.fields = hat(1);
  BOOST_TEST(!pressure_error(solution).has_value());
  solution.beside = {hat(1.01), hat(0.97)};
  EHD_CHECK(error(pressure_error(solution).value(), 5 * 0.03), Tolerance::round_off(100, 1 / 0.03));
}

BOOST_AUTO_TEST_SUITE_END()
