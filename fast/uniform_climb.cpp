// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/uniform_climb.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/observables.hpp"
#include "fast/judgement.hpp"
#include "fast/prolongation.hpp"
#include "fast/uniform.hpp"
#include "fast/uniform_start.hpp"

namespace ehd::fast {

namespace {

/// The first grid with a tolerance, and the least that a given number of intervals is halved to.
constexpr int first_nodes = 64, fewest_halved = 32;
/// Iteration also stops at this share of the discretisation error expected of the grid, if that is larger.
constexpr double discretisation_share = 0.5;
/// On the coarser grids of a given one the share is larger: they only supply a start.
constexpr double share_on_the_way = 2.5;
/// The error to expect of the next grid: the difference of the last two over this number (second order: the last grid's
/// error is a third of the difference, the next one's a quarter of that); before two grids, the calibrated error over
/// this.
constexpr double difference_over_next = 12, calibrated_over_next = 10;

class Climber {
 public:
  Climber(Run& run, const Request& request)
      : run_(run),
        request_(request),
        expected_(run.lengths),
        first_exit_(first_exit(likely_shape(run.lengths.film), run.lengths.film)) {}

  UniformClimb operator()() {
    const GridPlan plan = plan_of_grids();
    for (std::optional<int> n = plan.first; n; n = plan.after(*n)) {
      const Target target = target_on(*n, plan.last);
      const long newton_before = run_.counters.newton;
      const Attempt attempt = run_.has_state ? warm_start(*n, target) : first_solution(*n, target);
      if (attempt.succeeded) {
        note(*n, attempt.newton, target, newton_before);
        if (!request_.nodes && request_.tolerance.met_by(climb_.film_minimum, climb_.film_central)) break;
      } else if (run_.limit_reached) {
        break;
      } else if (run_.has_state) {
        climb_.refused = *n;
        break;
      }
    }
    climb_.cells = climb_.grids.empty() ? cells(plan.last, first_exit_) : climb_.grids.back().inlet_cells;
    return std::move(climb_);
  }

 private:
  [[nodiscard]] double cells(int n, double exit) const { return run_.lengths.inlet * n / (exit - run_.setting.inlet); }

  /// The first grid is the coarsest that sees the inlet zone. A given number of intervals is halved down to it: a lone
  /// grid would have no error but the calibrated one.
  [[nodiscard]] GridPlan plan_of_grids() const {
    const auto seen = [&](int n) { return cells(n, first_exit_) >= fewest_inlet_cells; };
    if (request_.nodes) {
      return GridPlan::down_from(*request_.nodes, [&](int n) {
        const int half = (n + 1) / 2;
        return half >= fewest_halved && seen(half);
      });
    }
    int n = first_nodes;
    while (n < Uniform::largest_nodes && !seen(n)) n *= 2;
    return GridPlan::doubling(n, Uniform::largest_nodes);
  }

  /// With a tolerance every grid may be the last.
  [[nodiscard]] Target target_on(int n, int last) const {
    const double share = !request_.nodes ? discretisation_share
                         : n < last      ? share_on_the_way
                                         : request_.iteration_share.value_or(0);
    Target target{.film_error = share * expected_error(n)};
    if (request_.nodes) {
      target.residual = round_off_residual;
    } else {
      target.residual = request_.tolerance.tightest() * iteration_share;
      target.flux_variation = request_.tolerance.tightest();
    }
    return target;
  }

  /// The smaller of the discretisation errors to expect of H_min and H_cen on this grid.
  [[nodiscard]] double expected_error(int n) const {
    const auto& grids = climb_.grids;
    if (grids.size() < 2)
      return error_of_inlet_cells(cells(n, run_.has_state ? run_.state.exit : first_exit_)) / calibrated_over_next;
    double least = std::numeric_limits<double>::infinity();
    const Observables &before = grids[grids.size() - 2].observed, &last = grids.back().observed;
    for (const Quantity film : judged_films) {
      if (!before.contains(film) || !last.contains(film)) continue;
      least = std::min(least, std::abs(1 - before.at(film).value / last.at(film).value) / difference_over_next);
    }
    return std::isfinite(least) ? least : 0;
  }

  Attempt first_solution(int n, const Target& target) {
    Attempt attempt = cold_start(run_, grid_of(run_, n), target);
    if (!attempt.succeeded && !run_.limit_reached) attempt = continuation(run_, n, target);
    return attempt;
  }

  /// Newton from the solution of the grid before.
  Attempt warm_start(int n, const Target& target) {
    State state = interpolate_to(run_.state, n);
    Attempt attempt = newton_on(run_, state, target);
    if (!attempt.succeeded) {
      state = interpolate_to(run_.state, n);
      attempt = lower_floor(run_, state, target);
    }
    if (attempt.succeeded) run_.state = std::move(state);
    return attempt;
  }

  /// The solution of a grid, with what is known of its errors.
  void note(int n, const NewtonResult& newton, const Target& target, long newton_before) {
    run_.has_state = true;
    climb_.iteration = std::max(newton.residual, request_.nodes ? 0 : target.residual);
    if (newton.end == NewtonEnd::converged && newton.film_error <= target.film_error)
      climb_.iteration = target.film_error;
    if (!climb_.grids.empty()) climb_.beside = {pressure_alone(climb_.fields)};
    climb_.fields = fields_of(run_);
    GridRecord grid{.nodes = n,
                    .newton_iterations = static_cast<int>(run_.counters.newton - newton_before),
                    .residual = newton.residual,
                    .observed = observe(climb_.fields, run_.observed)};
    const double central = grid.observed.contains(Quantity::film_central)
                               ? grid.observed.at(Quantity::film_central).value
                               : expected_.film;
    run_.lengths.inlet = std::min(expected_.inlet, lengths_from_film(central).inlet);
    grid.inlet_cells = cells(n, run_.state.exit);
    // Numbers of a grid that cannot see the inlet zone say nothing about the next one's error.
    auto& grids = climb_.grids;
    if (!grids.empty() && grids.back().inlet_cells < fewest_inlet_cells) grids.clear();
    grids.push_back(std::move(grid));
    climb_.film_minimum = error_budget(climb_, Quantity::film_minimum, run_.truncation);
    climb_.film_central = error_budget(climb_, Quantity::film_central, run_.truncation);
  }

  Run& run_;
  const Request& request_;
  const Lengths expected_;   ///< before any solution
  const double first_exit_;  ///< X* before any solution
  UniformClimb climb_;
};

}  // namespace

UniformClimb climb_uniform(Run& run, const Request& request) { return Climber(run, request)(); }

}  // namespace ehd::fast
