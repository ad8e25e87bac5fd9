// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/films_of_pressure.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "reference/hp/collocation.hpp"
#include "verification/exact/numerics.hpp"
#include "verification/studies/box.hpp"
#include "verification/studies/fits.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace hp = reference::hp;
using namespace schemes;
using std::numbers::pi;

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double film_exit = 0.9, film_offset = 2.3;

/// A parabola, which lines follow to second order and polynomials to rounding.
double given_pressure(double X) { return 0.31 * (X - inlet) * (film_exit - X); }

/// H_0 + X^2/2 - (1/pi) Int P ln|X - X'| dX' by quadrature.
double film_by_quadrature(double X) {
  const auto part = [X](double from, double to) {
    constexpr double nothing_there = 1e-13;  // an end node that is not its end to the last digit: P is 0 there
    return to - from > nothing_there
               ? exact::integral([X](double s) { return given_pressure(s) * std::log(std::abs(X - s)); }, from, to)
               : 0.0;
  };
  return film_offset + X * X / 2 - (part(inlet, X) + part(X, film_exit)) / pi;
}

}  // namespace

/// Exact for lines, the rule of equal cells is of order 2. The trapezoid rule of mapped cells leaves h^2 ln h where the
/// pressure ends in a corner, at that end, as this one does; physical pressures end smoothly.
Findings judge_film(const Named& scheme) {
  const bool mapped = scheme.kind == Kind::fast_mapped;
  std::vector<double> x, y;
  double last = nothing;
  for (const int intervals : {96, 144, 216, 324}) {
    const Problem problem = problem_at({M, 0}, false, TruncatedAt{inlet});
    const Scheme at = evaluated(
        scheme.kind, problem, film_exit,
        at_rest(scheme.kind, rigid_problem([](double) { return 1.0; }), intervals, film_exit).X.unaryExpr([](double X) {
          return given_pressure(X);
        }),
        film_offset);
    double worst = at.X.size() == intervals + 1 ? 0 : nothing;
    for (Eigen::Index i = 0; i < at.X.size(); ++i)
      worst = worse(worst, std::abs(at.H[i] - film_by_quadrature(at.X[i])));
    last = worst;
    x.push_back(-std::log(intervals));
    y.push_back(std::log(worst / (mapped ? std::log(intervals) : 1)));
  }
  Findings found;
  found.claims.push_back(order_claim(
      {.id = "elasticity/" + std::string(scheme.id) + "/film",
       .rung = 3,
       .statement = std::string(scheme.id) + " finds the film of a given pressure at every node, like h^2" +
                    (mapped ? " ln h" : ""),
       .solver = scheme.solver},
      slope(x, y), 2, Tolerance::calibrated(0.2, "orders of a largest error, over four grids, are read to a fifth"),
      "96 to 324 cells, error " + three_digits(last) + " on the last"));
  return found;
}

Findings judge_collocation_film() {
  hp::Mesh mesh{
      .inlet = inlet, .breakpoints = {inlet - film_exit, -2.1, -1.4, -0.9, -0.3, 0}, .degrees = {3, 4, 6, 5, 2}};
  const hp::Collocation<double> equations(problem_at({M, 0}, false, TruncatedAt{inlet}), mesh, hp::Points::left_radau);
  const Array X = equations.node_coordinates(film_exit);
  const hp::State<double> state{.P = X.unaryExpr([](double place) { return given_pressure(place); }).matrix(),
                                .offset = film_offset,
                                .flux = 1,
                                .exit = film_exit};
  const auto at = equations.evaluate(state, 0);
  double worst = 0;
  for (Eigen::Index i = 0; i < at.X.size(); ++i) worst = worse(worst, std::abs(at.H[i] - film_by_quadrature(at.X[i])));
  Findings found;
  found.claims.push_back(claim({.id = "elasticity/collocation/film",
                                .rung = 3,
                                .statement = "polynomial elements find the film of a parabolic pressure to rounding",
                                .solver = "reference"},
                               worst, 0, Tolerance::discretisation(1e-13, 10), "quadrature is granted 1e-13"));
  return found;
}

}  // namespace ehd::verification
