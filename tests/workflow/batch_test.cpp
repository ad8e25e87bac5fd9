// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/batch.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "contact/nondimensional.hpp"
#include "tests/check.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

std::vector<Problem> some_problems() {
  std::vector<Problem> problems;
  const Lubricant roelands{.viscosity = ViscosityLaw::roelands,
                           .density = DensityLaw::dowson_higginson,
                           .alpha_per_Pa = 2.2e-8,
                           .z = 0.68,
                           .p0_Pa = 1.96e8};
  for (const double M : {2.0, 7.0, 20.0, 60.0, 150.0}) {
    for (const double L : {3.0, 6.5, 9.0, 12.0}) {
      problems.push_back(nondimensionalise(MoesGroups{M, L}, roelands, TruncatedAt{-4}).problem);
      problems.push_back(nondimensionalise(MoesGroups{M, L}, Lubricant{}, Flooded{}).problem);
    }
  }
  return problems;
}

Solution made_solution() {
  Solution solution;
  solution.fields.X = Array::LinSpaced(4, -3, 1);
  solution.fields.P = Array::LinSpaced(4, 0, 0.7);
  solution.fields.offset = -0.4;
  solution.observables[Quantity::film_minimum] = {.value = 0.07, .place = 0.9, .error = 1e-3};
  solution.record.cost.wall_s = 2;
  solution.record.grids.push_back({.nodes = 3, .residual = 1e-9, .observed = {}});
  return solution;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(batch)

BOOST_AUTO_TEST_CASE(results_are_the_same_bit_for_bit_with_any_number_of_threads) {
  const auto problems = some_problems();
  BOOST_TEST(problems.size() == 40u);
  for (const char* name : {"fast", "fast.uniform"}) {
    const auto& solver = *find_solver(name);
    const auto alone = solve_all(solver, problems, {.tolerance = 1e-2}, 1);
    for (const unsigned threads : {2u, 3u}) {
      const auto together = solve_all(solver, problems, {.tolerance = 1e-2}, threads);
      BOOST_REQUIRE(together.size() == problems.size());
      for (std::size_t i = 0; i < problems.size(); ++i)
        BOOST_CHECK_MESSAGE(identical(alone[i], together[i]),
                            name << ", problem " << i << ", " << threads << " threads");
    }
    std::size_t converged = 0;
    for (const auto& one : alone) converged += one.record.status == StopReason::converged ? 1 : 0;
    BOOST_TEST(converged == problems.size());  // else nothing much was compared
  }
}

BOOST_AUTO_TEST_CASE(solutions_stand_in_the_order_of_the_problems) {
  RegisteredSolver telling = *find_solver("fast");
  telling.solve = [](const Problem& problem, const Request&) {
    Solution solution;
    solution.fields.offset = problem.groups.M;
    return solution;
  };
  const auto problems = some_problems();
  const auto solutions = solve_all(telling, problems, {}, 3);
  for (std::size_t i = 0; i < problems.size(); ++i) BOOST_TEST(solutions[i].fields.offset == problems[i].groups.M);
}

BOOST_AUTO_TEST_CASE(what_a_solver_throws_reaches_the_caller) {
  RegisteredSolver throwing = *find_solver("fast");
  throwing.solve = [](const Problem&, const Request&) -> Solution { throw std::logic_error("ours"); };
  BOOST_CHECK_THROW((void)solve_all(throwing, some_problems(), {}, 2), std::logic_error);
}

BOOST_AUTO_TEST_CASE(a_single_bit_makes_two_solutions_differ_and_a_time_does_not) {
  const Solution one = made_solution();
  Solution later = one;
  later.record.cost.wall_s = 3;
  later.record.cost.stage_s = {{"film", 1.0}};
  BOOST_TEST(identical(one, later));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::function<void(Solution&)> changes[] = {
      [](Solution& s) { s.fields.P[2] = std::nextafter(s.fields.P[2], infinity); },
      [](Solution& s) { s.fields.P[0] = -0.0; },
      [](Solution& s) { s.fields.X.conservativeResize(3); },
      [](Solution& s) { s.fields.offset = std::nextafter(s.fields.offset, infinity); },
      [](Solution& s) {
        s.fields.elements = {0, 3};
      },
      [](Solution& s) { s.fields.weights = Array::Ones(1); },
      [](Solution& s) { s.fields.H = Array::Ones(1); },
      [](Solution& s) { s.fields.density = Array::Ones(1); },
      [](Solution& s) { s.fields.log_viscosity = Array::Ones(1); },
      [](Solution& s) { s.fields.flux = Array::Ones(1); },
      [](Solution& s) { s.fields.load_beyond_inlet = 1e-9; },
      [](Solution& s) { s.fields.work_beyond_inlet = 1e-9; },
      [](Solution& s) { s.observables[Quantity::film_minimum].error.reset(); },
      [](Solution& s) { *s.observables[Quantity::film_minimum].place *= 2; },
      [](Solution& s) { s.observables[Quantity::approach] = {}; },
      [](Solution& s) { s.record.status = StopReason::converged; },
      [](Solution& s) { s.record.cost.convolutions = 1; },
      [](Solution& s) { s.record.grids[0].residual = 2e-9; },
      [](Solution& s) { s.record.film_central.truncation = 1e-9; },
  };
  for (const auto& change : changes) {
    Solution other = one;
    change(other);
    BOOST_TEST(!identical(one, other));
  }
  Solution not_a_number = one;
  not_a_number.fields.H = Array::Constant(2, std::numeric_limits<double>::quiet_NaN());
  BOOST_TEST(identical(not_a_number, not_a_number));
}

BOOST_AUTO_TEST_SUITE_END()
