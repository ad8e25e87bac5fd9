// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/grid_newton.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/hertz.hpp"
#include "contact/lu_factors.hpp"
#include "contact/observables.hpp"

namespace ehd::reference {

namespace {

using Eigen::Index;
using std::numbers::pi;

// Residuals below this, relative to H_n, count as solved.
constexpr double small_residual = 1e-12;
// Safeguards of a step; calibrated on 104 points M 0.5..5000, L 0..30 in an earlier prototype, where half and twice
// each value worked as well.
constexpr double largest_pressure_step = 0.5;  // of the largest pressure
constexpr double largest_exit_step = 0.05;     // of X* + 0.2
constexpr double smallest_film_left = 0.2;     // of the film before the step
constexpr int halvings = 8;
constexpr double exit_at_rest = 0.2;         // added to X*, so that an exit near 0 can move
constexpr double least_decrease = 0.1;       // of the merit, for a full step
constexpr double negative_pressure = 1e-10;  // over the largest pressure: rounding, not a negative root
constexpr double rounding_units = 4;         // what is solved, over what rounding does to a residual
constexpr double film_at_rest = 1e-11;       // relative; a film that moves less has reached its rounding
// A start that is interpolated gets a new H_0 where interpolation left less of the smallest film, or moved the central
// film by more, relative.
constexpr double smallest_film_kept = 0.5, largest_central_move = 0.3;
// X* of the parabolic gap H_c + X^2/2 with Reynolds' exit, over sqrt(2 H_c).
constexpr double martin_exit = 0.4751299200930562;
constexpr int most_iterations = 50;  // a start that needs more is a bad one; 30 is the most that succeeded

/// Root mean square of the flux residuals, with the load's residual. Each flux is relative to its wedge, so that the
/// far inlet, where the wedge is large, weighs no more than the contact.
double merit(const Evaluation& at) {
  const Index n = at.wedge.size();
  return std::sqrt((at.residual.head(n) / (at.wedge.abs() + at.H[n])).square().mean() +
                   at.residual[n] * at.residual[n]);
}

/// Largest residual over the one at which an equation counts as solved.
double distance_to_floor(const Evaluation& at) {
  const Index n = at.wedge.size();
  return std::max(
      (at.residual.head(n).abs() / (small_residual * at.H[n] + rounding_units * at.rounding.head(n))).maxCoeff(),
      std::abs(at.residual[n]) / (small_residual + rounding_units * at.rounding[n]));
}

/// P >= 0 up to rounding, H > 0, and the film opens where the pressure ends.
bool is_solution(const State& state, const Evaluation& at) {
  const Index n = at.wedge.size();
  return state.P.minCoeff() >= -negative_pressure * state.P.maxCoeff() && at.H.minCoeff() > 0 && at.H[n] > at.H[n - 1];
}

/// Largest step in (0, 1] that the safeguards on P and X* allow.
double allowed_step(const State& state, const Eigen::VectorXd& change) {
  const Index n = change.size() - 1;
  const double pressure = change.head(n - 1).cwiseAbs().maxCoeff();
  const double exit = std::abs(change[n]);
  double step = 1;
  if (pressure > 0) step = std::min(step, largest_pressure_step * state.P.maxCoeff() / pressure);
  if (exit > 0) step = std::min(step, largest_exit_step * (state.exit + exit_at_rest) / exit);
  return step;
}

State moved(const State& state, const Eigen::VectorXd& change, double step) {
  const Index n = change.size() - 1;
  State next = state;
  next.P.segment(1, n - 1) += step * change.head(n - 1).array();
  next.offset += step * change[n - 1];
  next.exit += step * change[n];
  return next;
}

}  // namespace

double local_cubic(const Array& nodes, const Array& values, double x) {
  const Index right = std::lower_bound(nodes.begin(), nodes.end(), x) - nodes.begin();
  const Index first = std::clamp<Index>(right - 2, 0, nodes.size() - 4);
  return interpolate(nodes.segment(first, 4), values.segment(first, 4), x);
}

NewtonResult newton(const Equations& equations, const State& start, const Budget& budget) {
  NewtonResult run;
  run.state = start;
  const auto evaluate = [&](const State& state) {
    Evaluation at = equations.evaluate(state);
    ++run.kernel_products;
    run.viscosity_points += at.viscosity_points;
    run.density_points += at.density_points;
    return at;
  };

  run.at = evaluate(run.state);
  run.residuals.push_back(run.at.relative_residual());
  double film_change = 1;
  for (Budget left = budget; !left.spent(); --left.newton_iterations) {
    if (distance_to_floor(run.at) <= 1) {
      if (is_solution(run.state, run.at)) run.end = NewtonEnd::solved;
      return run;
    }
    Eigen::MatrixXd J = equations.jacobian(run.state, run.at);
    ++run.kernel_products;
    ++run.iterations;
    const Eigen::VectorXd change = LuFactors(std::move(J)).solve(-run.at.residual.matrix());
    if (!change.allFinite()) return run;

    const double before = merit(run.at);
    double step = allowed_step(run.state, change);
    for (int k = 0;; ++k, step /= 2) {
      const State next = moved(run.state, change, step);
      Evaluation at = evaluate(next);
      const bool film_stays = (at.H - smallest_film_left * run.at.H).minCoeff() >= 0 && next.exit > 0;
      const bool better = merit(at) <= (1 - least_decrease * step) * before || distance_to_floor(at) <= 1;
      if (!(film_stays && better) && k < halvings) continue;
      if (!film_stays || !std::isfinite(merit(at))) return run;
      film_change = ((at.H - run.at.H) / at.H).abs().maxCoeff();
      run.state = next;
      run.at = std::move(at);
      break;
    }
    run.residuals.push_back(run.at.relative_residual());
    run.iteration_error = film_change * std::min(1.0, merit(run.at) / before);
    // At the floor the residual no longer falls and the film no longer moves: the rest is rounding.
    if (film_change < film_at_rest && is_solution(run.state, run.at)) {
      run.end = NewtonEnd::solved;
      return run;
    }
    if (run.iterations >= most_iterations) return run;
  }
  run.end = NewtonEnd::limit_reached;
  return run;
}

State hertz_start(const Equations& equations, double central_film, double exit) {
  const Array X = equations.grid().nodes(exit);
  State start{.P = hertz::pressure(X), .exit = exit};
  const Index n = X.size() - 1;
  start.P[0] = start.P[n] = 0;
  start.P *= pi / 2 / (exit - equations.grid().inlet) / (hat_integrals(equations.grid().fractions) * start.P).sum();
  // The gap of a coarse grid is flat to its own accuracy only: only its lowest point must stay above the surface.
  start.offset = central_film - equations.film_without_offset(start.P, exit).minCoeff();
  return start;
}

State martin_start(const Equations& equations, double central_film) {
  const double exit = martin_exit * std::sqrt(2 * central_film);
  const Array X = equations.grid().nodes(exit);
  const Index n = X.size() - 1;
  const Array gap = central_film + X.square() / 2;
  const Array slope = (gap - gap[n]) / gap.cube();
  State start{.P = Array::Zero(n + 1), .exit = exit};
  for (Index i = n - 1; i > 0; --i)  // from the exit, where P = 0, against the flow
    start.P[i] = std::max(0.0, start.P[i + 1] - (slope[i] + slope[i + 1]) / 2 * (X[i + 1] - X[i]));
  start.P *= pi / 2 / (exit - equations.grid().inlet) / (hat_integrals(equations.grid().fractions) * start.P).sum();
  start.offset = central_film - local_cubic(X, equations.film_without_offset(start.P, exit), 0);
  return start;
}

State interpolated_start(const Equations& equations, const State& solved, const Evaluation& at) {
  const Array X = equations.grid().nodes(solved.exit);
  const Index n = X.size() - 1;
  State start{.P = Array::Zero(n + 1), .offset = solved.offset, .exit = solved.exit};
  for (Index i = 1; i < n; ++i) start.P[i] = std::max(0.0, local_cubic(at.X, solved.P, X[i]));
  const double central = local_cubic(at.X, at.H, 0);
  const Array film = start.offset + equations.film_without_offset(start.P, start.exit);
  const double moved_to = local_cubic(X, film, 0);
  if (film.minCoeff() < smallest_film_kept * at.H.minCoeff() ||
      std::abs(moved_to - central) > largest_central_move * central)
    start.offset += central - moved_to;
  return start;
}

}  // namespace ehd::reference
