// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace ehd::fast {

using Clock = std::chrono::steady_clock;

namespace {

/// Newton steps on one grid, at most.
constexpr int most_newton_steps = 60;
/// Pressures down to this (times p_H) count as >= 0.
constexpr double lowest_pressure = -1e-3;
/// The floor under the fluidity: the first one, the factor to the next one, and below which value it becomes 0.
constexpr double first_floor = 1e-2, floor_factor = 0.1, lowest_floor = 1e-16;
/// A factor that fails is replaced by its root; above this one there is no point in going on.
constexpr double weakest_floor_factor = 0.7;
/// With a floor, Newton only makes a start for the next floor.
constexpr double residual_with_floor = 1e-5;
/// No clock runs longer than this [s].
constexpr double longest_time_s = 1e6;

/// P >= 0 and a film that opens at the exit.
bool admissible(const NodeFields& at, const State& state) {
  const int n = at.n;
  return state.P.minCoeff() >= lowest_pressure &&
         at.density.value[n] * at.H[n] >= at.density.value[n - 1] * at.H[n - 1];
}

bool succeeded(const NewtonResult& result, const Run& run, const State& state) {
  return (result.end == NewtonEnd::converged || result.end == NewtonEnd::stalled) &&
         admissible(run.workspace.now().nodes, state);
}

/// The weights of the sum that gives the load, l Int P dphi.
Array weights_of(const NodeFields& at) {
  Array weights = at.length / at.n * at.grid->slope;
  weights[0] /= 2;
  weights[at.n] /= 2;
  return weights;
}

}  // namespace

Run begin_run(const Problem& problem, const Request& request, Workspace& workspace, const FloodedInlet& far) {
  const auto begin = Clock::now();
  const std::chrono::duration<double> allowed(std::min(request.time_limit_s, longest_time_s));
  const Lengths lengths = expected_lengths(problem.groups);
  const auto* const cut = std::get_if<TruncatedAt>(&problem.inlet);
  // Setting is named: g++ 12 destroys what stands in braces without a type twice if a later member throws.
  Run run{.problem = problem,
          .setting = Setting{.groups = problem.groups,
                             .viscosity = problem.viscosity,
                             .density = problem.density,
                             .inlet = cut ? cut->x : -far.reach * lengths.scale,
                             .with_tail = !cut,
                             .sources = problem.sources},
          .workspace = workspace,
          .limits = {.newton_iterations = request.max_iterations,
                     .deadline = begin + std::chrono::duration_cast<Clock::duration>(allowed)},
          .lengths = lengths,
          .observed = problem.wanted,
          .truncation = cut ? 0 : far.truncation,
          .begin = begin,
          .planning_before = workspace.grids.planning_s()};
  // A spike may be the pressure maximum, and the error of the smallest film depends on whether there is one.
  run.observed.insert({Quantity::film_minimum, Quantity::film_central, Quantity::pressure_spike});
  return run;
}

Grid& grid_of(Run& run, int intervals) {
  const InStage stage(run.counters, Stage::grids);
  return run.workspace.grids.of(intervals);
}

Attempt newton_on(Run& run, State& state, const Target& target) {
  const NewtonResult result =
      newton(run.setting, state, target, most_newton_steps, run.limits, run.workspace, run.counters);
  if (result.end == NewtonEnd::limit) run.limit_reached = true;
  return {.succeeded = succeeded(result, run, state), .newton = result};
}

Attempt cold_start(Run& run, Grid& grid, const Target& target) {
  const double film = run.lengths.film;
  const Shape likely = likely_shape(film), other = likely == Shape::hertz ? Shape::martin : Shape::hertz;
  const std::pair<Shape, double> starts[] = {{likely, 1.0}, {likely, 2.0}, {likely, 0.5},
                                             {likely, 4.0}, {other, 1.0},  {other, 2.0}};
  Attempt attempt;
  for (const auto& [shape, factor] : starts) {
    State state = first_iterate(run.setting, shape, factor * film, grid);
    attempt = newton_on(run, state, target);
    if (attempt.succeeded) run.state = std::move(state);
    if (attempt.succeeded || run.limit_reached) break;
  }
  return attempt;
}

Attempt lower_floor(Run& run, State& state, const Target& target) {
  const Setting setting = run.setting;
  State reached = state;
  double floor = first_floor, factor = floor_factor;
  bool any = false;
  Attempt attempt;
  while (!run.limit_reached) {
    const bool last = floor < lowest_floor;
    run.setting.fluidity_floor = last ? 0 : floor;
    State trial = reached;
    attempt = newton_on(run, trial, last ? target : Target{.residual = residual_with_floor});
    if (attempt.succeeded) {
      reached = trial;
      any = true;
      if (last) break;
      floor *= factor;
    } else {
      if (!any || factor > weakest_floor_factor) break;
      floor /= factor;
      factor = std::sqrt(factor);
      floor *= factor;
    }
  }
  attempt.succeeded = attempt.succeeded && run.setting.fluidity_floor == 0;
  run.setting = setting;
  if (attempt.succeeded) state = reached;
  return attempt;
}

GridPlan GridPlan::down_from(int nodes, const std::function<bool(int)>& halve) {
  GridPlan plan{.given = {nodes}, .first = nodes, .last = nodes};
  while (halve(plan.first)) {
    plan.first = (plan.first + 1) / 2;
    plan.given.insert(plan.given.begin(), plan.first);
  }
  return plan;
}

std::optional<int> GridPlan::after(int n) const {
  if (n >= last) return std::nullopt;
  if (given.empty()) return 2 * n;
  return *std::upper_bound(given.begin(), given.end(), n);
}

Fields fields_of(const Run& run) {
  const NodeFields& at = run.workspace.now().nodes;
  return {.X = at.places(run.setting.inlet),
          .P = run.state.P,
          .H = at.H,
          .density = at.density.value,
          .log_viscosity = at.log_viscosity.value,
          .flux = run.workspace.now().faces.flux,
          .offset = run.state.offset,
          .weights = run.workspace.grids.map() ? weights_of(at) : Array(),
          .load_beyond_inlet = run.state.tail.load,
          .work_beyond_inlet = run.state.tail.work};
}

void fill_cost(SolveRecord& record, Run& run) {
  const Workspace& workspace = run.workspace;
  Cost& cost = record.cost;
  cost.nodes = record.grids.empty() ? 0 : record.grids.back().nodes;
  cost.levels = static_cast<int>(record.grids.size());
  run.counters.clock.change_to(Stage::other);
  cost.planning_s = workspace.grids.planning_s() - run.planning_before;
  cost.convolutions = run.counters.convolutions;
  cost.work_units = cost.nodes > 0 ? run.counters.convolution_points / cost.nodes : 0;
  cost.newton_iterations = run.counters.newton;
  cost.krylov_iterations = run.counters.krylov;
  cost.viscosity_points = run.counters.viscosity_points;
  cost.density_points = run.counters.density_points;
  // Planned now or by an earlier solve: the count does not depend on what came before.
  cost.fft_plans = static_cast<long>(run.counters.product_grids.size());
  for (std::size_t k = 0; k < std::size(stage_names); ++k) {
    const auto stage = static_cast<Stage>(k);
    // FFTW plans when a grid is first used, and wall_s is without planning.
    const double planning = stage == Stage::grids ? cost.planning_s : 0;
    cost.stage_s.emplace_back(stage_names[k], std::max(0.0, run.counters.clock.seconds(stage) - planning));
  }
  cost.wall_s = std::chrono::duration<double>(Clock::now() - run.begin).count() - cost.planning_s;
}

}  // namespace ehd::fast
