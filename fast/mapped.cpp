// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/mapped.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/observables.hpp"
#include "fast/run.hpp"

namespace ehd::fast {

using std::numbers::pi;
using Clock = std::chrono::steady_clock;

namespace {

// Iteration stops at this share of the tolerance (see uniform.cpp).
constexpr double iteration_share = 1.0 / 30;
constexpr int first_nodes = 64, map_nodes = 128;
constexpr double reach = 16;  ///< a flooded grid begins at X_a = -reach l

/// A way to begin: the first is right nearly always, the others are retries.
struct Recipe {
  double narrowest;  ///< w_sp >= narrowest d l
  double cells;      ///< w_sp >= this many cells at the spike
  bool robust_wedge;
  int remaps;
  int first;
};
constexpr Recipe recipes[] = {
    {0.02, 0.5, false, 3, 64}, {0.1, 1, false, 3, 64}, {0.1, 1, true, 3, 64}, {0.5, 1, false, 0, 64}, {0.1, 1, true, 3, 128}};

MapShape expected_shape(const Run& run) {
  const Lengths& l = run.lengths;
  const double d = std::pow(std::min(1.0, l.film), 2.0 / 3);
  return {.inlet = run.setting.inlet,
          .exit = l.film > 0.5 ? 0.5 * std::sqrt(2 * l.film) : 1 + 0.45 * d,
          .scale = l.scale,
          .inlet_width = d,
          .spike = 1 - 0.45 * d,
          .spike_width = 0.5 * d * l.scale};
}

double film_at_centre(const Run& run) {
  const Discretisation& at = run.workspace.now;
  const Array X = at.places(run.setting.inlet);
  Eigen::Index centre = 0;
  X.abs().minCoeff(&centre);
  return at.H[centre];
}

/// The map that the present solution asks for.
MapShape shape_of(const Run& run, const Recipe& recipe) {
  const Discretisation& at = run.workspace.now;
  const Array X = at.places(run.setting.inlet);
  const Array& P = run.state.P;
  const Lengths l = lengths_from_film(film_at_centre(run));
  const double d = std::pow(std::min(1.0, l.film), 2.0 / 3);
  int steepest = -1;
  double fall = 0;
  for (int i = 0; i < at.n; ++i) {
    const double slope = (P[i] - P[i + 1]) / (X[i + 1] - X[i]);
    if (X[i] > 0 && slope > fall) {
      fall = slope;
      steepest = i;
    }
  }
  MapShape shape{.inlet = run.setting.inlet, .exit = run.state.exit, .scale = l.scale, .inlet_width = d};
  if (steepest < 0) {
    shape.spike = run.state.exit - 0.9 * d * l.scale;
    shape.spike_width = 0.5 * d * l.scale;
  } else {
    const double cell = X[steepest + 1] - X[steepest];
    shape.spike = (X[steepest] + X[steepest + 1]) / 2;
    shape.spike_width = std::max(recipe.narrowest * d * l.scale, recipe.cells * cell);
  }
  return shape;
}

/// The pressure of `from`, known on equal steps of `map`, at X.
class OnMap {
 public:
  OnMap(const Map& map, const State& from, double inlet)
      : map_(map), P_(from.P), inlet_(inlet), stretch_((map.shape().exit - inlet) / (from.exit - inlet)) {}
  [[nodiscard]] double operator()(double X) const {
    const auto m = static_cast<int>(P_.size()) - 1;
    const double at = map_(inlet_ + (X - inlet_) * stretch_) * m;
    if (at >= m) return 0;
    const int first = std::clamp(static_cast<int>(at) - 1, 0, m - 3);
    const double t = at - first;
    const double* const p = P_.data() + first;
    const double value = -(t - 1) * (t - 2) * (t - 3) / 6 * p[0] + t * (t - 2) * (t - 3) / 2 * p[1] -
                         t * (t - 1) * (t - 3) / 2 * p[2] + t * (t - 1) * (t - 2) / 6 * p[3];
    return std::max(0.0, value);
  }

