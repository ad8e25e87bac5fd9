// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 6: Newton contracts quadratically, and a state that is no solution is never returned as one.
#include "reference/grid_newton.hpp"

#include "tests/check.hpp"
#include "tests/reference/problems.hpp"

using namespace ehd;
using namespace ehd::reference;
using namespace ehd::testing;
using verification::Tolerance;

namespace {

Budget generous() {
  return {.newton_iterations = 200, .end = std::chrono::steady_clock::now() + std::chrono::minutes(1)};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(grid_newton)

BOOST_AUTO_TEST_CASE(newton_contracts_quadratically) {
  for (const auto& [M, L] : {std::pair{5.0, 5.0}, {20.0, 10.0}, {100.0, 10.0}}) {
    const Equations equations(roelands_problem(M, L, TruncatedAt{-4}), uniform_grid(-4, 256));
    const double film = 0.4 / M;
    const NewtonResult run = ehd::reference::newton(equations, hertz_start(equations, film * L, 1.1), generous());
    BOOST_REQUIRE(run.end == NewtonEnd::solved);
    // The last three residuals that are below 0.1 and above the rounding floor: r_(k+1) ~ C r_k^2.
    const double floor = 1e3 * run.residuals.back();
    std::vector<double> logs;
    for (const double residual : run.residuals)
      if (residual < 0.1 && residual > floor) logs.push_back(std::log(residual));
    BOOST_TEST_CONTEXT("M = " << M << ", L = " << L << ", " << logs.size() << " residuals") {
      BOOST_REQUIRE_GE(logs.size(), 2);
      const double exponent = logs[logs.size() - 1] / logs[logs.size() - 2];
      BOOST_CHECK_GE(exponent, 1.6);
    }
  }
}

BOOST_AUTO_TEST_CASE(newton_reaches_the_rounding_floor) {
  const Equations equations(roelands_problem(20, 10, TruncatedAt{-4}), uniform_grid(-4, 512));
  const NewtonResult run = ehd::reference::newton(equations, hertz_start(equations, 0.1, 1.1), generous());
  BOOST_REQUIRE(run.end == NewtonEnd::solved);
  EHD_CHECK(run.residuals.back(), Tolerance::required(1e-11, "the twin solvers' agreement to 1e-8"));
  EHD_CHECK(run.iteration_error, Tolerance::required(1e-10, "the twin solvers' agreement to 1e-8"));
}

BOOST_AUTO_TEST_CASE(newton_stops_at_its_limit_of_iterations) {
  const Equations equations(roelands_problem(20, 10, TruncatedAt{-4}), uniform_grid(-4, 64));
  Budget budget = generous();
  budget.newton_iterations = 3;
  const NewtonResult run = ehd::reference::newton(equations, hertz_start(equations, 0.1, 1.1), budget);
  BOOST_TEST((run.end == NewtonEnd::limit_reached));
  BOOST_TEST(run.iterations == 3);
}

BOOST_AUTO_TEST_CASE(starts_carry_the_load_and_a_positive_film) {
  for (const double film : {0.01, 0.3, 40.0}) {
    const double inlet = film > 1 ? -100 : -4;
    const Equations equations(barus_problem(1, 3, TruncatedAt{inlet}), uniform_grid(inlet, 400));
    for (const State& start : {hertz_start(equations, film, 1.2), martin_start(equations, film)}) {
      const Evaluation at = equations.evaluate(start);
      EHD_CHECK(std::abs(at.residual[400]), Tolerance::round_off(400));
      BOOST_TEST(at.X[400] == start.exit);
    }
    BOOST_TEST(equations.evaluate(hertz_start(equations, film, 1.2)).H.minCoeff() > 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
