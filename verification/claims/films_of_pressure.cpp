// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/films_of_pressure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "contact/text.hpp"
#include "reference/hp/collocation.hpp"
#include "verification/claims/shared.hpp"
#include "verification/exact/numerics.hpp"
#include "verification/studies/box.hpp"
#include "verification/studies/fits.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace hp = reference::hp;
using namespace schemes;
using std::numbers::pi;

namespace {

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

/// Equal cells integrate straight lines exactly, so that their film has order 2. On mapped cells the trapezoid rule
/// leaves an error like h^2 ln h at an end where the pressure has a corner. This pressure has one; physical pressures
/// end smoothly.
Findings judge_film(const Named& scheme) {
  const bool mapped = scheme.kind == Kind::fast_mapped;
  std::vector<double> x, y;
  double last = nothing;
  for (const int intervals : {96, 144, 216, 324}) {
    const Problem problem = problem_at({any_M, 0}, false, TruncatedAt{inlet});
    const Array X = at_rest(scheme.kind, rigid_problem([](double) { return 1.0; }), intervals, film_exit).X;
    const Scheme at = evaluated(scheme.kind, problem, film_exit, X.unaryExpr(&given_pressure), film_offset);
    double worst = at.X.size() == intervals + 1 ? 0 : nothing;
    for (Eigen::Index i = 0; i < at.X.size(); ++i)
      worst = worse(worst, std::abs(at.H[i] - film_by_quadrature(at.X[i])));
    last = worst;
    x.push_back(-std::log(intervals));
    y.push_back(std::log(worst / (mapped ? std::log(intervals) : 1)));
  }
  const std::string solver = scheme.solver;
  return {{order_claim({.id = "elasticity/" + solver + "/film",
                        .rung = 3,
                        .statement = solver + " finds the film of a given pressure at every node, like h^2" +
                                     (mapped ? " ln h" : ""),
                        .solver = solver},
                       slope(x, y), 2,
                       Tolerance::calibrated(0.2, "orders of a largest error, over four grids, are read to a fifth"),
                       fmt::format("96 to 324 cells, error {} on the last", scientific(last, 2)))},
          {}};
}

Findings judge_collocation_film() {
  hp::Mesh mesh{
      .inlet = inlet, .breakpoints = {inlet - film_exit, -2.1, -1.4, -0.9, -0.3, 0}, .degrees = {3, 4, 6, 5, 2}};
  const hp::Collocation<double> equations(problem_at({any_M, 0}, false, TruncatedAt{inlet}), mesh,
                                          hp::Points::left_radau);
  const Array X = equations.node_coordinates(film_exit);
  const hp::State<double> state{
      .P = X.unaryExpr(&given_pressure).matrix(), .offset = film_offset, .flux = 1, .exit = film_exit};
  const auto at = equations.evaluate(state, 0);
  double worst = 0;
  for (Eigen::Index i = 0; i < at.X.size(); ++i) worst = worse(worst, std::abs(at.H[i] - film_by_quadrature(at.X[i])));
  return {{claim({.id = "elasticity/collocation/film",
                  .rung = 3,
                  .statement = "polynomial elements find the film of a parabolic pressure to rounding",
                  .solver = certified_solver().name},
                 worst, 0, Tolerance::discretisation(1e-13, 10), "quadrature is granted 1e-13")},
          {}};
}

}  // namespace ehd::verification
