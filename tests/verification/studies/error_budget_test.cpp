// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/error_budget.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/check.hpp"
#include "tests/made_bearing.hpp"

namespace ehd::verification {

namespace {

/// With room, a range of the fit that follows the load, and other rollers than the paper's.
Case needle_bearing() {
  Case one = made::needle_bearing(4e-6);
  auto& body = std::get<BearingCase>(one.body);
  body.geometry.rollers = 19;
  body.operation.radial_load_N = 20e3;
  body.fit = {};
  return one;
}

constexpr double stated = 1e-3;  ///< the synthetic solver's own error of the offset film

/// The offset film off by `share` of the stated error.
ContactSolver synthetic(double share) {
  return [share](const Problem& problem, const Request&) { return made::contact(problem, stated, share); };
}

std::vector<BearingResult> run(ContactMemory& memory) {
  return run_bearing(needle_bearing(), {.laws = {bearing::Law::hertz, bearing::Law::ehd_linear, bearing::Law::ehd}},
                     memory);
}

const BudgetRow& row_of(const std::vector<BudgetRow>& rows, const std::string& source) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const BudgetRow& row) { return row.source == source; });
  BOOST_REQUIRE(found != rows.end());
  return *found;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(studies_error_budget)

// Agreement: films that are wrong by as much as the solver states move the balance within the bound, and the bound is
// not empty: with all errors of one sign at least a hundredth of it is used.
BOOST_AUTO_TEST_CASE(the_solvers_bound_covers_a_solver_that_is_wrong_by_its_stated_error) {
  ContactMemory right(synthetic(0)), wrong(synthetic(1));
  const auto truth = run(right), moved = run(wrong);
  int judged = 0;
  for (const std::size_t k : {1u, 2u}) {
    const auto rows = budget_of(needle_bearing(), truth, truth[k].law, right);
    const BudgetRow& bound = row_of(rows, "contact solver");
    BOOST_TEST(bound.bound);
    const double displacement_m = std::abs(moved[k].displacement_m - truth[k].displacement_m);
    BOOST_TEST(displacement_m <= bound.displacement_m);
    BOOST_TEST(displacement_m >= 0.01 * bound.displacement_m);
    for (std::size_t j = 0; j < truth[k].rollers.size(); ++j) {
      // An unloaded roller of the line has no stiffness: its force is zero in both.
      BOOST_TEST(std::abs(moved[k].rollers[j].inner.force_N - truth[k].rollers[j].inner.force_N) <=
                 bound.any_force_N * (1 + 1e-3));
      ++judged;
    }
    BOOST_TEST(bound.any_force_N < 0.01 * truth[k].rollers[0].inner.force_N);
  }
  BOOST_TEST(judged == 2 * 19);
}

// Exact: a difference is that of the two balances.
BOOST_AUTO_TEST_CASE(the_fits_row_is_the_difference_of_the_two_laws) {
  ContactMemory memory(synthetic(0));
  const auto results = run(memory);
  const long solves = memory.solves();
  const auto rows = budget_of(needle_bearing(), results, bearing::Law::ehd_linear, memory);
  BOOST_TEST(memory.solves() == solves);  // another datum needs no other contact
  const BudgetRow& fit = row_of(rows, "fit");
  BOOST_TEST(!fit.bound);
  BOOST_TEST(fit.displacement_m == std::abs(results[1].displacement_m - results[2].displacement_m));
  BOOST_TEST(fit.largest_force_N ==
             std::abs(results[1].rollers[0].inner.force_N - results[2].rollers[0].inner.force_N));
  BOOST_TEST(fit.any_force_N >= fit.largest_force_N);
  const auto thinnest = [](const BearingResult& result) {
    const ContactPlace place = smallest_film_place(result).value();
    return *result.rollers[place.roller].at(place.raceway).film_minimum_m;
  };
  const double of_line = thinnest(results[1]), of_ehd = thinnest(results[2]);
  BOOST_TEST((fit.smallest_film == std::abs(of_ehd / of_line - 1)));  // relative to the film beside which it stands
  BOOST_TEST(of_ehd != of_line);
  BOOST_TEST(std::count_if(rows.begin(), rows.end(), [](const BudgetRow& row) { return row.source == "datum"; }) == 2);
}

