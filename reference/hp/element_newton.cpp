// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hp/element_newton.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/hertz.hpp"
#include "contact/lu_factors.hpp"

namespace ehd::reference::hp {

namespace {

using std::numbers::pi;

/// A step leaves at least this part of the film at every row.
constexpr double smallest_film_left = 0.2;
/// A step moves the exit by no more than this part of X* + 0.2 ...
constexpr double largest_exit_move = 0.1;
/// ... and the pressure by no more than this part of its maximum.
constexpr double largest_pressure_change = 0.5;
constexpr int halvings = 10;
/// A step may make the residual larger by up to this factor. Near the root of a stiff exponential the first full step
/// often does.
constexpr double residual_growth = 4;
/// Added to X* where its move is judged, so that an exit near 0 can move.
constexpr double exit_at_rest = 0.2;
/// The largest pressure counts as at least this where a step is judged.
constexpr double least_pressure = 1e-3;
/// Newton is done where a step moves the pressure by no more than this, or than the step that the limits allow.
constexpr double pressure_at_rest = 1e-5;
/// Keeps quotients of films and moves finite.
constexpr double smallest_divisor = 1e-300;
/// Two domains whose stretchings differ by less are cut from one another and share their xi.
constexpr double same_stretching = 1e-13;
/// Iterations here for one that a request allows.
constexpr long iterations_per_request = 10;
/// Longer limits do not fit into the clock's numbers.
constexpr double longest_time_s = 1e8;

State<double> moved(const State<double>& state, const VectorOf<double>& change, double step) {
  const auto n = change.size() - 3;
  State<double> next = state;
  next.P.head(n) += step * change.head(n);
  next.offset += step * change[n];
  next.flux += step * change[n + 1];
  next.exit += step * change[n + 2];
  return next;
}

double scaled(const Evaluation<double>& at) { return (at.residual.array() / at.scale.array()).abs().maxCoeff(); }

/// The largest step in (0, 1] that moves pressure and exit by no more than the safeguards allow.
double allowed_step(const State<double>& state, const VectorOf<double>& change, double pressure_change) {
  const auto n = change.size() - 3;
  double step = 1;
  const double pressure = std::max(state.P.cwiseAbs().maxCoeff(), least_pressure);
  step = std::min(step, largest_pressure_change * pressure / pressure_change);
  return std::min(step, largest_exit_move * (state.exit + exit_at_rest) / std::abs(change[n + 2]));
}

}  // namespace

Meter meter_of(int max_iterations, double time_limit_s, std::chrono::steady_clock::time_point begin) {
  const std::chrono::duration<double> limit(std::min(time_limit_s, longest_time_s));
  return {.iterations_left = max_iterations * iterations_per_request,
          .end = begin + std::chrono::duration_cast<std::chrono::steady_clock::duration>(limit)};
}

NewtonRun newton(const Collocation<double>& equations, const State<double>& start, double floor,
                 const NewtonLimits& limits, Meter& meter) {
  const int n = equations.intervals();
  const auto evaluate = [&](const State<double>& state) {
    ++meter.kernel_products;
    meter.point_products += n;
    auto at = equations.evaluate(state, floor);
    meter.viscosity_points += at.P.size();
    meter.density_points += at.P.size();
    return at;
  };
  NewtonRun run{.solved = false, .state = start, .at = evaluate(start)};
  if (!(run.at.H.minCoeff() > 0)) return run;
  run.residual = scaled(run.at);
  double last_move = 1, smallest_residual = run.residual;
  int smallest_at = 0;  // iterations done then
  while (run.iterations < limits.iterations && !meter.spent()) {
    MatrixOf<double> J = equations.jacobian(run.state, run.at);
    const VectorOf<double> rows = run.at.scale.cwiseInverse();
    J = rows.asDiagonal() * J;
    ++meter.kernel_products;
    meter.point_products += n;
    ++meter.iterations;
    --meter.iterations_left;
    ++run.iterations;
    const VectorOf<double> change = LuFactors(std::move(J)).solve(-rows.cwiseProduct(run.at.residual));
    if (!change.allFinite()) return run;

    const double pressure_change = change.head(n).cwiseAbs().maxCoeff();
    double step = allowed_step(run.state, change, pressure_change);
    bool accepted = false;
    for (int k = 0; k <= halvings; ++k, step /= 2) {
      State<double> next = moved(run.state, change, step);
      if (!(next.exit > 0)) continue;
      auto at = evaluate(next);
      const double residual = scaled(at);
      const bool film_stays = ((at.H - smallest_film_left * run.at.H) >= 0).all();
      if (!film_stays || !(residual <= residual_growth * run.residual)) continue;
      run.state = std::move(next);
      run.at = std::move(at);
      run.residual = residual;
      accepted = true;
      break;
    }
    if (!accepted) return run;
    const double film = std::max(std::abs(run.state.flux), smallest_divisor);
    const double move = step * std::max({std::abs(change[n + 1]) / film, std::abs(change[n]) / film,
                                         std::abs(change[n + 2]) / (1 + run.state.exit)});
    const bool full = step == 1;
    run.iteration_error = move * std::min(1.0, move / std::max(last_move, smallest_divisor));
    last_move = move;
    if (full && move <= limits.step && pressure_change <= std::max(pressure_at_rest, limits.step)) {
      run.solved = run.state.flux > 0;
      return run;
    }
    if (run.residual < smallest_residual) {
      smallest_residual = run.residual;
      smallest_at = run.iterations;
    }
    if (run.iterations - smallest_at >= limits.patience) return run;
  }
  return run;
}

namespace {

/// Scaled to the load, with the offset that makes the smallest film `film`.
State<double> completed(const Collocation<double>& equations, State<double> start, double film) {
  start.P[0] = 0;
  start.P[start.P.size() - 1] = 0;
  const auto at = equations.evaluate(start, 0);
  start.P *= pi / 2 / (equations.stretching(start.exit) * at.load_integral);
  const auto again = equations.evaluate(start, 0);
  start.offset = film - again.H.minCoeff();
  start.flux = film;
  return start;
}

}  // namespace

State<double> hertz_start(const Collocation<double>& equations, double exit, double film) {
  State<double> start{.P = {}, .exit = exit};
  start.P = hertz::pressure(equations.node_coordinates(exit)).matrix();
  return completed(equations, std::move(start), film);
}

State<double> martin_start(const Collocation<double>& equations, double exit, double film) {
  State<double> start{.P = {}, .exit = exit};
  const Array X = equations.node_coordinates(exit);
  const Eigen::Index n = X.size() - 1;
  const Array gap = film + X.square() / 2;
  const Array slope = (gap - gap[n]) / gap.cube();
  start.P = VectorOf<double>::Zero(n + 1);
  for (Eigen::Index i = n - 1; i > 0; --i)
    start.P[i] = std::max(0.0, start.P[i + 1] - (slope[i] + slope[i + 1]) / 2 * (X[i + 1] - X[i]));
  return completed(equations, std::move(start), film);
}

State<double> transferred(const Collocation<double>& from, const State<double>& state, const Collocation<double>& to) {
  State<double> next = state;
  const auto places = to.node_places();
  next.P.resize(static_cast<Eigen::Index>(places.size()));
  const auto& old = from.mesh().breakpoints;
  const auto& fresh = to.mesh().breakpoints;
  // The two domains differ in extent at most. So places are compared in X, at the state's own exit.
  double ratio = to.stretching(state.exit) / from.stretching(state.exit);
  if (std::abs(ratio - 1) < same_stretching) ratio = 1;  // domains cut from one another share their xi
  std::size_t e = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& place = places[i];
    const auto own = static_cast<std::size_t>(place.element);
    const double half = to.half_length(place.element);
    const double x = ratio * to.xi(place);
    while (e + 2 < old.size() && old[e + 1] <= x) ++e;
    // Distances from breakpoints, so that elements far shorter than their distance to the exit keep their digits.
    const double from_left = ratio == 1 ? (fresh[own] - old[e]) + half * place.from_left : x - old[e];
    const double t = std::clamp(from_left / from.half_length(static_cast<int>(e)) - 1, -1.0, 1.0);
    next.P[static_cast<Eigen::Index>(i)] = from.interpolate(state.P, static_cast<int>(e), t);
  }
  next.P[next.P.size() - 1] = 0;
  return next;
}

}  // namespace ehd::reference::hp
