// SPDX-License-Identifier: GPL-3.0-or-later
// The discrete equations, their Jacobian, and what they cost. Films of given pressures are judged by the claims
// elasticity/*.
#include "reference/equations.hpp"

#include <gsl/gsl_integration.h>

#include "reference/map.hpp"
#include "tests/check.hpp"
#include "tests/reference/problems.hpp"

using namespace ehd;
using namespace ehd::reference;
using namespace ehd::testing;
using verification::Tolerance;

namespace {

/// A smooth positive pressure on a grid, no solution of anything.
State smooth_state(const Grid& grid) {
  State state{.P = {}, .offset = 0.9, .exit = 1.13};
  const Array X = grid.nodes(state.exit);
  state.P = 0.8 * (state.exit - X).square() * (-(X + 0.2).square()).exp();
  state.P[0] = state.P[X.size() - 1] = 0;
  return state;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(equations)

BOOST_AUTO_TEST_CASE(logarithmic_mean_is_the_mean_of_the_exponential_between_its_arguments) {
  // (e^-a - e^-b)/(b - a) = Int_0^1 e^-(a + (b-a)t) dt, also where a = b and beside the switch of its two forms.
  gsl_integration_glfixed_table* gauss = gsl_integration_glfixed_table_alloc(64);
  for (const double a : {0.0, 0.4, 12.0}) {
    for (const double d : {0.0, 1e-9, 0.0999999, 0.1, 0.1000001, -0.05, 0.7, -3.0, 20.0}) {
      double value = 0, by_a = 0;
      for (std::size_t k = 0; k < 64; ++k) {
        double t = 0, weight = 0;
        gsl_integration_glfixed_point(0, 1, k, &t, &weight, gauss);
        value += weight * std::exp(-d * t);
        by_a -= weight * (1 - t) * std::exp(-d * t);
      }
      const LogarithmicMean mean = logarithmic_mean(a, a + d);
      BOOST_TEST_CONTEXT("a = " << a << ", b - a = " << d) {
        EHD_CHECK(error(mean.value, value * std::exp(-a)), Tolerance::round_off(100));
        EHD_CHECK(error(mean.by_a, by_a * std::exp(-a)), Tolerance::round_off(100, 10));  // cancels by 1/d near 0.1
        EHD_CHECK(error(mean.by_a + mean.by_b, -mean.value), Tolerance::round_off(100, 10));
      }
    }
  }
  gsl_integration_glfixed_table_free(gauss);
}

BOOST_AUTO_TEST_CASE(logarithmic_mean_underflows_without_harm) {
  const LogarithmicMean mean = logarithmic_mean(846, 900);
  BOOST_TEST(mean.value == 0);
  BOOST_TEST(std::isfinite(mean.by_a));
  BOOST_TEST(std::isfinite(mean.by_b));
}

BOOST_AUTO_TEST_CASE(jacobian_is_the_derivative_of_the_residual) {
  const Sources sources{.film = [](double X) { return std::pair(0.07 * X * X * X, 0.21 * X * X); },
                        .balance = [](double X) { return std::pair(0.05 * X * X + 0.02, 0.1 * X); },
                        .load = 0.013};
  for (const bool sourced : {false, true})
    for (const Grid& grid : {uniform_grid(-3.3, 24), first_map(-3.3, 0.1).grid(40)}) {
      Problem problem = distinct_problem(7, 6, TruncatedAt{-3.3});
      if (sourced) problem.sources = std::make_shared<const Sources>(sources);
      const Equations equations(problem, grid);
      const State state = smooth_state(grid);
      const Eigen::MatrixXd J = equations.jacobian(state, equations.evaluate(state));
      const Eigen::Index n = grid.intervals();
      const auto moved = [&](Eigen::Index j, double step) -> Array {
        State at = state;
        (j < n - 1 ? at.P[j + 1] : j == n - 1 ? at.offset : at.exit) += step;
        return equations.evaluate(at).residual;
      };
      // Differences of order 4, each row by its largest entry: with 1e-3 the truncation is 4e-7, so with a tenth of it
      // 4e-11; rounding is a few eps/step = 2e-12.
      const double step = 1e-4;
      const Eigen::VectorXd row_size = J.cwiseAbs().rowwise().maxCoeff();
      double worst = 0;
      for (Eigen::Index j = 0; j <= n; ++j) {
        const Array difference =
            (8 * (moved(j, step) - moved(j, -step)) - (moved(j, 2 * step) - moved(j, -2 * step))) / (12 * step);
        worst = std::max(worst, ((difference - J.col(j).array()).abs() / row_size.array()).maxCoeff());
      }
      EHD_CHECK(worst,
                Tolerance::calibrated(
                    1e-9, "4e-11 of truncation by scaling with step^4, and rounding; a lost term is 1e-3 and more"));
    }
}

BOOST_AUTO_TEST_CASE(wedge_of_a_quadratic_film_is_off_by_the_curvature_of_the_slope_alone) {
  // At P = 0 the flux is -rho H with rho H = H_0 + X^2/2. k = 0 takes the slope over both neighbours: it is that of
  // node i exactly on equal cells, and the face value misses (h/2)^2/2 of the parabola.
  const Grid grid = uniform_grid(-4, 32);
  const Equations equations(barus_problem(20, 10, TruncatedAt{-4}), grid);
  const State state{.P = Array::Zero(33), .offset = 0.3, .exit = 1.2};
  const Evaluation at = equations.evaluate(state);
  const double h = 5.2 / 32;
  for (Eigen::Index i = 1; i < 32; ++i) {
    const double face = at.X[i] + h / 2;
    EHD_CHECK(error(at.wedge[i], 0.3 + face * face / 2 - h * h / 8), Tolerance::round_off(20));
  }
  EHD_CHECK(error(at.wedge[0], (at.H[0] + at.H[1]) / 2), Tolerance::round_off(4));
}

BOOST_AUTO_TEST_CASE(film_does_not_know_where_its_grid_begins) {
  // The same pressure on a grid that begins elsewhere: the length in K and ln(length) must cancel.
  const Problem problem = barus_problem(20, 10, TruncatedAt{-4});
  const Equations narrow(problem, uniform_grid(-2, 64)), wide(problem, uniform_grid(-6, 128));
  Array P = Array::Zero(65), Q = Array::Zero(129);
  P.segment(20, 30) = Array::LinSpaced(30, 0.2, 0.9);
  Q.tail(65) = P;
  const Array near = narrow.film_without_offset(P, 2), far = wide.film_without_offset(Q, 2);
  EHD_CHECK((near - far.tail(65)).abs().maxCoeff(), Tolerance::round_off(129, 10));
}

BOOST_AUTO_TEST_CASE(trivial_laws_are_not_evaluated) {
  const Grid grid = uniform_grid(-4, 16);
  const auto evaluated = [&](const Problem& problem) { return Equations(problem, grid).evaluate(smooth_state(grid)); };
  const Evaluation isoviscous = evaluated(barus_problem(10, 0, TruncatedAt{-4}));
  BOOST_TEST(isoviscous.viscosity_points == 0);
  BOOST_TEST(isoviscous.density_points == 0);
  const Evaluation barus = evaluated(barus_problem(10, 5, TruncatedAt{-4}));
  BOOST_TEST(barus.viscosity_points == 17);
  BOOST_TEST(barus.density_points == 0);
  const Evaluation roelands = evaluated(roelands_problem(10, 5, TruncatedAt{-4}));
  BOOST_TEST(roelands.viscosity_points == 17);
  BOOST_TEST(roelands.density_points == 17);
}

BOOST_AUTO_TEST_SUITE_END()
