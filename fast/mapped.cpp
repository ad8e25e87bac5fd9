// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/mapped.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <limits>
#include <optional>
#include <span>

#include "contact/observables.hpp"
#include "contact/nondimensional.hpp"
#include "fast/extrapolation.hpp"
#include "fast/run.hpp"

namespace ehd::fast {

using Clock = std::chrono::steady_clock;

namespace {

// Iteration stops at this share of the tolerance (see uniform.cpp).
constexpr double iteration_share = 1.0 / 30;
/// Or at this share in the films of each grid, by the estimate of a step: extrapolation multiplies their errors by 45/21 at
/// most. The residual must be below a tenth of the tolerance as well: where an interpolated start errs most on the far
/// faces, the first step's contraction says nothing about the films (5e-5 off at (1000, 10) without).
constexpr double film_share = 1.0 / 60, extrapolation_gain = 45.0 / 21;
constexpr int first_nodes = 64;  ///< of every sequence of grids, and of the solutions that make maps
constexpr Target for_maps{.residual = 1e-3, .film_error = 1e-2};  ///< of the solutions that only serve to make a map
/// A flooded grid begins at X_a = -reach l; the relative film error that the tail beyond it leaves.
constexpr double reach = 16, truncation_of_films = 1e-8;
/// What truncation does to other numbers than films, in units of that.
constexpr double truncation_of_work = 20, truncation_of_offset = 5;
/// Estimates of a spike's height are multiplied, and what stays vague is left out (see uniform.cpp).
constexpr double spike_safety = 3, vaguest_spike = 0.05;

/// A way to begin: the first is right nearly always, the others are retries.
struct Recipe {
  double narrowest;  ///< w_sp >= narrowest d l
  double cells;      ///< w_sp >= this many cells at the spike
  bool robust_wedge;
  bool remaps;
  int first;
};
constexpr Recipe recipes[] = {{0.005, 0.5, false, true, 64},
                              {0.1, 1, false, true, 64},
                              {0.1, 1, true, true, 64},
                              {0.5, 1, false, false, 64},
                              {0.1, 1, true, true, 128}};
constexpr double loose_tolerance = 3e-4, mild_L = 10;
/// How good a map the tolerance is worth.
enum class Care { least, little, full };
/// The grids whose solutions make the next map, after the first. Measured on 464 problems: without any, 1e-2 takes 40 % less
/// time and its bars hold; at 1e-3 that misses bars where a narrow spike stands (1.2 % of 3000 films, L > 12), so one is made
/// there; three make H_min at n = 512 three times better.
std::span<const int> map_grids(Care care) {
  static constexpr int all[] = {64, 128, 128};
  return std::span(all).first(care == Care::least ? 0 : care == Care::little ? 1 : 3);
}
Care care_for(const Request& request, double L) {
  if (request.nodes || *request.tolerance < loose_tolerance) return Care::full;
  return *request.tolerance >= 10 * loose_tolerance || L <= mild_L ? Care::least : Care::little;
}

double relative_inlet_width(double film) { return std::pow(std::min(1.0, film), 2.0 / 3); }

MapShape expected_shape(const Run& run) {
  const Lengths& l = run.lengths;
  const double d = relative_inlet_width(l.film);
  return {.inlet = run.setting.inlet,
          .exit = l.film > 0.5 ? 0.5 * std::sqrt(2 * l.film) : 1 + 0.45 * d,
          .scale = l.scale,
          .inlet_width = d,
          .spike = 1 - 0.45 * d,
          .spike_width = 0.5 * d * l.scale};
}

/// What a solution, on whichever nodes, has to say to the next map.
struct Known {
  Array X, P;
  double film = 0;  ///< H at the node nearest to X = 0
};

Known known_of(Array X, Array P, const Array& H) {
  Eigen::Index centre = 0;
  X.abs().minCoeff(&centre);
  const double film = H[centre];
  return {.X = std::move(X), .P = std::move(P), .film = film};
}

/// The map that a solution asks for: the spike is where the pressure falls most steeply.
MapShape shape_for(const Known& known, double inlet, const Recipe& recipe) {
  const auto& [X, P, film] = known;
  const Lengths l = lengths_from_film(film);
  const double d = relative_inlet_width(film), width = d * l.scale;
  MapShape shape{.inlet = inlet, .exit = X[X.size() - 1], .scale = l.scale, .inlet_width = d};
  shape.spike = shape.exit - 0.9 * width;
  shape.spike_width = 0.5 * width;
  double steepest = 0;
  for (Eigen::Index i = X.size() - 2; i >= 0 && X[i] > 0; --i) {
    const double cell = X[i + 1] - X[i], fall = (P[i] - P[i + 1]) / cell;
    if (!(fall > steepest)) continue;
    steepest = fall;
    shape.spike = (X[i] + X[i + 1]) / 2;
    shape.spike_width = std::max(recipe.narrowest * width, recipe.cells * cell);
  }
  return shape;
}

/// A new map under a known solution, on n intervals; the film at X = 0 is kept.
State on_new_map(Run& run, const Known& known, const InletTail& tail, const Recipe& recipe, int n) {
  const auto& [X, P, film] = known;
  const double inlet = run.setting.inlet, exit = X[X.size() - 1];
  const Stage before = run.counters.clock.change_to(Stage::grids);
  run.workspace.grids.use(std::make_shared<const Map>(shape_for(known, inlet, recipe)), recipe.robust_wedge);
  Grid& grid = run.workspace.grids.of(n);
  run.counters.clock.change_to(before);
  State state{.P = Array::Zero(n + 1), .offset = 0, .exit = exit, .tail = tail};
  const Eigen::Index last = X.size() - 1;
  Eigen::Index cell = 0;
  for (int i = 1; i < n; ++i) {
    const double at = inlet + (exit - inlet) * grid.place[i];
    if (at <= X[0]) continue;  // another solution's inlet may begin later: no pressure yet
    while (cell + 1 < last && X[cell + 1] < at) ++cell;
    // Cubic Lagrange through the four nodes about the cell.
    const Eigen::Index first = std::clamp<Eigen::Index>(cell - 1, 0, last - 3);
    double value = 0;
    for (Eigen::Index j = first; j < first + 4; ++j) {
      double basis = 1;
      for (Eigen::Index k = first; k < first + 4; ++k) {
        if (k != j) basis *= (at - X[k]) / (X[j] - X[k]);
      }
      value += basis * P[j];
    }
    state.P[i] = std::max(0.0, value);
  }
  state.offset = offset_for(film, run.setting, state, grid);
  return state;
}

Known known_now(const Run& run) {
  const Discretisation& at = run.workspace.now();
  return known_of(at.places(run.setting.inlet), run.state.P, at.H);
}

bool first_solution(Run& run, const Recipe& recipe, NewtonResult& result) {
  const Stage before = run.counters.clock.change_to(Stage::grids);
  run.workspace.grids.use(std::make_shared<const Map>(expected_shape(run)), recipe.robust_wedge);
  Grid& grid = run.workspace.grids.of(recipe.first);
  run.counters.clock.change_to(before);
  const double film = run.lengths.film;
  const Shape likely = likely_shape(film), other = likely == Shape::hertz ? Shape::martin : Shape::hertz;
  const std::pair<Shape, double> attempts[] = {{likely, 1.0}, {likely, 2.0}, {likely, 0.5},
                                               {likely, 4.0}, {other, 1.0},  {other, 2.0}};
  for (const auto& [shape, factor] : attempts) {
    State state = first_iterate(run.setting, shape, factor * film, grid);
    result = newton_on(run, state, for_maps);
    if (run.limit_reached) return false;
    if (succeeded(result, run, state)) {
      run.state = std::move(state);
      return true;
    }
  }
  return false;
}

/// Newton; where an interpolated pressure has closed the film, once more with the film at X = 0, `film`, restored; where a
/// sharpening spike stops it, with a floor under the fluidity. run.state: the start, then the result.
bool solve_on(Run& run, double film, const Target& target, NewtonResult& result) {
  const State begin = run.state;
  result = newton_on(run, run.state, target);
  if (succeeded(result, run, run.state)) return true;
  if (run.limit_reached) return false;
  run.state = begin;
  run.state.offset = offset_for(film, run.setting, run.state, run.workspace.grids.of(static_cast<int>(begin.P.size()) - 1));
  result = newton_on(run, run.state, target);
  if (succeeded(result, run, run.state)) return true;
  if (run.limit_reached) return false;
  run.state = begin;
  return lower_floor(run, run.state, target, result);
}

/// What was called a neighbour's solution is one: less than a quarter of the load has moved. Neighbours 2 and 10 % away in
/// M and L moved 1 to 24 % of it at 139 of 140 points (M of .2..1000, L of 2.5..20, both law sets); nine in ten of the
/// random pressures of `ehd stress --part b` move more than 30 %, and a map made from one has to be made again.
bool was_near(const Run& run, const State& before) {
  constexpr double share = 0.25;
  const Grid& grid = run.workspace.grids.of(static_cast<int>(before.P.size()) - 1);
  const double moved = (grid.slope * (run.state.P - before.P).abs()).sum() / grid.n * (run.state.exit - run.setting.inlet);
  return moved < share * std::numbers::pi / 2;
}

/// The final map and a start on it, on `first_nodes` intervals: from nothing, or from the solution of a neighbour. The
/// film at X = 0 that belongs to it.
std::optional<double> start(Run& run, const Recipe& recipe, const Solution* from, Care care, NewtonResult& result) {
  auto grids = recipe.remaps ? map_grids(care) : std::span<const int>();
  // At loose tolerances a neighbour's solution, with its sharper spike, costs more steps than nothing does (634 against
  // 546 at 24 problems, 2 and 10 % away in M and L); below it saves 15 %.
  if (from && care == Care::full) {
    const Known known = known_of(from->fields.X, from->fields.P, from->fields.H);
    const InletTail tail = run.setting.with_tail ? first_tail(run.setting, run.lengths.film) : InletTail{};
    run.state = on_new_map(run, known, tail, recipe, 2 * first_nodes);
    const State before = run.state;
    if (!solve_on(run, known.film, for_maps, result)) return std::nullopt;
    if (was_near(run, before)) grids = {};
  } else if (!first_solution(run, recipe, result)) {
    return std::nullopt;
  }
  for (const int n : grids) {
    const Known known = known_now(run);
    run.state = on_new_map(run, known, run.state.tail, recipe, n);
    if (!solve_on(run, known.film, for_maps, result)) return std::nullopt;
  }
  const Known known = known_now(run);
  if (recipe.remaps) run.state = on_new_map(run, known, run.state.tail, recipe, first_nodes);
  return known.film;
}

/// The values of a quantity on the grids of the final map, without those before a grid that lacks it.
std::vector<double> values_of(const std::vector<GridRecord>& grids, Quantity quantity) {
  std::vector<double> values;
  for (const GridRecord& grid : grids) {
    const auto found = grid.observed.find(quantity);
    if (found == grid.observed.end()) {
      values.clear();
    } else {
      values.push_back(found->second.value);
    }
  }
  return values;
}

/// Their limit; nothing where the finest grid lacks it.
std::optional<Limit> limit_of(const std::vector<GridRecord>& grids, Quantity quantity) {
  const std::vector<double> values = values_of(grids, quantity);
  if (values.empty()) return std::nullopt;
  Limit limit = fast::limit_of(values);
  // A spike passes between nodes, so its height and the work at it do not follow the films' expansion. Against the
  // reference at 102 problems (M of 0.1..300, L of 0..16, both law sets), four tolerances: without this 97 % of the
  // maxima, 90 % of the spikes and 98 % of the rolling forces were covered.
  const std::size_t m = values.size();
  const bool pressure = quantity == Quantity::pressure_maximum || quantity == Quantity::pressure_spike;
  if (pressure && m > 1) limit.error = std::max(limit.error, std::abs(values[m - 1] - values[m - 2]));
  if (quantity == Quantity::rolling_force) limit.error *= 3;
  return limit;
}

/// The numbers of intervals on the final map.
struct Levels {
  std::vector<int> given;  ///< with Request::nodes: coarse to fine
  int last = Mapped::largest_nodes;
  /// N, N/2, … down to 64 or more, odd ones rounded up: what extrapolation needs. A ratio that is not quite 2 leaves
  /// (4/N) of the error that it would have removed.
  static Levels of(const Request& request) {
    Levels levels;
    if (!request.nodes) return levels;
    levels.last = *request.nodes;
    levels.given = {levels.last};
    while (levels.given[0] >= 2 * fewest) levels.given.insert(levels.given.begin(), (levels.given[0] + 1) / 2);
    return levels;
  }
  static constexpr int fewest = 64;
};

/// What a single grid says of its own relative error in the films. Calibrated on 464 problems as in extrapolation.hpp: the
/// largest error was 4e-2 at 64 intervals, 9e-3 at 128, 4e-3 at 256; on 16, 12 % at (20, 10) and 35 % at (1000, 10).
double error_of_one_grid(int n) { return 330.0 / (static_cast<double>(n) * n); }

/// One way through all grids. False where Newton failed before the end.
struct Climb {
  std::vector<GridRecord> grids;
  Fields fields;
  ErrorBudget film_minimum, film_central;
  double iteration = 0;  ///< relative error that iteration leaves in the films; the largest of the grids
  bool complete = false;
};

class Climber {
 public:
  Climber(Run& run, const Request& request, const Wanted& wanted, double truncation)
      : run_(run), request_(request), wanted_(wanted), truncation_(truncation), levels_(Levels::of(request)) {}

