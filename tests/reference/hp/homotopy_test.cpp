// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 6: the descent from a floor of the fluidity to the physics, and the extrapolation to floor 0 where the descent
// ends earlier.
#include "reference/hp/homotopy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/check.hpp"
#include "tests/reference/hp/meshes.hpp"
#include "tests/reference/hp/solved.hpp"
#include "tests/reference/problems.hpp"

namespace {

using namespace ehd;
using namespace ehd::reference::hp;
using namespace ehd::testing;
using verification::Tolerance;

constexpr HomotopyLimits limits{.settled = 2e-6, .newton = {.iterations = 25, .step = 1e-10}};

double flux(const Resolved& solved) { return solved.run.state.flux; }

/// A Resolved of which only floor and flux matter.
Resolved floor_with(double floor, double film) {
  Resolved out;
  out.floor = floor;
  out.run.state.flux = film;
  return out;
}

/// One mesh, one floor, from a state nearby.
NewtonRun solved_at(const Resolved& from, double floor) {
  Meter meter = generous();
  return ehd::reference::hp::newton(*from.equations, from.run.state, floor, {.iterations = 25, .step = 1e-12}, meter);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hp_homotopy)

BOOST_AUTO_TEST_CASE(descent_goes_down_to_the_physics_and_resolves_every_floor) {
  struct Row {
    double M, L, film;
    Inlet inlet;
  };
  const std::vector<Row> table = {{5, 5, 0.3, TruncatedAt{-4}},
                                  {20, 10, 0.0856, TruncatedAt{-4}},
                                  {20, 10, 0.0859, Flooded{}},
                                  {100, 10, 0.0135, Flooded{}}};
  const Resolution resolution{.film = 1e-5, .spike = 1e-3, .defect = 1e-2};
  int rows = 0;
  for (const Row& row : table) {
    const Problem problem = roelands_problem(row.M, row.L, row.inlet);
    Meter meter = generous();
    auto top = resolved(problem, coarse_top(problem, row.film, 1e-2, row.film), resolution, limits, meter);
    BOOST_REQUIRE(top.has_value());
    const auto floors = descent(problem, *top, resolution, limits, meter);
    BOOST_TEST_CONTEXT("M = " << row.M << ", L = " << row.L) {
      BOOST_REQUIRE_GE(floors.size(), 3);
      BOOST_TEST(floors.front().floor == 1e-2);
      BOOST_TEST(floors.back().floor == 0);
      BOOST_TEST(floor_gap(floors) == 0);
      for (std::size_t i = 0; i < floors.size(); ++i) {
        if (i > 0) BOOST_TEST(floors[i].floor < floors[i - 1].floor);
        BOOST_TEST(floors[i].run.solved);
        BOOST_TEST(flux(floors[i]) > 0);
        EHD_CHECK(floors[i].excess, Tolerance::required(1, "homotopy.hpp: 1 where the mesh resolves it"));
        const auto excess = excess_of(*floors[i].equations, floors[i].run, problem, resolution);
        BOOST_TEST(static_cast<int>(excess.size()) == floors[i].equations->mesh().elements());
        BOOST_TEST(*std::max_element(excess.begin(), excess.end()) == floors[i].excess);
      }
      // More fluid lubricant, thinner film.
      BOOST_TEST(flux(floors.front()) < flux(floors.back()));
      // Another start: twice the film, ten times the floor, another first mesh.
      auto other =
          resolved(problem, coarse_top(problem, 1.7 * row.film, 1e-1, 2 * row.film), resolution, limits, meter);
      BOOST_REQUIRE(other.has_value());
      const auto also = descent(problem, *other, resolution, limits, meter);
      BOOST_REQUIRE_EQUAL(also.back().floor, 0);
      BOOST_TEST(also.back().equations->mesh().breakpoints != floors.back().equations->mesh().breakpoints);
      const double missed = error(flux(also.back()), flux(floors.back()));
      BOOST_TEST_MESSAGE(floors.size() << " and " << also.size() << " floors, " << floors.back().equations->intervals()
                                       << " and " << also.back().equations->intervals() << " intervals, apart "
                                       << missed);
      EHD_CHECK(missed, Tolerance::discretisation(resolution.film, floors.back().equations->mesh().elements() +
                                                                       also.back().equations->mesh().elements()));
    }
    ++rows;
  }
  BOOST_TEST(rows == 4);
}

// Barus at (77.48, 24.66): the descent fails on its way.
BOOST_AUTO_TEST_CASE(after_a_failure_the_factor_between_floors_grows_slowly) {
  const Problem problem = barus_problem(77.48, 24.66, TruncatedAt{-4});
  const Resolution resolution{};
  Meter meter = generous();
  const auto top = resolved(problem, coarse_top(problem, 0.0425, 1e-1, 0.0425), resolution, limits, meter);
  BOOST_REQUIRE(top.has_value());
  const auto floors = descent(problem, *top, resolution, limits, meter);
  bool has_failed = false;
  int slow = 0;
  double before = 1;  // ln of the factor, of the step before
  for (std::size_t i = 1; i < floors.size() && floors[i].floor > 0; ++i) {
    const double factor = std::log(floors[i - 1].floor / floors[i].floor);
    if (has_failed) {
      BOOST_TEST(factor <= 1.25 * before * (1 + 1e-9), i);
      ++slow;
    }
    const double expected = i == 1 ? std::log(10) : before + std::log(10);
    has_failed = has_failed || factor < 0.9 * expected;
    before = factor;
  }
  BOOST_TEST(has_failed);
  BOOST_TEST(slow > 2);
}

BOOST_AUTO_TEST_CASE(a_finer_resolution_is_nearer_to_the_truth_by_what_it_allows) {
  const Problem problem = roelands_problem(20, 10, TruncatedAt{-4});
  const Resolved fine = physics(problem, 0.0856, 15, 1e-10), start = physics(problem, 0.0856, 8, 1e-2, 1e-2);
  Meter meter = generous();
  int rows = 0, last = 0;
  for (const double film : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const Resolution resolution{.film = film, .spike = 1e-2, .defect = 1e-1};
    const auto there = resolved(problem, start, resolution, limits, meter);
    BOOST_REQUIRE(there.has_value());
    BOOST_TEST_CONTEXT("film " << film) {
      const double missed = error(flux(*there), flux(fine));
      BOOST_TEST_MESSAGE(film << " asked, " << missed << " missed, " << there->equations->intervals() << " intervals");
      EHD_CHECK(missed, Tolerance::discretisation(film, there->equations->mesh().elements()));
      EHD_CHECK(there->excess, Tolerance::required(1, "homotopy.hpp"));
      BOOST_TEST(there->equations->intervals() >= last);
    }
    last = there->equations->intervals();
    ++rows;
  }
  BOOST_TEST(rows == 4);
}

BOOST_AUTO_TEST_CASE(excess_is_large_where_a_mesh_sees_too_little) {
  // The fine solution put on a coarse mesh and solved there: some element exceeds, and none of the fine mesh does.
  const Problem problem = roelands_problem(20, 10, TruncatedAt{-4});
  const Resolution resolution{.film = 1e-9, .spike = 1e-3, .defect = 1e-2};
  const Resolved fine = physics(problem, 0.0856, 12, 1e-9);
  const auto within_bounds = excess_of(*fine.equations, fine.run, problem, resolution);
  EHD_CHECK(*std::max_element(within_bounds.begin(), within_bounds.end()), Tolerance::required(1, "homotopy.hpp"));
  Resolved coarse = moved_to(problem, fine, mesh_about(-4, 1.09, 0.0856, 8), Points::left_radau);
  coarse.run = solved_at(coarse, 1e-2);
  BOOST_REQUIRE(coarse.run.solved);
  const auto excess = excess_of(*coarse.equations, coarse.run, problem, resolution);
  BOOST_TEST(*std::max_element(excess.begin(), excess.end()) > 100);
  // A resolution that is ten times looser gives an excess that is ten times smaller.
  const auto looser = excess_of(*coarse.equations, coarse.run, problem, {.film = 1e-8, .spike = 1e-2, .defect = 1e-1});
  for (std::size_t e = 0; e < excess.size(); ++e) EHD_CHECK(error(10 * looser[e], excess[e]), Tolerance::round_off(4));
}

BOOST_AUTO_TEST_CASE(the_flux_is_linear_in_a_small_floor_so_that_the_gap_says_what_is_left) {
  struct Row {
    Problem problem;
    double film, floor;  ///< the largest of those fitted
  };
  // Floors that add 1e-3 and less of the fluidity e^(-alpha P) at the maximum.
  const std::vector<Row> table = {{roelands_problem(5, 5, TruncatedAt{-4}), 0.3, 1e-5},
                                  {roelands_problem(20, 10, TruncatedAt{-4}), 0.0856, 1e-7},
                                  {barus_problem(5, 5, Flooded{}), 0.33, 1e-5}};
  int rows = 0;
  for (const Row& row : table) {
    const Resolved end = physics(row.problem, row.film, 10, 1e-7);
    std::vector<double> left;
    std::vector<Resolved> floors;
    for (int k = 0; k < 5; ++k) {
      Resolved at = end;
      at.floor = std::ldexp(row.floor, -k);
      at.run = solved_at(end, at.floor);
      BOOST_REQUIRE(at.run.solved);
      left.push_back(error(flux(at), flux(end)));
      floors.push_back(std::move(at));
    }
    BOOST_TEST_CONTEXT("M = " << row.problem.groups.M << ", L = " << row.problem.groups.L) {
      const double order = fitted_order(left);
      const double gap = floor_gap(floors);
      BOOST_TEST_MESSAGE("order " << order << ", left " << left.front() << " ... " << left.back() << ", gap " << gap);
      EHD_CHECK(std::abs(order - 1), Tolerance::asymptotic(0.02, "second order of the floor"));
      BOOST_REQUIRE(floors_apart(floors).size() > 1);
      BOOST_TEST(floors_apart(floors)[1] == 2U);  // the lowest at thrice the last: at four times
      // Truth: the solution at floor 0 of the same mesh. floor_safety of high_order.cpp allows a fifth.
      EHD_CHECK(error(gap, left.back()), Tolerance::required(0.2, "high_order.cpp: floor_safety"));
      EHD_CHECK(error(gap, left.back()), Tolerance::asymptotic(0.02, "second order of the floor"));
    }
    ++rows;
  }
  BOOST_TEST(rows == 3);
}

BOOST_AUTO_TEST_CASE(the_gap_is_taken_from_floors_at_least_thrice_apart) {
  // flux = 0.7 (1 + 30 delta).
  const auto at = [](double floor) { return floor_with(floor, 0.7 * (1 + 30 * floor)); };
  const std::vector<Resolved> floors = {at(1e-2), at(1e-3), at(1.1e-4), at(4e-5), at(3.5e-5)};
  BOOST_TEST(floors_apart(floors) == (std::vector<std::size_t>{4, 2, 1, 0}), boost::test_tools::per_element());
  EHD_CHECK(error(floor_gap(floors), 30 * 3.5e-5 / (1 + 30 * 1.1e-4)), Tolerance::round_off(10, 1 / (30 * 7.5e-5)));
  BOOST_TEST(floors_apart({at(1e-2), at(1e-3)}) == (std::vector<std::size_t>{1, 0}), boost::test_tools::per_element());
  BOOST_TEST(floors_apart({at(1e-2), at(5e-3)}).size() == 1U);
  BOOST_TEST(floors_apart({at(1e-2)}).size() == 1U);
  BOOST_TEST(floor_gap({at(1e-2), at(5e-3)}) == std::numeric_limits<double>::infinity());
  BOOST_TEST(floor_gap({at(1e-2)}) == std::numeric_limits<double>::infinity());
  BOOST_TEST(floor_gap({at(1e-2), at(0)}) == 0);
}

BOOST_AUTO_TEST_CASE(a_state_moved_to_another_mesh_keeps_its_film_and_is_not_called_solved) {
  const Problem problem = roelands_problem(20, 10, TruncatedAt{-4});
  const Resolved end = physics(problem, 0.0856, 12, 1e-9);
  int rows = 0;
  for (const Points points : {Points::left_radau, Points::gauss}) {
    const Mesh mesh = with_degree(shifted(end.equations->mesh(), 0.37), 16);
    Resolved from = end;
    from.floor = 1e-3;
    const Resolved moved = moved_to(problem, from, mesh, points);
    BOOST_TEST(moved.floor == 1e-3);
    BOOST_TEST(!moved.run.solved);
    BOOST_TEST((moved.equations->points() == points));
    BOOST_TEST(moved.equations->mesh().breakpoints == mesh.breakpoints);
    BOOST_TEST(moved.equations->mesh().degrees == mesh.degrees);
    BOOST_TEST(moved.run.state.flux == flux(end));
    BOOST_TEST(moved.run.state.exit == end.run.state.exit);
    // Films of the polynomial of degree 12 and of its interpolant, at the rows of the finer mesh.
    const auto before = end.equations->evaluate(end.run.state, 0),
               after = moved.equations->evaluate(moved.run.state, 0);
    EHD_CHECK(error(after.load_integral, before.load_integral), Tolerance::discretisation(1e-9, 2));
    EHD_CHECK(error(after.H.minCoeff(), before.H.minCoeff()), Tolerance::discretisation(1e-4, 1));  // minima at rows
    // And solved there, the physics is the same.
    const NewtonRun run = solved_at(moved, 0);
    BOOST_REQUIRE(run.solved);
    BOOST_TEST_MESSAGE((points == Points::gauss ? "gauss" : "left Radau")
                       << " apart " << error(run.state.flux, flux(end)));
    EHD_CHECK(error(run.state.flux, flux(end)), Tolerance::discretisation(1e-9, end.equations->mesh().elements()));
    ++rows;
  }
  BOOST_TEST(rows == 2);
}

BOOST_AUTO_TEST_CASE(limits_end_the_adaption_and_the_descent) {
  const Problem problem = roelands_problem(20, 10, TruncatedAt{-4});
  const Resolved top = coarse_top(problem, 0.0856, 1e-2, 0.0856);
  {
    // At most 200 intervals are allowed: the best such mesh is returned and says that it resolves too little.
    Meter meter = generous();
    HomotopyLimits few = limits;
    few.largest_intervals = 200;
    BOOST_REQUIRE(top.equations->intervals() <= 200);
    const auto best = resolved(problem, top, {.film = 1e-10, .spike = 1e-6, .defect = 1e-3}, few, meter);
    BOOST_REQUIRE(best.has_value());
    BOOST_TEST(best->equations->intervals() <= 200);
    BOOST_TEST(best->excess > 1);
    BOOST_TEST(best->run.solved);
  }
  {
    Meter meter = generous();
    HomotopyLimits long_ones = limits;
    long_ones.shortest_element = 0.02;
    const auto best = resolved(problem, top, {.film = 1e-9, .spike = 1e-5, .defect = 1e-2}, long_ones, meter);
    BOOST_REQUIRE(best.has_value());
    const auto& b = best->equations->mesh().breakpoints;
    const auto& first = top.equations->mesh().breakpoints;
    double shortest = 1, shortest_before = 1;
    for (std::size_t e = 0; e + 1 < b.size(); ++e) shortest = std::min(shortest, b[e + 1] - b[e]);
    for (std::size_t e = 0; e + 1 < first.size(); ++e)
      shortest_before = std::min(shortest_before, first[e + 1] - first[e]);
    BOOST_TEST(shortest >= std::min(0.02, shortest_before));
  }
  {
    Meter meter = generous();
    meter.iterations_left = 0;
    BOOST_TEST(!resolved(problem, top, Resolution{}, limits, meter).has_value());
    const auto floors = descent(problem, top, Resolution{}, limits, meter);
    BOOST_REQUIRE_EQUAL(floors.size(), 1);
    BOOST_TEST(floors.back().floor == 1e-2);
    BOOST_TEST(meter.iterations == 0);
  }
}

BOOST_AUTO_TEST_CASE(what_newtons_method_gives_up_on_is_no_solution) {
  const Problem problem = barus_problem(5000, 30, Flooded{});
  const double film = 1e-3;
  Resolved guess{.equations = std::make_shared<const Collocation<double>>(problem, mesh_about(-800, 1.01, film, 6),
                                                                          Points::left_radau),
                 .run = {},
                 .floor = 0};
  guess.run.state = hertz_start(*guess.equations, 1.01, film);
  Meter meter = generous();
  BOOST_TEST(!resolved(problem, guess, Resolution{}, limits, meter).has_value());
  BOOST_TEST(meter.iterations > 0);
}

BOOST_AUTO_TEST_SUITE_END()
