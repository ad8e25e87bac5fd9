// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 2: rounding. The collocation equations of one adapted mesh, solved in double, in long double and with
// 34 digits: the differences are double's rounding and nothing else.
#include <Eigen/LU>

#include "reference/hp/collocation.ipp"
#include "tests/check.hpp"
#include "tests/quad.hpp"
#include "tests/reference/hp/meshes.hpp"
#include "tests/reference/hp/solved.hpp"
#include "tests/reference/problems.hpp"

namespace {

using namespace ehd;
using namespace ehd::reference::hp;
using namespace ehd::testing;
using verification::Tolerance;

/// The state that solves the same equations in Scalar: chord steps with the Jacobian of the state in double. Residuals
/// decide what is solved; each step removes what double's LU knows of the error.
template <class Scalar>
struct Chord {
  State<Scalar> state;
  int steps = 0;
  double contraction = 0;  ///< of the last step but one: above the rounding floor
  double last_step = 0;    ///< relative, of flux, offset and exit, over eps of Scalar
};

template <class Scalar>
Chord<Scalar> chord(const Collocation<Scalar>& equations, const Collocation<double>& in_double,
                    const State<double>& start, double rounding) {
  using std::abs;
  const int n = equations.intervals();
  const auto at = in_double.evaluate(start, 0);
  const VectorOf<double> rows = at.scale.cwiseInverse();
  const Eigen::PartialPivLU<MatrixOf<double>> lu(rows.asDiagonal() * in_double.jacobian(start, at));
  Chord<Scalar> run{.state = in_scalar<Scalar>(start)};
  const double eps = static_cast<double>(std::numeric_limits<Scalar>::epsilon());
  double before = 0;
  for (; run.steps < 40; ++run.steps) {
    const auto here = equations.evaluate(run.state, Scalar(0));
    // A residual of 1e-30 has to reach the solver with digits: divided by its largest entry.
    const Scalar size = here.residual.cwiseAbs().maxCoeff();
    if (size == Scalar(0)) break;
    VectorOf<double> right(n + 3);
    for (int i = 0; i < n + 3; ++i) right[i] = -rows[i] * static_cast<double>(Scalar(here.residual[i] / size));
    const VectorOf<double> change = lu.solve(right);
    for (int i = 0; i < n; ++i) run.state.P[i] += size * Scalar(change[i]);
    run.state.offset += size * Scalar(change[n]);
    run.state.flux += size * Scalar(change[n + 1]);
    run.state.exit += size * Scalar(change[n + 2]);
    const double step = static_cast<double>(size) * change.tail(3).cwiseAbs().maxCoeff() / start.flux;
    run.last_step = step / eps;
    if (run.last_step <= rounding) break;
    if (before > 0) run.contraction = step / before;
    before = step;
  }
  return run;
}

struct Films {
  Quad minimum, central;
};

/// The film's polynomials at X = 0 and where double found the minimum, as observe reads them off the nodes.
template <class Scalar>
Films films(const Collocation<Scalar>& equations, const State<Scalar>& state, double X_of_minimum) {
  const auto& b = equations.mesh().breakpoints;
  const auto all = equations.node_places();
  const auto film = [&](const Scalar& X) {
    const Scalar xi = (X - state.exit) / equations.stretching(state.exit);
    int e = 0;
    while (e + 1 < equations.mesh().elements() && Scalar(b[static_cast<std::size_t>(e) + 1]) < xi) ++e;
    const int first = equations.first_node(e), count = equations.reference(e).degree + 1;
    const std::vector<Place<Scalar>> places(all.begin() + first, all.begin() + first + count);
    VectorOf<Scalar> H = VectorOf<Scalar>::Zero(equations.intervals() + 1);
    H.segment(first, count) = equations.film(state, places, equations.kernel_rows(places)).matrix();
    return Quad(equations.interpolate(
        H, e, (xi - Scalar(b[static_cast<std::size_t>(e)])) / equations.half_length(e) - Scalar(1)));
  };
  return {film(Scalar(X_of_minimum)), film(Scalar(0))};
}

double relative(const Quad& value, const Quad& truth, const Quad& size) {
  return static_cast<double>(abs(value - truth) / abs(size));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hp_precision)

BOOST_AUTO_TEST_CASE(double_keeps_the_digits_of_films_that_its_rounding_leaves) {
  struct Row {
    double M, L, film;
    Inlet inlet;
  };
  const std::vector<Row> table = {{5, 5, 0.3, TruncatedAt{-4}},
                                  {20, 10, 0.0856, TruncatedAt{-4}},
                                  {20, 10, 0.0859, Flooded{}},
                                  {1000, 10, 9.65e-4, Flooded{}}};
  int rows = 0;
  for (const Row& row : table) {
    BOOST_TEST_CONTEXT("M = " << row.M << ", L = " << row.L
                              << (std::holds_alternative<Flooded>(row.inlet) ? ", flooded" : ", X_a = -4")) {
      const Problem problem = roelands_problem(row.M, row.L, row.inlet);
      const Resolved solved = physics(problem, row.film, 12, 1e-9);
      const auto& equations = *solved.equations;
      const State<double>& state = solved.run.state;
      const Collocation<long double> in_long(problem, equations.mesh(), Points::left_radau);
      const Collocation<Quad> in_quad(problem, equations.mesh(), Points::left_radau);
      // rounding_of in reference/high_order.cpp, of which the solver makes its errors: films are differences of terms
      // of size 1 + l^2/2, l = 1, relative to the film.
      const double kappa = 10, size = 1.5 / state.flux;
      const auto rounding = Tolerance::round_off(kappa, size);
      const auto longer = chord<long double>(in_long, equations, state, kappa * size);
      const auto precise = chord<Quad>(in_quad, equations, state, kappa * size);
      BOOST_REQUIRE(longer.last_step <= kappa * size);
      BOOST_REQUIRE(precise.last_step <= kappa * size);
      EHD_CHECK(precise.contraction,
                Tolerance::required(1e-3, "three digits a step: 34 in a dozen of the forty steps"));

      const auto seen = observe(fields_of(problem, solved), want_everything());
      const double X = *seen.at(Quantity::film_minimum).place;
      const Films truth = films(in_quad, precise.state, X), middle = films(in_long, longer.state, X);
      const double minimum = relative(seen.at(Quantity::film_minimum).value, truth.minimum, truth.minimum);
      const double central = relative(seen.at(Quantity::film_central).value, truth.central, truth.central);
      const auto& end = precise.state;
      const double flux = relative(state.flux, end.flux, end.flux);
      const double offset = relative(state.offset, end.offset, end.flux);
      const double exit = relative(state.exit, end.exit, end.exit);
      BOOST_TEST(minimum > 0);  // another arithmetic, not the same one twice
      EHD_CHECK(minimum, rounding);
      EHD_CHECK(central, rounding);
      EHD_CHECK(flux, rounding);
      EHD_CHECK(offset, rounding);
      EHD_CHECK(exit, rounding);
      const double by_long = std::max({relative(middle.minimum, truth.minimum, truth.minimum),
                                       relative(middle.central, truth.central, truth.central),
                                       relative(Quad(longer.state.flux), end.flux, end.flux)});
      EHD_CHECK(by_long / static_cast<double>(std::numeric_limits<long double>::epsilon()) *
                    std::numeric_limits<double>::epsilon(),
                rounding);
      BOOST_TEST_MESSAGE(equations.intervals()
                         << " intervals: H_min " << minimum << ", H_cen " << central << ", flux " << flux << ", H_0 "
                         << offset << ", X* " << exit << " from 34 digits, of " << rounding.value() << "; long double "
                         << by_long << "; contraction " << precise.contraction << ", " << precise.steps << " steps");
    }
    ++rows;
  }
  BOOST_TEST(rows == 4);
}

BOOST_AUTO_TEST_SUITE_END()