  /// `from` is used where it pays, or `always`.
  [[nodiscard]] Climb operator()(const Recipe& recipe, const Solution* from, bool always = false) {
    Climb climb;
    NewtonResult result;
    const double tolerance = request_.tolerance.value_or(0);
    const auto to_tolerance = [](double relative) {
      return Target{.residual = relative * iteration_share,
                    .film_error = relative * film_share,
                    .film_residual = relative / 10};
    };
    std::optional<double> film = start(run_, recipe, from, always ? Care::full : care_for(request_, run_.setting.groups.L), result);
    if (!film) return climb;
    int n = first_nodes;
    for (std::size_t k = 0;; ++k) {
      if (!levels_.given.empty()) {
        if (k == levels_.given.size()) break;
        n = levels_.given[k];
      } else if (k > 0) {
        if (met(climb) || 2 * n > levels_.last) break;
        n *= 2;
      }
      Target target{.residual = 1e-11};
      if (!request_.nodes) {
        target = to_tolerance(tolerance);
      } else if (request_.iteration_share) {
        // The next grid's error is expected to be a fifth of what these grids are known to.
        const double known = climb.grids.size() > 1 ? std::min(climb.film_minimum.discretisation, climb.film_central.discretisation) : 1e-4;
        target = to_tolerance(*request_.iteration_share * known / 5);
      }
      const long newton_before = run_.counters.newton;
      if (run_.state.P.size() != n + 1) run_.state = interpolate_to(run_.state, n);
      if (!solve_on(run_, *film, target, result)) return climb;
      film = known_now(run_).film;
      note(climb, n, result, newton_before, target);
    }
    climb.complete = true;
    return climb;
  }

