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

BOOST_AUTO_TEST_SUITE_END()
