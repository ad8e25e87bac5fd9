// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 6: Newton's method contracts quadratically to round-off, a state that is no solution is never returned as one,
// and a state survives the way to another mesh.
#include "reference/hp/element_newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/check.hpp"
#include "tests/reference/hp/meshes.hpp"
#include "tests/reference/hp/solved.hpp"
#include "tests/reference/problems.hpp"

namespace {

using namespace ehd;
using namespace ehd::reference::hp;
using namespace ehd::testing;
using std::numbers::pi;
using verification::Tolerance;

bool is_finite(const State<double>& state) {
  return state.P.allFinite() && std::isfinite(state.offset) && std::isfinite(state.flux) && std::isfinite(state.exit);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hp_element_newton)

BOOST_AUTO_TEST_CASE(newton_contracts_quadratically_to_round_off) {
  struct Row {
    double M, L, film, floor;
    Inlet inlet;
  };
  // At the start's floor, and in the physics where Newton's method finds it unaided.
  const std::vector<Row> table = {{5, 5, 0.3, 1e-2, TruncatedAt{-4}},
                                  {5, 5, 0.3, 0, TruncatedAt{-4}},
                                  {5, 5, 0.3, 0, Flooded{}},
                                  {20, 10, 0.0856, 1e-2, TruncatedAt{-4}},
                                  {2, 1, 1, 0, Flooded{}}};
  int rows = 0;
  for (const Row& row : table) {
    const bool flooded = std::holds_alternative<Flooded>(row.inlet);
    const double inlet = flooded ? -400 : -4, exit = 1 + 0.45 * std::pow(row.film, 2.0 / 3);
    const Collocation<double> equations(roelands_problem(row.M, row.L, row.inlet),
                                        mesh_about(inlet, exit, row.film, 10), Points::left_radau);
    Meter meter = generous();
    const State<double> start = hertz_start(equations, exit, row.film);
    // At the floor first, as the solver does.
    const NewtonRun easy = ehd::reference::hp::newton(equations, start, 1e-2, {.iterations = 60}, meter);
    BOOST_TEST_CONTEXT("M = " << row.M << ", L = " << row.L << (flooded ? ", flooded" : "") << ", floor "
                              << row.floor) {
      BOOST_REQUIRE(easy.solved);
      const NewtonRun run =
          ehd::reference::hp::newton(equations, easy.state, row.floor, {.iterations = 60, .step = 1e-12}, meter);
      BOOST_REQUIRE(run.solved);
      // Each row is a sum of n products of terms up to 1 + X^2/2 at X = -4, relative to its film.
      EHD_CHECK(run.residual, Tolerance::round_off(equations.intervals(), (1 + 4 * 4 / 2) / row.film));
      EHD_CHECK(run.iteration_error, Tolerance::required(1e-12, "step"));
      // One full step from ever nearer places: what is left falls with the square of the distance.
      std::vector<double> left;
      State<double> away = run.state;
      for (int k = 0; k < 6; ++k) {
        const double part = std::ldexp(1e-3, -k);
        away.P = (1 + part) * run.state.P;
        away.offset = run.state.offset + part * row.film;
        away.exit = (1 + part * row.film) * run.state.exit;
        const NewtonRun one =
            ehd::reference::hp::newton(equations, away, row.floor, {.iterations = 1, .step = 1e-14}, meter);
        left.push_back((one.state.P - run.state.P).cwiseAbs().maxCoeff());
      }
      BOOST_TEST(left.back() > 1e4 * std::numeric_limits<double>::epsilon());
      EHD_CHECK(std::abs(fitted_order(left) - 2), Tolerance::asymptotic(0.1, "cubic terms at distances from 1e-3"));
      double last = 1;
      State<double> state = away;
      for (int k = 0; k < 5; ++k) {
        state = ehd::reference::hp::newton(equations, state, row.floor, {.iterations = 1, .step = 1e-14}, meter).state;
        last = error(state.flux, run.state.flux);
      }
      BOOST_TEST_MESSAGE("order " << fitted_order(left) << ", left " << left.back() << ", residual " << run.residual
                                  << ", flux back to " << last);
      // To round-off, which the flux keeps to kappa eps (1 + l^2/2)/film: reference/high_order.cpp, rounding_of.
      EHD_CHECK(last, Tolerance::round_off(10, 1.5 / row.film));
    }
    ++rows;
  }
  BOOST_TEST(rows == 5);
}

BOOST_AUTO_TEST_CASE(a_run_gives_up_after_its_patience_without_a_new_smallest_residual) {
  // The mesh is too coarse for the steep end of Barus oil: a run of forty iterations finds nothing.
  const double film = 0.09, exit = 1 + 0.45 * std::pow(film, 2.0 / 3);
  const Collocation<double> equations(barus_problem(20, 10, TruncatedAt{-4}), mesh_about(-4, exit, film, 8),
                                      Points::left_radau);
  const State<double> start = hertz_start(equations, exit, film);
  const auto run = [&](int iterations, int patience) {
    Meter meter = generous();
    return ehd::reference::hp::newton(equations, start, 1e-2,
                                      {.iterations = iterations, .patience = patience, .step = 1e-10}, meter);
  };
  BOOST_TEST(run(40, 40).iterations == 40);
  const NewtonRun ended = run(40, 5);
  BOOST_TEST(!ended.solved);
  BOOST_REQUIRE(ended.iterations < 40);
  double smallest = std::numeric_limits<double>::infinity();
  int smallest_at = 0;
  for (int k = 0; k <= ended.iterations; ++k) {
    const double residual = run(k, 40).residual;
    if (residual < smallest) smallest_at = k;
    smallest = std::min(smallest, residual);
  }
  BOOST_TEST(ended.iterations - smallest_at == 5);
}

BOOST_AUTO_TEST_CASE(iteration_error_is_not_less_than_what_a_further_step_moves) {
  const Collocation<double> equations(roelands_problem(20, 10, TruncatedAt{-4}), mesh_about(-4, 1.09, 0.0856, 8),
                                      Points::left_radau);
  const State<double> start = hertz_start(equations, 1.09, 0.0856);
  Meter meter = generous();
  const NewtonRun end = ehd::reference::hp::newton(equations, start, 1e-2, {.iterations = 40, .step = 1e-13}, meter);
  BOOST_REQUIRE(end.solved);
  int rows = 0;
  for (int left = 1; left <= 3; ++left) {
    // Stopped before the end, where the convergence is quadratic already.
    const NewtonRun run =
        ehd::reference::hp::newton(equations, start, 1e-2, {.iterations = end.iterations - left, .step = 1e-13}, meter);
    BOOST_TEST_CONTEXT(left << " before the end") {
      const Tolerance bound =
          Tolerance::iteration(run.iteration_error + 10 * std::numeric_limits<double>::epsilon() / 0.0856);
      EHD_CHECK(error(run.state.flux, end.state.flux), bound);
    }
    ++rows;
  }
  BOOST_TEST(rows == 3);
}

BOOST_AUTO_TEST_CASE(newton_stops_at_either_limit_and_counts_what_it_spent) {
  const Collocation<double> equations(roelands_problem(20, 10, TruncatedAt{-4}), mesh_about(-4, 1.09, 0.0856, 8),
                                      Points::left_radau);
  const State<double> start = hertz_start(equations, 1.09, 0.0856);
  {
    Meter meter = generous();
    const NewtonRun run = ehd::reference::hp::newton(equations, start, 1e-2, {.iterations = 3}, meter);
    BOOST_TEST(!run.solved);
    BOOST_TEST(run.iterations == 3);
    BOOST_TEST(meter.iterations == 3);
    BOOST_TEST(meter.iterations_left == 4997);
    // A Jacobian and at least one evaluation each, and the first evaluation.
    BOOST_TEST(meter.kernel_products >= 7);
    BOOST_TEST(meter.point_products == static_cast<double>(meter.kernel_products * equations.intervals()));
    BOOST_TEST(meter.viscosity_points > 4 * equations.intervals());
    BOOST_TEST(is_finite(run.state));
  }
  {
    Meter meter = generous();
    meter.iterations_left = 2;
    const NewtonRun run = ehd::reference::hp::newton(equations, start, 1e-2, {}, meter);
    BOOST_TEST(!run.solved);
    BOOST_TEST(run.iterations == 2);
    BOOST_TEST(meter.spent());
  }
  {
    Meter meter = generous();
    meter.end = std::chrono::steady_clock::now();
    const NewtonRun run = ehd::reference::hp::newton(equations, start, 1e-2, {}, meter);
    BOOST_TEST(!run.solved);
    BOOST_TEST(run.iterations == 0);
    BOOST_TEST((run.state.P.array() == start.P.array()).all());
  }
  {
    // The same start is solved where nothing is spoilt.
    Meter meter = generous();
    BOOST_TEST(ehd::reference::hp::newton(equations, start, 1e-2, {}, meter).solved);
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_solution_is_not_called_one) {
  struct Row {
    const char* what;
    Problem problem;
    double film;
    double floor;
    double pressure;  ///< factor on the start's
    double sink;      ///< taken from its offset
  };
  const std::vector<Row> table = {
      {"the film is closed at the start", roelands_problem(20, 10, TruncatedAt{-4}), 0.0856, 1e-2, 1, 0.1},
      {"a viscosity of e^846", barus_problem(5000, 30, Flooded{}), 1e-3, 0, 3, 0},
      {"a fluidity that overflows", barus_problem(5000, 30, TruncatedAt{-4}), 1e-3, 1e-2, -2, 0},
      {"no number at all", roelands_problem(5, 5, TruncatedAt{-4}), 0.3, 1e-2, std::nan(""), 0}};
  int rows = 0;
  for (const Row& row : table) {
    const double inlet = std::holds_alternative<Flooded>(row.problem.inlet) ? -400 : -4;
    const double exit = 1 + 0.45 * std::pow(row.film, 2.0 / 3);
    const Collocation<double> equations(row.problem, mesh_about(inlet, exit, row.film, 6), Points::left_radau);
    State<double> start = hertz_start(equations, exit, row.film);
    start.P *= row.pressure;
    start.offset -= row.sink;
    Meter meter = generous();
    const NewtonRun run = ehd::reference::hp::newton(equations, start, row.floor, {.iterations = 30}, meter);
    BOOST_TEST_CONTEXT(row.what) {
      BOOST_TEST(!run.solved);
      BOOST_TEST(run.iterations <= 30);
      if (std::isfinite(row.pressure)) BOOST_TEST(is_finite(run.state));
    }
    ++rows;
  }
  BOOST_TEST(rows == 4);
}

BOOST_AUTO_TEST_CASE(starts_carry_the_load_and_have_the_film_that_is_asked_for) {
  int rows = 0;
  for (const double film : {0.01, 0.3, 40.0})
    for (const Inlet& inlet : {Inlet{TruncatedAt{-4}}, Inlet{Flooded{}}}) {
      const bool flooded = std::holds_alternative<Flooded>(inlet);
      const double length = std::max(1.0, std::sqrt(2 * film)), exit = length * 1.1;
      const double begin = (flooded ? -800 : -4) * length;
      const Problem problem = film > 1 ? barus_problem(0.05, 0, inlet) : roelands_problem(20, 10, inlet);
      const Collocation<double> equations(problem, mesh_about(begin, exit, film, 8), Points::left_radau);
      const int n = equations.intervals();
      for (const State<double>& start : {hertz_start(equations, exit, film), martin_start(equations, exit, film)}) {
        const auto at = equations.evaluate(start, 0);
        BOOST_TEST_CONTEXT("film " << film << (flooded ? ", flooded" : "")) {
          EHD_CHECK(std::abs(at.residual[n + 1] - 2 / pi * at.tail_load), Tolerance::round_off(n));
          EHD_CHECK(error(at.H.minCoeff(), film), Tolerance::round_off(n, (1 + exit * exit / 2) / film));
          BOOST_TEST(start.P.minCoeff() == 0);
          BOOST_TEST(start.P[0] == 0);
          BOOST_TEST(start.P[n] == 0);
          BOOST_TEST(start.flux == film);
          BOOST_TEST(start.exit == exit);
        }
        ++rows;
      }
    }
  BOOST_TEST(rows == 12);
}

BOOST_AUTO_TEST_CASE(a_polynomial_is_the_same_on_any_mesh_of_its_domain) {
  const Problem problem = distinct_problem(7, 6, TruncatedAt{-3.3});
  const double exit = 1.37;
  const auto pressure = [&](double X) { return 0.03 * (exit - X) * (X + 3.9) * (5.1 - X); };  // least degree: 3
  const Collocation<double> from(problem, mixed_mesh(-3.3), Points::left_radau);
  const State<double> state{
      .P = from.node_coordinates(exit).unaryExpr(pressure).matrix(), .offset = 0.77, .flux = 0.4, .exit = exit};
  Mesh stretched = mixed_mesh(-3.3);  // made when the domain was longer
  for (double& xi : stretched.breakpoints) xi *= 1.13;
  stretched.breakpoints[3] += 0.21;
  const std::vector<Mesh> table = {mixed_mesh(-3.3),
                                   with_degree(mixed_mesh(-3.3), 15),
                                   shifted(mixed_mesh(-3.3), 0.37),
                                   stretched,
                                   cut_at(mixed_mesh(-3.3), -2.9, exit),
                                   cut_at(mixed_mesh(-3.3), -0.4, exit),
                                   adapted(
                                       mixed_mesh(-3.3), std::vector<double>(7, 2.0), [](int) { return false; }, 0)};
  int rows = 0;
  for (const Mesh& mesh : table) {
    const Collocation<double> to(problem, mesh, Points::left_radau);
    const State<double> there = transferred(from, state, to);
    const Array X = to.node_coordinates(exit);
    BOOST_TEST_CONTEXT("mesh " << rows) {
      BOOST_REQUIRE_EQUAL(there.P.size(), to.intervals() + 1);
      // Degree 12 interpolated in Legendre coefficients; places with eps X in elements of half length 0.035.
      EHD_CHECK((there.P.array() - X.unaryExpr(pressure)).abs().maxCoeff(), Tolerance::round_off(100));
      BOOST_TEST(there.P[to.intervals()] == 0);
      BOOST_TEST(there.offset == state.offset);
      BOOST_TEST(there.flux == state.flux);
      BOOST_TEST(there.exit == state.exit);
    }
    ++rows;
  }
  BOOST_TEST(rows == 7);
}

BOOST_AUTO_TEST_CASE(a_rough_state_survives_refinement_exactly) {
  // Cut in halves, with higher degrees: every polynomial is represented, so values anywhere stay.
  const Problem problem = distinct_problem(7, 6, TruncatedAt{-3.3});
  const Collocation<double> from(problem, mixed_mesh(-3.3), Points::left_radau);
  Mesh finer = adapted(
      mixed_mesh(-3.3), std::vector<double>(7, 2.0), [](int) { return false; }, 0);
  for (int& degree : finer.degrees) degree += 2;
  const Collocation<double> to(problem, finer, Points::left_radau);
  State<double> state{.P = VectorOf<double>(from.intervals() + 1), .exit = 1.21};
  for (Eigen::Index i = 0; i < state.P.size(); ++i) state.P[i] = 0.4 + 0.3 * std::sin(1.7 * static_cast<double>(i * i));
  state.P[from.intervals()] = 0;
  const State<double> there = transferred(from, state, to);
  int rows = 0;
  for (int e = 0; e < 7; ++e)
    for (const double t : {-0.93, -0.41, -0.08, 0.27, 0.66, 0.98}) {
      const int half = t < 0 ? 2 * e : 2 * e + 1;
      const double before = from.interpolate(state.P, e, t);
      const double after = to.interpolate(there.P, half, 2 * t + (t < 0 ? 1 : -1));
      // Values up to 10 between rough ones; degree 14, slopes p^2.
      EHD_CHECK(std::abs(after - before), Tolerance::round_off(30, 10 * 14));
      ++rows;
    }
  BOOST_TEST(rows == 42);
}

BOOST_AUTO_TEST_CASE(an_element_at_the_rounding_of_its_place_keeps_its_shape) {
  // Length 2^-44 at xi = -0.5: 2^-44 is 1024 spacings of coordinates there. Pressure 1 + (1 + t)/2 in it.
  const Problem problem = distinct_problem(7, 6, TruncatedAt{-3.3});
  const double h = std::ldexp(1, -44);
  const Mesh mesh{.inlet = -3.3, .breakpoints = {-4.43, -0.5, -0.5 + h, 0}, .degrees = {5, 5, 5}};
  const Collocation<double> from(problem, mesh, Points::left_radau);
  const Collocation<double> to(problem,
                               adapted(
                                   mesh, {0, 2, 0}, [](int) { return false; }, 0),
                               Points::left_radau);
  State<double> state{.P = VectorOf<double>::Zero(16), .exit = 1.13};
  const auto places = from.node_places();
  for (Eigen::Index i = 0; i < 16; ++i) {
    const auto& at = places[static_cast<std::size_t>(i)];
    state.P[i] = at.element == 0 ? 1 : at.element == 1 ? 1 + at.from_left / 2 : at.from_right;
  }
  const State<double> there = transferred(from, state, to);
  BOOST_REQUIRE_EQUAL(there.P.size(), 21);
  const auto fresh = to.node_places();
  for (Eigen::Index i = 5; i < 15; ++i) {
    const auto& at = fresh[static_cast<std::size_t>(i)];
    const double in_half = at.from_left / 2;  // of its half of the element
    EHD_CHECK(std::abs(there.P[i] - (at.element == 1 ? 1 + in_half / 2 : 1.5 + in_half / 2)), Tolerance::round_off(50));
  }
}

BOOST_AUTO_TEST_SUITE_END()