  [[nodiscard]] bool met(const Climb& climb) const {
    const double tolerance = request_.tolerance.value_or(0);
    return !request_.nodes && climb.film_minimum.total() <= tolerance && climb.film_central.total() <= tolerance;
  }

  /// Relative, films; the largest of both counts a little for each.
  [[nodiscard]] static double discretisation(const std::vector<GridRecord>& grids, Quantity film) {
    const auto relative = [&](Quantity quantity) {
      const auto limit = limit_of(grids, quantity);
      return limit ? limit->error / std::abs(limit->value) : std::numeric_limits<double>::infinity();
    };
    const double minimum = relative(Quantity::film_minimum), central = relative(Quantity::film_central);
    if (grids.size() == 1) return error_of_one_grid(grids[0].nodes);
    const double own = film == Quantity::film_minimum ? minimum : central;
    // A central film that lies outside the grid says nothing.
    const double largest = std::isfinite(central) ? std::max(minimum, central) : minimum;
    // Two or three coarse grids may agree by chance (M = 0.67, L = 26.5, 145 intervals: 2e-4 off at moves of 3e-5).
    const double n = grids.back().nodes, least = grids.size() < 4 ? 5 / (n * n) : 0;
    return std::max({own, shared(grids.size()) * largest, least});
  }

