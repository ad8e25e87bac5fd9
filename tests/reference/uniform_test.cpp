// SPDX-License-Identifier: GPL-3.0-or-later
// Rungs 6, 8 and 10 of reference.uniform.
#include "reference/uniform.hpp"

#include "tests/check.hpp"
#include "tests/reference/problems.hpp"
#include "tests/truths.hpp"

using namespace ehd;
using namespace ehd::testing;
using reference::Uniform;
using verification::Tolerance;

static_assert(Solver<Uniform>);

namespace {

/// Both films within the error that the solution states for itself.
void check_stated_errors(const Solution& solution, const Truth& truth) {
  EHD_CHECK(error(value(solution, Quantity::film_minimum), truth.minimum),
            Tolerance::discretisation(stated_error(solution, Quantity::film_minimum), 1));
  EHD_CHECK(error(value(solution, Quantity::film_central), truth.central),
            Tolerance::discretisation(stated_error(solution, Quantity::film_central), 1));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(uniform)

// Two grids agreed on X* to 1.2e-4. Truth: reference to 1e-12.
BOOST_AUTO_TEST_CASE(an_exit_on_which_two_grids_agree_by_chance_has_an_error_that_holds) {
  const Solution solution = Uniform{}.solve(barus_problem(45.1193, 0, TruncatedAt{-7.4604}), on_nodes(200));
  BOOST_REQUIRE(solution.record.status == StopReason::under_resolved);
  check_stated(solution, Quantity::pressure_exit, 1.0115102756);
}

// Two grids agree on the largest pressure to 3e-4, and both are 8e-3 off. The films' error is more than 5 %: so no
// maximum is reported.
BOOST_AUTO_TEST_CASE(a_maximum_on_which_two_grids_agree_by_chance_is_not_reported) {
  const Solution solution = Uniform{}.solve(barus_problem(0.71275, 15.565, Flooded{}), on_nodes(48));
  BOOST_TEST(!solution.observables.contains(Quantity::pressure_maximum));
  BOOST_TEST(solution.observables.contains(Quantity::film_minimum));
}

BOOST_AUTO_TEST_CASE(films_of_one_grid_are_within_their_stated_error) {
  const Solution mild = Uniform{}.solve(roelands_problem(5, 5, TruncatedAt{-4}), on_nodes(512));
  BOOST_REQUIRE(mild.record.status == StopReason::converged);
  check_stated_errors(mild, truth_at(5, 5));
  const Solution moderate = Uniform{}.solve(roelands_problem(20, 10, TruncatedAt{-4}), on_nodes(512));
  BOOST_REQUIRE(moderate.record.status == StopReason::converged);
  check_stated_errors(moderate, truth_at(20, 10));
  BOOST_TEST(moderate.fields.X.size() == 513);
  BOOST_TEST(moderate.record.cost.nodes == 512);
  EHD_CHECK(stated_error(moderate, Quantity::film_central),
            Tolerance::required(2e-3, "an error estimate that says nothing would cover everything"));
  EHD_CHECK(value(moderate, Quantity::load_error), Tolerance::round_off(513));
  EHD_CHECK(value(moderate, Quantity::flux_variation), Tolerance::required(1e-11, "converged to the rounding floor"));
}

BOOST_AUTO_TEST_CASE(a_grid_reports_its_own_film_not_an_extrapolated_one) {
  // The twin contract: the reported values are those of the fields.
  const Solution solution = Uniform{}.solve(roelands_problem(20, 10, TruncatedAt{-4}), on_nodes(256));
  const Eigen::Index n = solution.fields.X.size() - 1;
  BOOST_REQUIRE_EQUAL(n, 256);
  const double h = (solution.fields.X[n] + 4) / 256;
  for (Eigen::Index i = 0; i <= n; ++i)
    EHD_CHECK(std::abs(solution.fields.X[i] - (-4 + static_cast<double>(i) * h)), Tolerance::round_off(10));
  EHD_CHECK(value(solution, Quantity::film_minimum) / solution.fields.H.minCoeff() - 1, Tolerance::round_off(1));
  BOOST_TEST(solution.fields.P[0] == 0);
  BOOST_TEST(solution.fields.P[n] == 0);
  EHD_CHECK(error(value(solution, Quantity::film_couette), solution.fields.H[n]), Tolerance::round_off(1));
}

BOOST_AUTO_TEST_CASE(central_film_converges_with_the_declared_order) {
  for (const Truth& truth : {truth_at(5, 5), truth_at(20, 10)}) {
    std::vector<double> errors;
    for (const int n : {128, 256, 512, 1024}) {
      const Solution solution = Uniform{}.solve(roelands_problem(truth.M, truth.L, TruncatedAt{-4}), on_nodes(n));
      BOOST_REQUIRE(solution.record.status == StopReason::converged);
      errors.push_back(error(value(solution, Quantity::film_central), truth.central));
    }
    EHD_CHECK(std::abs(fitted_order(errors) - Uniform::description.formal_order),
              Tolerance::calibrated(0.15, "pairwise ratios 3.6..4.1 over these grids"));
  }
}

BOOST_AUTO_TEST_CASE(a_grid_that_cannot_see_the_inlet_zone_is_under_resolved) {
  // At (1000, 10) the inlet zone is 0.0098 wide; a cell of n = 512 is 0.0098, of 256 0.020.
  const Problem problem = roelands_problem(1000, 10, TruncatedAt{-4});
  for (const int n : {256, 512}) {
    const Solution solution = Uniform{}.solve(problem, on_nodes(n));
    BOOST_REQUIRE(solution.record.status == StopReason::under_resolved);
    BOOST_TEST(!solution.record.reason.empty());
    check_stated_errors(solution, truth_at(1000, 10));
    // The equations themselves are solved: a small residual proves nothing.
    EHD_CHECK(value(solution, Quantity::flux_variation), Tolerance::required(1e-8, "the residual that misleads"));
  }
  const Solution none = Uniform{}.solve(problem, on_nodes(128));
  BOOST_TEST((none.record.status == StopReason::under_resolved));
  BOOST_TEST(none.observables.empty());
}

BOOST_AUTO_TEST_CASE(tolerance_is_met_by_doubling_the_grid) {
  const Solution solution = Uniform{}.solve(roelands_problem(5, 5, TruncatedAt{-4}), within(1e-3));
  BOOST_REQUIRE(solution.record.status == StopReason::converged);
  check_stated_errors(solution, truth_at(5, 5));
  EHD_CHECK(stated_error(solution, Quantity::film_minimum), Tolerance::required(1e-3, "--tolerance 1e-3"));
  EHD_CHECK(stated_error(solution, Quantity::film_central), Tolerance::required(1e-3, "--tolerance 1e-3"));
  BOOST_REQUIRE_GE(solution.record.grids.size(), 3);
  for (std::size_t k = 1; k < solution.record.grids.size(); ++k)
    BOOST_TEST(solution.record.grids[k].nodes == 2 * solution.record.grids[k - 1].nodes);
}

BOOST_AUTO_TEST_CASE(a_tolerance_is_never_met_on_a_grid_that_cannot_see_the_inlet_zone) {
  const Request request = within(0.9);  // nine tenths: any number would do
  const Solution solution = Uniform{}.solve(roelands_problem(200, 15, TruncatedAt{-4}), request);
  BOOST_REQUIRE(solution.record.status == StopReason::converged);
  BOOST_TEST(solution.record.grids.back().inlet_cells >= 1.5);
  check_stated_errors(solution, truth_at(200, 15));
}

BOOST_AUTO_TEST_CASE(flooded_inlet_is_reached_by_stretched_cells) {
  const Solution solution = Uniform{}.solve(roelands_problem(5, 5, Flooded{}), on_nodes(512));
  BOOST_REQUIRE(solution.record.status == StopReason::converged);
  check_stated_errors(solution, truth_at(5, 5, true));
  BOOST_TEST(solution.fields.X[0] < -500);
  BOOST_TEST(solution.record.film_central.truncation > 0);
  EHD_CHECK(solution.record.film_central.truncation, Tolerance::required(1e-5, "flooded: truncation below 1e-5"));
}

BOOST_AUTO_TEST_CASE(limits_end_a_solve_with_a_reason) {
  const Problem problem = roelands_problem(20, 10, TruncatedAt{-4});
  Request request = within(1e-12);
  request.max_iterations = 12;
  const Solution iterations = Uniform{}.solve(problem, request);
  BOOST_TEST((iterations.record.status == StopReason::limit_reached));
  BOOST_TEST(!iterations.record.reason.empty());
  BOOST_TEST(iterations.record.cost.newton_iterations <= 12);
  request = within(1e-12);
  request.time_limit_s = 0.3;
  const Solution time = Uniform{}.solve(problem, request);
  BOOST_TEST((time.record.status == StopReason::limit_reached));
  BOOST_REQUIRE(time.observables.contains(Quantity::film_central));
  check_stated_errors(time, truth_at(20, 10));
  const Solution memory = Uniform{}.solve(problem, on_nodes(Uniform::largest_nodes + 1));
  BOOST_TEST((memory.record.status == StopReason::limit_reached));
  BOOST_TEST(memory.observables.empty());
  BOOST_TEST(memory.record.cost.newton_iterations == 0);
}

BOOST_AUTO_TEST_CASE(what_is_not_wanted_is_not_reported) {
  Problem problem = roelands_problem(5, 5, TruncatedAt{-4});
  problem.wanted = {Quantity::pressure_exit, Quantity::film_minimum};
  const Solution solution = Uniform{}.solve(problem, on_nodes(128));
  BOOST_TEST(solution.observables.size() == 2);
  BOOST_TEST(solution.observables.contains(Quantity::pressure_exit));
  BOOST_TEST(solution.observables.contains(Quantity::film_minimum));
}

BOOST_AUTO_TEST_CASE(trivial_laws_cost_no_evaluations) {
  const Solution isoviscous = Uniform{}.solve(barus_problem(10, 0, TruncatedAt{-4}), on_nodes(128));
  BOOST_REQUIRE(isoviscous.record.status == StopReason::converged);
  BOOST_TEST(isoviscous.record.cost.viscosity_points == 0);
  BOOST_TEST(isoviscous.record.cost.density_points == 0);
  const Solution barus = Uniform{}.solve(barus_problem(10, 5, TruncatedAt{-4}), on_nodes(128));
  BOOST_TEST(barus.record.cost.viscosity_points > 0);
  BOOST_TEST(barus.record.cost.density_points == 0);
}

BOOST_AUTO_TEST_SUITE_END()
