// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/uniform.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "contact/estimate.hpp"
#include "contact/observables.hpp"
#include "contact/nondimensional.hpp"
#include "fast/run.hpp"

namespace ehd::fast {

using std::numbers::pi;
using Clock = std::chrono::steady_clock;

namespace {

// A uniform grid needs this many cells in the inlet zone before its numbers mean anything. Calibrated at M = 1000,
// L = 10: 0.5 cells 40 % off, 1 cell 12..16 %, 2 cells 2..3 %, 4 cells 1 % (H_min and H_cen).
constexpr double fewest_inlet_cells = 1.5;
/// Covers the calibration above three times over.
double error_of_inlet_cells(double cells) { return 0.5 / (cells * cells); }

// Iteration stops at this share of the tolerance. Film error over the residual stopped at, measured at 96 problems (M
// of 0.5..1000, L of 0..20, both law sets, flooded and -4) and three tolerances: at most 0.24, so the residual covers
// it.
constexpr double iteration_share = 1.0 / 30;
// Or, where that is more, at this share of the discretisation error expected of the grid.
constexpr double discretisation_share = 0.5;
// On the way to a given grid, more: all that is wanted is a start for the next one.
constexpr double share_on_the_way = 2.5;

// No uniform grid sees the spike's width (1e-4 at (20, 10), 2e-11 at (200, 15)), so grids agree on a height before it
// is right. Against the ten-digit heights of six points, flooded and -4, at four tolerances: an estimate below 3 % was
// never too small, one of 9 % up to five times. Estimates are multiplied, and what stays vague is left out.
constexpr double spike_safety = 3, vaguest_spike = 0.05;

constexpr int first_nodes = 64;

/// Where a flooded grid begins, -reach l, and the relative film error that the tail beyond it leaves. Calibrated
/// against reach 24 at eleven points from (0.05, 0) to (1000, 10), both law sets: reach 4 at most 1.2e-6, reach 8 at
/// most 5e-8.
struct FloodedInlet {
  double reach, truncation;
};
/// What truncation does to other numbers than films, in units of that: the work before the domain falls with 1/|X_a|
/// alone, and H_0 holds ln|X_a| of the tail. Against the reference at ten points of M = 0.05..100, both law sets:
/// rolling force at most 4.7e-5 (reach 4), 2.8e-6 (reach 8); offset 1.3e-5, 1.2e-6, with the discretisation in it.
constexpr double truncation_of_work = 20, truncation_of_offset = 5;
FloodedInlet flooded_inlet(double tolerance) {
  return tolerance > 0 && tolerance < 2e-5 ? FloodedInlet{8, 1e-7} : FloodedInlet{4, 3e-6};
}

/// The last resort: from a mild contact (M at most 20, L at most 5) to the one asked for, in steps of one parameter.
bool continuation(Run& run, int n, const Target& wanted, NewtonResult& result) {
  const Setting target = run.setting;
  const double M0 = std::clamp(target.groups.M, 2.0, 20.0), L0 = std::min(target.groups.L, 5.0);
  double reached = -1, step = 1;
  State state;
  const auto at = [&](double t) {
    Setting setting = target;
    setting.groups = groups_from(
        MoesGroups{.M = std::pow(M0, 1 - t) * std::pow(target.groups.M, t), .L = (1 - t) * L0 + t * target.groups.L});
    if (target.groups.alpha_p_H > 0) {
      const double unit = setting.groups.alpha_p_H / target.groups.alpha_p_H;
      setting.viscosity = in_units_of(target.viscosity, unit);
      setting.density = in_units_of(target.density, unit);
    }
    return setting;
  };
  while (reached < 1 && step > 1.0 / 64 && !run.limit_reached) {
    const double t = reached < 0 ? 0 : std::min(1.0, reached + step);
    run.setting = t < 1 ? at(t) : target;
    State trial;
    if (reached < 0) {
      const Lengths mild = expected_lengths(run.setting.groups);
      trial = first_iterate(run.setting, likely_shape(mild.film), mild.film, run.workspace.grids.of(n));
    } else {
      trial = state;
    }
    result = newton_on(run, trial, t < 1 ? Target{.residual = 1e-4} : wanted);
    if (succeeded(result, run, trial)) {
      state = trial;
      reached = t;
      step *= 1.5;
    } else {
      if (reached < 0) break;
      step /= 2;
    }
  }
  run.setting = target;
  if (reached < 1) return false;
  run.state = state;
  return true;
}

/// A solution on n intervals from nothing.
bool start(Run& run, int n, const Target& target, NewtonResult& result) {
  const double film = run.lengths.film;
  const Shape likely = likely_shape(film), other = likely == Shape::hertz ? Shape::martin : Shape::hertz;
  const std::pair<Shape, double> attempts[] = {{likely, 1.0}, {likely, 2.0}, {likely, 0.5},
                                               {likely, 4.0}, {other, 1.0},  {other, 2.0}};
  for (const auto& [shape, factor] : attempts) {
    State state = first_iterate(run.setting, shape, factor * film, run.workspace.grids.of(n));
    result = newton_on(run, state, target);
    if (run.limit_reached) return false;
    if (succeeded(result, run, state)) {
      run.state = state;
      return true;
    }
  }
  return continuation(run, n, target, result);
}

/// Discretisation error of H_min and H_cen, the smaller, to expect of the next grid: of second order, after what the last
/// two differ by; with less than two grids, from the cells in its inlet zone.
double expected_error(const std::vector<GridRecord>& grids, double cells) {
  if (grids.size() < 2) return error_of_inlet_cells(cells) / 10;  // a third of the calibration
  double least = std::numeric_limits<double>::infinity();
  const Observables &before = grids[grids.size() - 2].observed, &last = grids.back().observed;
  for (const Quantity film : {Quantity::film_minimum, Quantity::film_central}) {
    if (!before.contains(film) || !last.contains(film)) continue;
    least = std::min(least, std::abs(1 - before.at(film).value / last.at(film).value) / 12);
  }
  return std::isfinite(least) ? least : 0;
}

/// What the grids say of one quantity; infinite where only one grid has it.
double discretisation_error(const std::vector<GridRecord>& grids, Quantity quantity) {
  std::vector<double> values;
  for (const GridRecord& grid : grids) {
    const auto found = grid.observed.find(quantity);
    if (found == grid.observed.end()) {
      values.clear();
    } else {
      values.push_back(found->second.value);
    }
  }
  if (values.empty()) return std::numeric_limits<double>::infinity();
  const GridEstimate judged = estimate(values, Uniform::description.formal_order);
  return is_absolute(quantity) ? judged.error * std::abs(judged.value) : judged.error;
}

}  // namespace

Solution Uniform::solve(const Problem& problem, const Request& request) const {
  Workspace workspace;
  return solve(problem, request, workspace);
}

Solution Uniform::solve(const Problem& problem, const Request& request, Workspace& workspace) const {
  const auto begin = Clock::now();
  workspace.grids.use(nullptr);
  const double planning_before = workspace.grids.planning_s();
  const long plans_before = workspace.grids.plans();
  const Lengths lengths = expected_lengths(problem.groups);
  const auto* const cut = std::get_if<TruncatedAt>(&problem.inlet);
  const FloodedInlet far = flooded_inlet(request.tolerance.value_or(0));
  Run run{.problem = problem,
          .setting = {.groups = problem.groups,
                      .viscosity = problem.viscosity,
                      .density = problem.density,
                      .inlet = cut ? cut->x : -far.reach * lengths.scale,
                      .with_tail = !cut,
                      .sources = problem.sources},
          .workspace = workspace,
          .limits = limits_of(request, begin),
          .lengths = lengths};
  Wanted wanted = problem.wanted;
  wanted.insert({Quantity::film_minimum, Quantity::film_central});

  // The first grid: the coarsest that sees the inlet zone and, for a given number of intervals, halves down from it, the
  // half of an odd number rounded up. A lone grid would have no error but the calibrated one.
  const double tolerance = request.tolerance.value_or(0);
  int n = request.nodes.value_or(first_nodes);
  std::vector<int> finer;  // those to come after n, the next one last
  const double exit = first_exit(likely_shape(lengths.film), lengths.film);
  if (request.nodes) {
    while ((n + 1) / 2 >= 32 && run.cells((n + 1) / 2, exit) >= fewest_inlet_cells) {
      finer.push_back(n);
      n = (n + 1) / 2;
    }
  } else {
    while (n < largest_nodes && run.cells(n, exit) < fewest_inlet_cells) n *= 2;
  }
  const int last = request.nodes.value_or(largest_nodes);

  Solution solution;
  SolveRecord& record = solution.record;
  double iteration = 0;
  int refused = 0;
  const auto budget = [&](Quantity quantity) {
    return ErrorBudget{
        .discretisation = discretisation_error(record.grids, quantity),
        .iteration = iteration,
        .truncation = cut ? 0 : far.truncation * (quantity == Quantity::rolling_force ? truncation_of_work : 1)};
  };
  for (;;) {
    // With a tolerance every grid may be the last.
    const double share = !request.nodes ? discretisation_share
                         : n < last     ? share_on_the_way
                                        : request.iteration_share.value_or(0);
    const double expected = expected_error(record.grids, run.cells(n, run.has_state ? run.state.exit : exit));
    const Target target{.residual = request.nodes ? 1e-11 : tolerance * iteration_share, .film_error = share * expected};
    NewtonResult result;
    bool solved = false;
    const long newton_before = run.counters.newton;
    if (run.has_state) {
      State state = interpolate_to(run.state, n);
      result = newton_on(run, state, target);
      solved = succeeded(result, run, state);
      if (!solved) {
        state = interpolate_to(run.state, n);
        solved = lower_floor(run, state, target, result);
      }
      if (solved) run.state = std::move(state);
    } else {
      solved = start(run, n, target, result);
    }
    if (solved) {
      run.has_state = true;
      iteration = std::max(result.residual, request.nodes ? 0 : target.residual);
      if (target.film_error > 0 && result.end == NewtonEnd::converged) iteration = std::min(iteration, result.film_error);
      solution.fields = fields_of(run);
      GridRecord grid{.nodes = n,
                      .newton_iterations = static_cast<int>(run.counters.newton - newton_before),
                      .residual = result.residual,
                      .observed = observe(solution.fields, wanted)};
      const double central = grid.observed.contains(Quantity::film_central)
                                 ? grid.observed.at(Quantity::film_central).value
                                 : lengths.film;
      run.lengths.inlet = std::min(lengths.inlet, lengths_from_film(central).inlet);
      grid.inlet_cells = run.cells(n, run.state.exit);
      // Numbers of a grid that cannot see the inlet zone say nothing about the next one's error.
      if (!record.grids.empty() && record.grids.back().inlet_cells < fewest_inlet_cells) record.grids.clear();
      record.grids.push_back(std::move(grid));
      record.film_minimum = budget(Quantity::film_minimum);
      record.film_central = budget(Quantity::film_central);
      if (!request.nodes && record.film_minimum.total() <= tolerance && record.film_central.total() <= tolerance) break;
    } else if (run.limit_reached) {
      break;
    } else if (run.has_state) {
      refused = n;  // a spike that Newton cannot follow further: the grid before is the best there is
      break;
    }
    if (n >= last) break;
    n = request.nodes ? finer.back() : 2 * n;
    if (request.nodes) finer.pop_back();
  }

  // How it ended.
  const bool solved = !record.grids.empty();
  const double cells = solved ? record.grids.back().inlet_cells : run.cells(last, exit);
  if (solved) {
    // One grid, or one that hardly sees the inlet zone: the calibrated error where the grids say less.
    const double least = cells < fewest_inlet_cells || record.grids.size() < 2 ? error_of_inlet_cells(cells) : 0;
    for (ErrorBudget* const film : {&record.film_minimum, &record.film_central}) {
      film->discretisation = std::isfinite(film->discretisation) ? std::max(film->discretisation, least) : least;
    }
    solution.observables = record.grids.back().observed;
    // H_0 is the film at X = 0 less a deflection of order one.
    const double film_scale = solution.observables.contains(Quantity::film_central)
                                  ? solution.observables.at(Quantity::film_central).value
                                  : lengths.film;
    for (auto& [quantity, reading] : solution.observables) {
      if (quantity == Quantity::load_error || quantity == Quantity::flux_variation) continue;
      double error = budget(quantity).total();
      if (quantity == Quantity::film_minimum) error = record.film_minimum.total();
      if (quantity == Quantity::film_central) error = record.film_central.total();
      const auto at_least = [&](double floor) { error = std::isfinite(error) ? std::max(error, floor) : floor; };
      if (least > 0 && quantity == Quantity::film_couette) at_least(least);
      if (least > 0 && is_absolute(quantity)) at_least(least * (1 + film_scale));
      if (!cut && is_absolute(quantity)) error += truncation_of_offset * far.truncation * (1 + film_scale);
      if (std::isfinite(error)) reading.error = error;
    }
    // A spike is reported with its uncertainty or not at all; nor is a pressure maximum that is the spike.
    const auto spike = solution.observables.find(Quantity::pressure_spike);
    if (spike != solution.observables.end()) {
      if (spike->second.error) *spike->second.error *= spike_safety;
      if (!(spike->second.error.value_or(1) < vaguest_spike)) {
        if (problem.wanted.contains(Quantity::pressure_spike))
          record.notes.push_back("pressure.spike is left out: its height is not known to 5 %");
        const auto maximum = solution.observables.find(Quantity::pressure_maximum);
        if (maximum != solution.observables.end() && maximum->second.place == spike->second.place) {
          solution.observables.erase(maximum);
          if (problem.wanted.contains(Quantity::pressure_maximum))
            record.notes.push_back("pressure.maximum is left out: it is the spike");
        }
        solution.observables.erase(spike);
      }
    }
    std::erase_if(solution.observables, [&](const auto& entry) { return !problem.wanted.contains(entry.first); });
  }
  if (run.limit_reached) {
    record.status = StopReason::limit_reached;
    record.reason = "the limit on iterations or time was reached";
  } else if (cells < fewest_inlet_cells) {
    record.status = StopReason::under_resolved;
    record.reason = "the grid has fewer than 1.5 cells in the inlet zone of width H_cen^(2/3)";
  } else if (!solved) {
    record.status = StopReason::diverged;
    record.reason = "Newton found no admissible solution from any start";
  } else if (refused > 0) {
    record.status = StopReason::tolerance_not_met;
    record.reason = "Newton does not converge on " + std::to_string(refused) + " intervals; the values are those of " +
                    std::to_string(record.grids.back().nodes);
  } else if (!request.nodes &&
             !(record.film_minimum.total() <= tolerance && record.film_central.total() <= tolerance)) {
    record.status = StopReason::tolerance_not_met;
    record.reason = "the finest grid's estimated error is above the tolerance";
  } else {
    record.status = StopReason::converged;
  }

  fill_cost(record, run, begin, planning_before, plans_before);
  return solution;
}

}  // namespace ehd::fast