 private:
  void note(Climb& climb, int n, const NewtonResult& result, long newton_before, const Target& target) {
    climb.fields = fields_of(run_);
    GridRecord grid{.nodes = n,
                    .newton_iterations = static_cast<int>(run_.counters.newton - newton_before),
                    .residual = result.residual,
                    .observed = observe(climb.fields, wanted_)};
    const double film = grid.observed.at(Quantity::film_minimum).value;
    const Lengths l = lengths_from_film(film);
    const auto edge = std::lower_bound(climb.fields.X.begin(), climb.fields.X.end(), -l.scale) - climb.fields.X.begin();
    const auto right = std::clamp<Eigen::Index>(edge, 1, n);
    grid.inlet_cells = l.inlet / (climb.fields.X[right] - climb.fields.X[right - 1]);
    climb.grids.push_back(std::move(grid));
    climb.iteration = std::max(climb.iteration, request_.nodes ? result.residual : std::min(std::max(result.residual, target.residual), std::max(result.film_error, target.film_error) * extrapolation_gain));
    const auto budget = [&](Quantity quantity) {
      return ErrorBudget{.discretisation = discretisation(climb.grids, quantity),
                         .iteration = climb.iteration,
                         .truncation = truncation_};
    };
    climb.film_minimum = budget(Quantity::film_minimum);
    climb.film_central = budget(Quantity::film_central);
  }