 private:
  const Map& map_;
  const Array& P_;
  double inlet_, stretch_;
};

/// A new map under the present solution, on n intervals; the film at X = 0 is kept.
void remap(Run& run, const Recipe& recipe, int n) {
  const double film = film_at_centre(run);
  const Map old = *run.workspace.grids.map();
  const auto fresh = std::make_shared<const Map>(shape_of(run, recipe));
  const OnMap pressure(old, run.state, run.setting.inlet);
  run.workspace.grids.use(fresh, recipe.robust_wedge);
  Grid& grid = run.workspace.grids.of(n);
  State state{.P = Array::Zero(n + 1), .offset = 0, .exit = run.state.exit, .tail = run.state.tail};
  const double length = state.exit - run.setting.inlet;
  for (int i = 1; i < n; ++i) state.P[i] = pressure(run.setting.inlet + length * grid.place[i]);
  state.offset = offset_for(film, run.setting, state, grid);
  run.state = std::move(state);
}

bool first_solution(Run& run, const Recipe& recipe, double tolerance, NewtonResult& result) {
  auto map = std::make_shared<const Map>(expected_shape(run));
  run.workspace.grids.use(map, recipe.robust_wedge);
  Grid& grid = run.workspace.grids.of(recipe.first);
  const double film = run.lengths.film;
  const Shape likely = likely_shape(film), other = likely == Shape::hertz ? Shape::martin : Shape::hertz;
  const std::pair<Shape, double> attempts[] = {{likely, 1.0}, {likely, 2.0}, {likely, 0.5},
                                               {likely, 4.0}, {other, 1.0},  {other, 2.0}};
  for (const auto& [shape, factor] : attempts) {
    State state = first_iterate(run.setting, shape, factor * film, grid);
    result = newton_on(run, state, tolerance);
    if (run.limit_reached) return false;
    if (succeeded(result, run, state)) {
      run.state = std::move(state);
      return true;
    }
  }
  return false;
}

/// From nothing to a solution on `map_nodes` intervals of the final map.
bool start(Run& run, const Recipe& recipe, double tolerance, NewtonResult& result) {
  if (!first_solution(run, recipe, 1e-3, result)) return false;
  for (int k = 0; k < recipe.remaps; ++k) {
    remap(run, recipe, map_nodes);
    State state = run.state;
    result = newton_on(run, state, k + 1 == recipe.remaps ? tolerance : 1e-3);
    if (!succeeded(result, run, state)) {
      state = run.state;
      if (!lower_floor(run, state, tolerance, result)) return false;
    }
    run.state = std::move(state);
  }
  return true;
}

struct Extrapolated {
  double value = 0, error = std::numeric_limits<double>::infinity();
};
/// R_n = (4 f_n - f_(n/2))/3 and what it may be off by, absolute.
Extrapolated extrapolate(const std::vector<GridRecord>& grids, Quantity quantity) {
  std::vector<double> f;
  for (const GridRecord& grid : grids) {
    const auto found = grid.observed.find(quantity);
    if (found == grid.observed.end()) {
      f.clear();
    } else {
      f.push_back(found->second.value);
    }
  }
  const std::size_t m = f.size();
  if (m == 0) return {};
  if (m == 1) return {.value = f[0]};
  const double now = (4 * f[m - 1] - f[m - 2]) / 3;
  if (m == 2) return {.value = now, .error = std::abs(f[1] - f[0])};
  const double before = (4 * f[m - 2] - f[m - 3]) / 3;
  return {.value = now, .error = std::abs(now - before)};
}

}  // namespace

Solution Mapped::solve(const Problem& problem, const Request& request) const {
  Workspace workspace;
  return solve(problem, request, workspace);
}

Solution Mapped::solve(const Problem& problem, const Request& request, Workspace& workspace) const {
  const auto begin = Clock::now();
  const double planning_before = workspace.grids.planning_s();
  const long plans_before = workspace.grids.plans();
  const Lengths lengths = expected_lengths(problem.groups);
  const auto* const cut = std::get_if<TruncatedAt>(&problem.inlet);
  Run run{.problem = problem,
          .setting = {.groups = problem.groups,
                      .viscosity = problem.viscosity,
                      .density = problem.density,
                      .inlet = cut ? cut->x : -reach * lengths.scale,
                      .with_tail = !cut,
                      .sources = problem.sources},
          .workspace = workspace,
          .limits = limits_of(request, begin),
          .lengths = lengths};
  Wanted wanted = problem.wanted;
  wanted.insert({Quantity::film_minimum, Quantity::film_central});
  const double tolerance = request.tolerance.value_or(0);
  const double target = request.nodes ? 1e-11 : std::min(1e-3, tolerance * iteration_share);
  const int last = request.nodes.value_or(largest_nodes);

  Solution solution;
  SolveRecord& record = solution.record;
  NewtonResult result;
  bool started = false;
  for (const Recipe& recipe : recipes) {
    started = start(run, recipe, target, result);
    if (getenv("EHD_TRACE")) fprintf(stderr, "start %d newton %ld\n", started, run.counters.newton);
    if (started || run.limit_reached) break;
  }
  const auto record_grid = [&](int n, long newton_before) {
    solution.fields = fields_of(run);
    GridRecord grid{.nodes = n,
                    .newton_iterations = static_cast<int>(run.counters.newton - newton_before),
                    .residual = result.residual,
                    .observed = observe(solution.fields, wanted)};
    record.grids.push_back(std::move(grid));
    for (auto& [quantity, budget] : {std::pair{Quantity::film_minimum, &record.film_minimum},
                                    std::pair{Quantity::film_central, &record.film_central}}) {
      const Extrapolated e = extrapolate(record.grids, quantity);
      *budget = {.discretisation = e.error / std::abs(e.value), .iteration = std::max(result.residual, target), .truncation = 0};
    }
    if (getenv("EHD_TRACE")) fprintf(stderr, "n %d newton %ld krylov %ld res %.2e Hmin %.3e Hcen %.3e\n", n, run.counters.newton-newton_before, run.counters.krylov, result.residual, record.film_minimum.discretisation, record.film_central.discretisation);
  };
  if (started) {
    record_grid(map_nodes, run.counters.newton);
    for (int n = 2 * map_nodes; n <= last; n *= 2) {
      if (!request.nodes && record.film_minimum.total() <= tolerance && record.film_central.total() <= tolerance) break;
      const long newton_before = run.counters.newton;
      State state = interpolate_to(run.state, n);
      result = newton_on(run, state, target);
      bool solved = succeeded(result, run, state);
      if (!solved && !run.limit_reached) {
        state = interpolate_to(run.state, n);
        solved = lower_floor(run, state, target, result);
        if (getenv("EHD_TRACE")) fprintf(stderr, "floor: %d\n", solved);
      }
      if (!solved) break;
      run.state = std::move(state);
      record_grid(n, newton_before);
    }
    solution.observables = record.grids.back().observed;
    for (auto& [quantity, reading] : solution.observables) {
      const Extrapolated e = extrapolate(record.grids, quantity);
      reading.value = e.value;
      reading.error = is_absolute(quantity) ? e.error : e.error / std::abs(e.value);
    }
    std::erase_if(solution.observables, [&](const auto& entry) { return !problem.wanted.contains(entry.first); });
    record.status = record.film_minimum.total() <= tolerance && record.film_central.total() <= tolerance ? StopReason::converged : StopReason::tolerance_not_met;
    if (request.nodes) record.status = StopReason::converged;
  }
  record.cost.nodes = started ? record.grids.back().nodes : 0;
  record.cost.levels = static_cast<int>(record.grids.size());
  fill(record.cost, run, begin, planning_before, plans_before);
  return solution;
}

}  // namespace ehd::fast