// The line is compared with ehd, so that it is known no better than ehd. Its own contacts are those of the fit.
BOOST_AUTO_TEST_CASE(the_lines_budget_has_the_bounds_of_ehd_and_its_fits_own_contacts) {
  ContactMemory memory(synthetic(0));
  const auto results = run(memory);
  const auto rows = budget_of(needle_bearing(), results, bearing::Law::ehd_linear, memory);
  const BearingResult& line = results[1];
  const BudgetRow &between = row_of(rows, "interpolation"), &below = row_of(rows, "rigid limit");
  const auto full = budget_of(needle_bearing(), results, bearing::Law::ehd, memory);
  for (const BudgetRow* row : {&between, &below}) {
    BOOST_TEST(row->bound);
    BOOST_TEST(row->displacement_m == row_of(full, row->source).displacement_m);
    BOOST_TEST(row->any_force_N == row_of(full, row->source).any_force_N);
  }
  BOOST_TEST(between.displacement_m > 0);
  BOOST_TEST(row_of(rows, "contact solver").displacement_m >= row_of(full, "contact solver").displacement_m);
  // The thinnest film is under the most loaded roller, far above the lightest solved contact.
  BOOST_REQUIRE(between.smallest_film.has_value());
  BOOST_TEST((*between.smallest_film == line.curve->inner.errors().interpolation ||
              *between.smallest_film == line.curve->outer.errors().interpolation));
  BOOST_TEST(*between.smallest_film > 0);
  BOOST_TEST(!below.smallest_film.has_value());
  // Ten times the error at the fit's contacts, ten times the bound, whatever the curve's own contacts are known to.
  auto worse = results;
  for (auto* fit : {&worse[1].fit->inner, &worse[1].fit->outer})
    for (bearing::FitPoint& point : fit->points) point.approach_error_m *= 10;
  const BudgetRow tenfold =
      row_of(budget_of(needle_bearing(), worse, bearing::Law::ehd_linear, memory), "contact solver");
  const BudgetRow own = row_of(rows, "contact solver");
  EHD_CHECK(error(tenfold.displacement_m, 10 * own.displacement_m), Tolerance::round_off(100));
  EHD_CHECK(error(tenfold.any_force_N, 10 * own.any_force_N), Tolerance::round_off(100));
}

// Without ehd among the results the budget of the line is the same.
BOOST_AUTO_TEST_CASE(the_lines_budget_does_not_depend_on_the_laws_that_were_asked_for) {
  ContactMemory memory(synthetic(0));
  const auto results = run(memory);
  const auto beside = budget_of(needle_bearing(), results, bearing::Law::ehd_linear, memory);
  const auto alone = budget_of(needle_bearing(), {results[1]}, bearing::Law::ehd_linear, memory);
  BOOST_REQUIRE(alone.size() == beside.size());
  for (std::size_t k = 0; k < alone.size(); ++k) BOOST_TEST(alone[k].displacement_m == beside[k].displacement_m);
}

// With x_0 near the half width the approach of the heavy contacts falls with the force, which the line does not see.
BOOST_AUTO_TEST_CASE(a_line_without_the_law_ehd_has_no_budget_and_says_why) {
  Case one = needle_bearing();
  std::get<BearingCase>(one.body).datum = LengthDatum{1.5e-5};
  std::get<BearingCase>(one.body).fit = {.load_N = std::pair{500.0, 4000.0}, .points = 6};
  ContactMemory memory(synthetic(0));
  const auto results =
      run_bearing(one, {.laws = {bearing::Law::hertz, bearing::Law::ehd_linear, bearing::Law::ehd}}, memory);
  BOOST_REQUIRE(!results[1].rollers.empty());
  BOOST_REQUIRE(results[2].rollers.empty());
  for (const auto& known : {results, std::vector{results[1]}}) {
    BOOST_TEST(budget_of(one, known, bearing::Law::ehd_linear, memory).empty());
    const auto why = why_no_budget(one, known, bearing::Law::ehd_linear, memory);
    BOOST_REQUIRE(why.has_value());
    BOOST_TEST(why->find(results[2].why) != std::string::npos, *why);
  }
  for (const bearing::Law law : {bearing::Law::hertz, bearing::Law::ehd})
    BOOST_TEST(!why_no_budget(one, results, law, memory).has_value());
  ContactMemory another(synthetic(0));
  BOOST_TEST(!why_no_budget(needle_bearing(), run(another), bearing::Law::ehd_linear, another).has_value());
}

BOOST_AUTO_TEST_CASE(a_dry_law_has_no_budget_and_the_full_one_has_no_fit) {
  ContactMemory memory(synthetic(0));
  const auto results = run(memory);
  BOOST_TEST(budget_of(needle_bearing(), results, bearing::Law::hertz, memory).empty());
  for (const BudgetRow& row : budget_of(needle_bearing(), results, bearing::Law::ehd, memory)) {
    BOOST_TEST(row.source != "fit");
    BOOST_TEST(std::isfinite(row.displacement_m));
    BOOST_TEST(row.any_force_N >= row.largest_force_N);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::verification