  Run& run_;
  const Request& request_;
  const Wanted& wanted_;
  double truncation_;
  Levels levels_;
};

/// A spike is reported with its uncertainty or not at all; a pressure maximum likewise, and only where no spike that is not
/// known can be higher.
void judge_pressures(Observables& seen, std::size_t grids, const Wanted& wanted, std::vector<std::string>& notes) {
  const auto drop = [&](Quantity quantity, const char* why) {
    if (seen.erase(quantity) > 0 && wanted.contains(quantity))
      notes.push_back(std::string(to_string(quantity)) + " is left out: " + why);
  };
  const auto spike = seen.find(Quantity::pressure_spike), maximum = seen.find(Quantity::pressure_maximum);
  if (spike != seen.end()) {
    // Two grids prove nothing of a spike.
    if (grids < 3) spike->second.error.reset();
    if (spike->second.error) *spike->second.error *= spike_safety;
    const double vague = spike->second.error.value_or(1);
    const bool known = vague < vaguest_spike;
    if (maximum != seen.end()) {
      // An unknown spike grows with the grids; half as high again was met.
      const double height = spike->second.value * (1 + (known ? vague : std::max(0.5, vague)));
      if (height > maximum->second.value || maximum->second.place == spike->second.place) {
        if (known) {
          const double above = std::abs(height / maximum->second.value - 1);
          maximum->second.error = std::max({maximum->second.error.value_or(1), vague, above});
        } else {
          drop(Quantity::pressure_maximum, "the spike, whose height is not known to 5 %, may be higher");
        }
      }
    }
    if (!known) drop(Quantity::pressure_spike, "its height is not known to 5 %");
  }
  const auto left = seen.find(Quantity::pressure_maximum);
  if (left != seen.end() && !(left->second.error.value_or(1) < vaguest_spike))
    drop(Quantity::pressure_maximum, "its height is not known to 5 %");
}

/// The limits of the grids with their errors.
Observables limits_of_grids(const Climb& climb, const Problem& problem, SolveRecord& record) {
  Observables result = climb.grids.back().observed;
  const std::size_t grids = climb.grids.size();
  const double of_films = shared(grids) * std::max(climb.film_minimum.discretisation, climb.film_central.discretisation);
  const auto central = limit_of(climb.grids, Quantity::film_central);
  for (auto& [quantity, reading] : result) {
    if (quantity == Quantity::load_error || quantity == Quantity::flux_variation) continue;
    const auto limit = limit_of(climb.grids, quantity);
    if (grids > 1 && limit) reading.value = limit->value;
    const bool absolute = is_absolute(quantity);
    // H_0 is the film at X = 0 less a deflection of order one.
    const double scale = absolute ? 1 + std::abs(central ? central->value : 1) : 1;
    ErrorBudget budget = climb.film_central;
    budget.iteration *= scale;
    budget.truncation *= scale;
    budget.discretisation = limit ? limit->error / (absolute ? 1 : std::abs(limit->value)) : std::numeric_limits<double>::infinity();
    // The place of the exit moves as the films do; pressures have their own rule.
    if (quantity != Quantity::pressure_spike) budget.discretisation = std::max(budget.discretisation, of_films * scale);
    if (quantity == Quantity::film_minimum) budget = climb.film_minimum;
    if (quantity == Quantity::film_central) budget = climb.film_central;
    if (quantity == Quantity::rolling_force) budget.truncation *= truncation_of_work;
    if (absolute) budget.truncation *= truncation_of_offset;
    reading.error = budget.total();
    if (!std::isfinite(*reading.error)) reading.error.reset();
  }
  judge_pressures(result, grids, problem.wanted, record.notes);
  std::erase_if(result, [&](const auto& entry) { return !problem.wanted.contains(entry.first); });
  return result;
}

/// The same contact at half or twice the load, the milder of the two.
Problem milder(const Problem& problem) {
  Problem other = problem;
  const Groups& groups = problem.groups;
  other.groups = groups_from(MoesGroups{.M = groups.M < 1 ? 2 * groups.M : groups.M / 2, .L = groups.L});
  if (groups.alpha_p_H > 0) {
    const double unit = other.groups.alpha_p_H / groups.alpha_p_H;
    other.viscosity = in_units_of(problem.viscosity, unit);
    other.density = in_units_of(problem.density, unit);
  }
  return other;
}
constexpr int most_neighbours = 5;

Solution solve_mapped(const Problem& problem, const Request& request, Workspace& workspace, const Solution* from,
                      int neighbours = 0) {
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
  if (wanted.contains(Quantity::pressure_maximum)) wanted.insert(Quantity::pressure_spike);  // it may be the spike

  Solution solution;
  SolveRecord& record = solution.record;
  Climber climber(run, request, wanted, cut ? 0 : truncation_of_films);
  Climb best;
  if (from && from->fields.X.size() >= 4 && from->fields.P.size() == from->fields.X.size() &&
      from->fields.H.size() == from->fields.X.size())
    best = climber(recipes[0], from);
  for (const Recipe& recipe : recipes) {
    if (best.complete || run.limit_reached) break;
    Climb climb = climber(recipe, nullptr);
    if (climb.complete || climb.grids.size() > best.grids.size()) best = std::move(climb);
  }

  // The last resort, met where a short inlet starves a light load: from a milder neighbour.
  if (best.grids.empty() && !run.limit_reached && !problem.sources && neighbours < most_neighbours) {
    Request rough = request;
    rough.nodes.reset();
    rough.tolerance = 1e-2;
    rough.time_limit_s = request.time_limit_s - std::chrono::duration<double>(Clock::now() - begin).count();
    rough.max_iterations = request.max_iterations - static_cast<int>(run.counters.newton);
    const Solution neighbour = solve_mapped(milder(problem), rough, workspace, nullptr, neighbours + 1);
    run.counters.newton += neighbour.record.cost.newton_iterations;
    run.counters.krylov += neighbour.record.cost.krylov_iterations;
    run.counters.convolutions += neighbour.record.cost.convolutions;
    if (neighbour.fields.X.size() > 0) best = climber(recipes[0], &neighbour, true);
  }

  record.grids = std::move(best.grids);
  best.grids = record.grids;
  const bool solved = !record.grids.empty();
  if (solved) {
    solution.fields = std::move(best.fields);
    record.film_minimum = best.film_minimum;
    record.film_central = best.film_central;
    solution.observables = limits_of_grids(best, problem, record);
  }
  if (run.limit_reached) {
    record.status = StopReason::limit_reached;
    record.reason = "the limit on iterations or time was reached";
  } else if (!solved) {
    record.status = StopReason::diverged;
    record.reason = "Newton found no admissible solution from any start";
  } else if (!best.complete) {
    record.status = StopReason::tolerance_not_met;
    record.reason = "Newton does not converge beyond " + std::to_string(record.grids.back().nodes) + " intervals";
  } else if (!request.nodes && !climber.met(best)) {
    record.status = StopReason::tolerance_not_met;
    record.reason = "the finest grid's estimated error is above the tolerance";
  } else {
    record.status = StopReason::converged;
  }
  fill_cost(record, run, begin, planning_before, plans_before);
  return solution;
}

}  // namespace

Solution Mapped::solve(const Problem& problem, const Request& request) const {
  Workspace workspace;
  return solve_mapped(problem, request, workspace, nullptr);
}

Solution Mapped::solve(const Problem& problem, const Request& request, Workspace& workspace) const {
  return solve_mapped(problem, request, workspace, nullptr);
}

Solution Mapped::solve(const Problem& problem, const Request& request, Workspace& workspace,
                       const Solution& start) const {
  return solve_mapped(problem, request, workspace, &start);
}

}  // namespace ehd::fast
