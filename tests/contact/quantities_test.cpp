// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/quantities.hpp"

#include <set>
#include <string>

#include "contact/observables.hpp"
#include "contact/solution.hpp"
#include "tests/check.hpp"

namespace {

using namespace ehd;

Wanted those_that(bool (*holds)(Quantity)) {
  Wanted found;
  for (const Quantity quantity : all_quantities) {
    if (holds(quantity)) found.insert(quantity);
  }
  return found;
}

/// Fields of a made-up contact that has every quantity, a spike included.
Fields made_fields() {
  Fields fields;
  fields.X = Array::LinSpaced(201, -3, 1.1);
  const Array spike = 0.5 * (-((fields.X - 0.8) / 0.03).square()).exp();
  fields.P = (1 - fields.X.square()).max(0).sqrt() + spike;
  fields.H = 0.2 + 0.1 * (fields.X - 0.9).square();
  fields.density = 1 + 0.2 * fields.P;
  fields.log_viscosity = 9 * fields.P;
  fields.flux = Array::Constant(200, 0.21);
  fields.offset = -0.37;
  return fields;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(quantities)

BOOST_AUTO_TEST_CASE(every_quantity_has_one_row_with_a_name_of_its_own) {
  std::set<std::string_view> names, entries;
  for (const Quantity quantity : all_quantities) {
    const QuantityRow& row = row_of(quantity);
    BOOST_TEST_CONTEXT(row.name) {
      BOOST_TEST((row.quantity == quantity));
      BOOST_TEST((quantity_from(to_string(quantity)) == quantity));
      BOOST_TEST(!row.meaning.empty());
      BOOST_TEST(!row.unit.empty());
      BOOST_TEST(names.insert(row.name).second);
      BOOST_TEST(entries.insert(row.json_entry).second);
    }
  }
  BOOST_TEST(names.size() == 11);
  BOOST_TEST(!quantity_from("film.unknown"));
}

BOOST_AUTO_TEST_CASE(predicates_name_the_quantities_that_cases_and_solvers_rely_on) {
  using enum Quantity;
  BOOST_TEST((those_that(has_absolute_error) == Wanted{film_offset, approach}));
  BOOST_TEST((those_that(is_film) == Wanted{film_minimum, film_central, film_couette}));
  BOOST_TEST((those_that(is_pressure_peak) == Wanted{pressure_maximum, pressure_spike}));
  BOOST_TEST((those_that(is_self_check) == Wanted{load_error, flux_variation}));
  BOOST_TEST((those_that(exists_when_dry) == Wanted{film_offset, pressure_maximum, pressure_exit, approach}));
  BOOST_TEST(names_of_quantities(exists_when_dry) == "film.offset, pressure.maximum, pressure.exit, approach");
}

BOOST_AUTO_TEST_CASE(scalings_follow_from_what_a_quantity_is) {
  for (const QuantityRow& row : quantity_table()) {
    BOOST_TEST_CONTEXT(row.name) {
      const bool of_film = row.name.starts_with("film."), of_pressure = row.name.starts_with("pressure.");
      BOOST_TEST(row.in_moes_units == is_film(row.quantity));
      BOOST_TEST(row.kostreva_factor.has_value() == (of_film || of_pressure));
      BOOST_TEST(row.kostreva_factor.value_or(2) == (of_pressure ? 1 : 2));  // h_K = 2 H, k = 2 H_0
      BOOST_TEST((row.SI == SIScale::pressure) == is_pressure_peak(row.quantity));
      BOOST_TEST((row.SI == SIScale::force) == (row.kind == QuantityKind::force));
      BOOST_TEST((row.SI == SIScale::film) == (is_film(row.quantity) || row.quantity == Quantity::approach));
    }
  }
}

BOOST_AUTO_TEST_CASE(observe_gives_exactly_the_wanted_quantities) {
  const Fields fields = made_fields();
  const Observables everything = observe(fields, want_everything());
  BOOST_TEST(everything.size() == all_quantities.size());
  int seen = 0;
  for (const QuantityRow& row : quantity_table()) {
    BOOST_TEST_CONTEXT(row.name) {
      const Observables alone = observe(fields, {row.quantity});
      BOOST_REQUIRE(alone.size() == 1);
      BOOST_TEST(alone.begin()->second.value == everything.at(row.quantity).value);
      ++seen;
    }
  }
  BOOST_TEST(seen == 11);
}

BOOST_AUTO_TEST_CASE(the_record_keeps_the_parts_of_the_error_of_the_two_films_that_a_tolerance_is_for) {
  SolveRecord record;
  record.film_minimum.discretisation = 0.3;
  record.film_central.discretisation = 0.7;
  BOOST_TEST((record.*row_of(Quantity::film_minimum).budget).discretisation == 0.3);
  BOOST_TEST((record.*row_of(Quantity::film_central).budget).discretisation == 0.7);
  int others = 0;
  for (const QuantityRow& row : quantity_table()) others += row.budget == nullptr;
  BOOST_TEST(others == 9);
}

BOOST_AUTO_TEST_SUITE_END()
