// SPDX-License-Identifier: GPL-3.0-or-later
// Rungs 8 to 10 of reference.linear. Truths: this project's high-order collocation unless said otherwise. Films of
// Barus' and Kostreva's contacts on 256 intervals are judged by the claims of their cases.
#include "reference/graded.hpp"

#include "contact/film_formulas.hpp"
#include "contact/nondimensional.hpp"
#include "reference/map.hpp"
#include "tests/check.hpp"
#include "tests/reference/problems.hpp"
#include "tests/truths.hpp"

using namespace ehd;
using namespace ehd::testing;
using reference::Graded;
using verification::Tolerance;

static_assert(Solver<Graded>);

namespace {

/// Converged, within the tolerance, and within the stated error.
void check_films(const Truth& truth, double tolerance) {
  const Solution solution = Graded{}.solve(roelands_problem(truth.M, truth.L, inlet_of(truth)), within(tolerance));
  BOOST_TEST_CONTEXT("M = " << truth.M << ", L = " << truth.L << (truth.flooded ? ", flooded" : ", cut")
                            << ", tolerance " << tolerance) {
    BOOST_REQUIRE(solution.record.status == StopReason::converged);
    for (const auto& [quantity, film] :
         {std::pair{Quantity::film_minimum, truth.minimum}, {Quantity::film_central, truth.central}}) {
      const double missed = error(value(solution, quantity), film);
      EHD_CHECK(missed, Tolerance::required(tolerance + truths_known_to, "--tolerance"));
      EHD_CHECK(missed, Tolerance::discretisation(stated_error(solution, quantity) + truths_known_to, 1));
      EHD_CHECK(stated_error(solution, quantity), Tolerance::required(tolerance, "--tolerance"));
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(graded)

// The grids agreed on H_0 to 9e-6. Truth: reference to 1e-9.
BOOST_AUTO_TEST_CASE(an_offset_on_which_grids_agree_by_chance_has_an_error_that_holds) {
  const Solution solution = Graded{}.solve(barus_problem(13.164, 20.0253, Flooded{}), on_nodes(64));
  BOOST_REQUIRE(solution.record.status == StopReason::under_resolved);
  check_stated(solution, Quantity::film_offset, -0.3391432252);
}

BOOST_AUTO_TEST_CASE(films_of_the_table_within_a_thousandth) {
  for (const Truth& truth : truths) check_films(truth, 1e-3);
}

BOOST_AUTO_TEST_CASE(films_of_moderate_contacts_within_a_hundred_thousandth) {
  int rows = 0;
  for (const Truth& truth : truths) {
    if (truth.M > 100) continue;
    check_films(truth, 1e-5);
    ++rows;
  }
  BOOST_TEST(rows == 6);
}

BOOST_AUTO_TEST_CASE(rigid_isoviscous_limit_is_martins) {
  // H_min = 2.447484/M (Moes), exit 0.47513 sqrt(2 H_min). The elastic deflection remains: it lowers with M; at M =
  // 0.05 the pressure p_H P_max with P_max ~ M bends the gap by about P_max/H ~ 1e-3 of itself.
  const Solution solution = Graded{}.solve(barus_problem(0.05, 0, Flooded{}), within(1e-4));
  BOOST_REQUIRE(solution.record.status == StopReason::converged);
  const double film = value(solution, Quantity::film_minimum);
  const auto elastic = Tolerance::asymptotic(2e-3, "elastic deflection at M = 0.05");
  EHD_CHECK(error(film * moes_film_per_hertz_film(0.05), 2.447484 / 0.05), elastic);
  EHD_CHECK(error(value(solution, Quantity::film_couette) * moes_film_per_hertz_film(0.05), 3 / 0.05), elastic);
  EHD_CHECK(error(value(solution, Quantity::pressure_exit) / std::sqrt(2 * film), 0.4751299200930562), elastic);
  // And the remainder vanishes with M.
  const Solution lighter = Graded{}.solve(barus_problem(0.005, 0, Flooded{}), within(1e-4));
  EHD_CHECK(error(value(lighter, Quantity::film_minimum) * moes_film_per_hertz_film(0.005), 2.447484 / 0.005),
            Tolerance::asymptotic(1.2e-4, "elastic deflection at M = 0.005 and the discretisation of 1e-4"));
}

BOOST_AUTO_TEST_CASE(flooded_is_the_limit_of_far_inlets_within_the_stated_truncation) {
  const Problem endless = barus_problem(1, 5, Flooded{});
  const Solution flooded_film = Graded{}.solve(endless, within(1e-5));
  BOOST_REQUIRE(flooded_film.record.status == StopReason::converged);
  BOOST_TEST(flooded_film.record.film_central.truncation > 0);
  EHD_CHECK(flooded_film.record.film_central.truncation, Tolerance::required(1e-6, "truncation below 1e-6 of H_cen"));
  // A domain begun at -20, -40, -80 half-widths misses it by X_a^-2.
  std::vector<double> missed;
  for (const double inlet : {-20.0, -40.0, -80.0, -160.0}) {
    const Solution cut = Graded{}.solve(barus_problem(1, 5, TruncatedAt{inlet}), within(1e-5));
    BOOST_REQUIRE(cut.record.status == StopReason::converged);
    BOOST_TEST(cut.fields.X[0] == inlet);
    missed.push_back(error(value(cut, Quantity::film_central), value(flooded_film, Quantity::film_central)));
  }
  EHD_CHECK(std::abs(fitted_order(missed) - 2), Tolerance::asymptotic(0.25, "plain truncation falls as X_a^-2"));
}

BOOST_AUTO_TEST_CASE(light_loads_with_a_close_inlet_are_solved) {
  // At M = 0.5, L = 20 the film's own length sqrt(2 H) is beyond the inlet at -4: only a solution is required.
  const Solution solution = Graded{}.solve(barus_problem(0.5, 20, TruncatedAt{-4}), within(1e-3));
  BOOST_TEST((solution.record.status == StopReason::converged));
}

BOOST_AUTO_TEST_CASE(map_puts_nested_grids_on_the_same_points) {
  const reference::GradedMap map = reference::first_map(-4000, 0.02);
  const reference::Grid coarse = map.grid(50), fine = map.grid(200);
  for (Eigen::Index i = 0; i <= 50; ++i)
    EHD_CHECK(std::abs(coarse.fractions[i] - fine.fractions[4 * i]), Tolerance::round_off(10));
  BOOST_TEST(fine.fractions[0] == 1);
  BOOST_TEST(fine.fractions[200] == 0);
  BOOST_TEST((fine.fractions.head(200) > fine.fractions.tail(200)).all());
}

BOOST_AUTO_TEST_CASE(one_grid_is_solved_where_one_is_asked) {
  const Solution solution = Graded{}.solve(roelands_problem(20, 10, TruncatedAt{-4}), on_nodes(333));
  BOOST_REQUIRE(solution.record.status == StopReason::converged);
  BOOST_TEST(solution.fields.X.size() == 334);
  EHD_CHECK(error(value(solution, Quantity::film_central), truth_at(20, 10).central),
            Tolerance::discretisation(stated_error(solution, Quantity::film_central), 1));
  const Solution memory =
      Graded{}.solve(roelands_problem(20, 10, TruncatedAt{-4}), on_nodes(Graded::largest_nodes + 1));
  BOOST_TEST((memory.record.status == StopReason::limit_reached));
}

BOOST_AUTO_TEST_CASE(a_spike_is_reported_with_its_uncertainty_or_not_at_all) {
  // (5, 5): resolved, truth 0.949170429. Barus at (20, 10): its height grows with the grid, so it is not reported, nor
  // is a maximum that is the spike.
  const Solution tame = Graded{}.solve(roelands_problem(5, 5, TruncatedAt{-4}), within(1e-4));
  EHD_CHECK(error(value(tame, Quantity::pressure_spike), .949170429),
            Tolerance::discretisation(stated_error(tame, Quantity::pressure_spike), 1));
  const Solution wild = Graded{}.solve(barus_problem(20, 10, TruncatedAt{-4}), within(1e-4));
  BOOST_TEST(!wild.observables.contains(Quantity::pressure_spike));
  BOOST_TEST(!wild.observables.contains(Quantity::pressure_maximum));
}

BOOST_AUTO_TEST_SUITE_END()
