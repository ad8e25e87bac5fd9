// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/run.hpp"

#include <algorithm>
#include <cmath>

namespace ehd::fast {

using Clock = std::chrono::steady_clock;

namespace {

/// P >= 0 and a film that opens at the exit: the conditions that tracking the exit leaves to be checked.
bool admissible(const NodeFields& at, const State& state) {
  const int n = at.n;
  return state.P.minCoeff() >= -1e-3 && at.density.value[n] * at.H[n] >= at.density.value[n - 1] * at.H[n - 1];
}

}  // namespace

Limits limits_of(const Request& request, Clock::time_point begin) {
  return {.newton_iterations = request.max_iterations,
          .deadline = begin + std::chrono::duration_cast<Clock::duration>(
                                  std::chrono::duration<double>(std::min(request.time_limit_s, 1e6)))};
}

NewtonResult newton_on(Run& run, State& state, const Target& target) {
  const NewtonResult result = newton(run.setting, state, target, 60, run.limits, run.workspace, run.counters);
  if (result.end == NewtonEnd::limit) run.limit_reached = true;
  return result;
}

bool succeeded(const NewtonResult& result, const Run& run, const State& state) {
  return (result.end == NewtonEnd::converged || result.end == NewtonEnd::stalled) &&
         admissible(run.workspace.now().nodes, state);
}

bool lower_floor(Run& run, State& state, const Target& target, NewtonResult& result) {
  const Setting setting = run.setting;
  State reached = state;
  double floor = 1e-2, factor = 0.1;
  bool any = false;
  while (!run.limit_reached) {
    const bool last = floor < 1e-16;
    run.setting.fluidity_floor = last ? 0 : floor;
    State trial = reached;
    result = newton_on(run, trial, last ? target : Target{.residual = 1e-5});
    if (succeeded(result, run, trial)) {
      reached = trial;
      any = true;
      if (last) break;
      floor *= factor;
    } else {
      if (!any || factor > 0.7) break;
      floor /= factor;
      factor = std::sqrt(factor);
      floor *= factor;
    }
  }
  const bool success = run.setting.fluidity_floor == 0 && any && succeeded(result, run, reached);
  run.setting = setting;
  if (success) state = reached;
  return success;
}

namespace {

/// Of the load's own sum, l Int P dphi.
Array weights_of(const NodeFields& at) {
  Array weights = at.length / at.n * at.grid->slope;
  weights[0] /= 2;
  weights[at.n] /= 2;
  return weights;
}

}  // namespace

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

bool is_absolute(Quantity quantity) { return quantity == Quantity::film_offset || quantity == Quantity::approach; }

void fill_cost(SolveRecord& record, Run& run, Clock::time_point begin, double planning_before, long plans_before) {
  const Workspace& workspace = run.workspace;
  Cost& cost = record.cost;
  cost.nodes = record.grids.empty() ? 0 : record.grids.back().nodes;
  cost.levels = static_cast<int>(record.grids.size());
  run.counters.clock.change_to(Stage::other);
  cost.planning_s = workspace.grids.planning_s() - planning_before;
  cost.convolutions = run.counters.convolutions;
  cost.work_units = cost.nodes > 0 ? run.counters.convolution_points / cost.nodes : 0;
  cost.newton_iterations = run.counters.newton;
  cost.krylov_iterations = run.counters.krylov;
  cost.viscosity_points = run.counters.viscosity_points;
  cost.density_points = run.counters.density_points;
  cost.fft_plans = workspace.grids.plans() - plans_before;
  for (std::size_t k = 0; k < std::size(stage_names); ++k) {
    const auto stage = static_cast<Stage>(k);
    // FFTW plans when a grid is first used, and wall_s is without planning.
    const double planning = stage == Stage::grids ? cost.planning_s : 0;
    cost.stage_s.emplace_back(stage_names[k], std::max(0.0, run.counters.clock.seconds(stage) - planning));
  }
  cost.wall_s = std::chrono::duration<double>(Clock::now() - begin).count() - cost.planning_s;
}

}  // namespace ehd::fast
