// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 6: Newton reaches the rounding floor, and a state that is no solution is never returned as one. The claim
// iteration/reference.uniform/newton judges that Newton contracts quadratically.
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
