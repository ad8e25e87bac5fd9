// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/error_budget.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "contact/hertz.hpp"
#include "contact/scaling.hpp"
#include "tests/check.hpp"

namespace ehd::verification {

namespace {

Case needle_bearing() {
  Case one;
  one.id = "needle";
  one.version = 1;
  one.lines = {{"operation.speed_rpm", 7}, {"operation", 5}, {"", 1}};
  one.file = "needle.toml";
  BearingCase body;
  body.geometry = {.rollers = 19,
                   .pitch_diameter_m = 0.060,
                   .roller_diameter_m = 0.006,
                   .length_m = 0.05,
                   .clearance_m = 4e-6,
                   .density_kg_per_m3 = 7850};
  body.operation = {.inner_speed_rpm = 4000, .outer_speed_rpm = 0, .radial_load_N = 20e3};
  body.modulus_Pa = 2.06e11;
  body.poisson = 0.3;
  Lubricant oil;
  oil.viscosity = ViscosityLaw::roelands;
  oil.density = DensityLaw::dowson_higginson;
  oil.alpha_per_Pa = 2e-8;
  body.lubricant = BearingLubricant{.lubricant = oil, .viscosity_Pa_s = 0.02};
  one.body = body;
  return one;
}

constexpr double stated = 1e-3;  ///< the synthetic solver's own error of the offset film

/// Films in closed form, the offset film off by `share` of the stated error.
ContactSolver synthetic(double share) {
  return [share](const Problem& problem, const Request&) {
    const double M = problem.groups.M;
    const double martin = 2.4474842468 / M / moes_film_per_hertz_film(M), stiffening = 1 + std::pow(M / 0.25, 1.5);
    const double film = martin * std::pow(stiffening, 0.58);
    Solution solution;
    solution.record.status = StopReason::converged;
    solution.observables[Quantity::film_minimum] = {.value = martin * std::pow(stiffening, 0.56), .error = 1e-6};
    solution.observables[Quantity::film_offset] = {.value = hertz::dry_offset() + film * (1 + share * stated),
                                                   .error = stated * film};
    return solution;
  };
}

std::vector<BearingResult> run(ContactMemory& memory) {
  return run_bearing(needle_bearing(), {.laws = {BearingLaw::hertz, BearingLaw::ehd_linear, BearingLaw::ehd}}, memory);
}

const BudgetRow& row_of(const std::vector<BudgetRow>& rows, const std::string& source) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const BudgetRow& row) { return row.source == source; });
  BOOST_REQUIRE(found != rows.end());
  return *found;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(error_budget)

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
  const auto rows = budget_of(needle_bearing(), results, BearingLaw::ehd_linear, memory);
  BOOST_TEST(memory.solves() == solves);  // another datum needs no other contact
  const BudgetRow& fit = row_of(rows, "fit");
  BOOST_TEST(!fit.bound);
  BOOST_TEST(fit.displacement_m == std::abs(results[1].displacement_m - results[2].displacement_m));
  BOOST_TEST(fit.largest_force_N == std::abs(results[1].rollers[0].inner.force_N - results[2].rollers[0].inner.force_N));
  BOOST_TEST(fit.any_force_N >= fit.largest_force_N);
  BOOST_TEST(std::count_if(rows.begin(), rows.end(), [](const BudgetRow& row) { return row.source == "datum"; }) == 2);
}

BOOST_AUTO_TEST_CASE(a_dry_law_has_no_budget_and_the_full_one_has_no_fit) {
  ContactMemory memory(synthetic(0));
  const auto results = run(memory);
  BOOST_TEST(budget_of(needle_bearing(), results, BearingLaw::hertz, memory).empty());
  for (const BudgetRow& row : budget_of(needle_bearing(), results, BearingLaw::ehd, memory)) {
    BOOST_TEST(row.source != "fit");
    BOOST_TEST(std::isfinite(row.displacement_m));
    BOOST_TEST(row.any_force_N >= row.largest_force_N);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::verification
