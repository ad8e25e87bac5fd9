// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/estimate.hpp"
#include "contact/film_formulas.hpp"
#include "contact/interruption.hpp"
#include "contact/known_pressures.hpp"
#include "contact/observables.hpp"
#include "contact/stated_error.hpp"
#include "contact/text.hpp"

namespace ehd::reference {

namespace {

using Eigen::Index;

constexpr double formal_order = 2;
/// Hertz' pressure is a start below the first film, the rigid gap's above the second.
constexpr double thinnest_rigid_film = 0.1, thickest_hertz_film = 5;
/// Run time grows as n^3: a grid with twice the intervals takes 8 times as long.
constexpr double time_of_doubled_grid = 8;
/// The truncation is measured by cutting the domain at X_a/8 or at -50 l, whichever is nearer to the contact.
constexpr double cut_part = 8, nearest_cut = -50;
/// Stated truncation over the measured one.
constexpr double truncation_safety = 2;
constexpr double longest_time_s = 1e8;
constexpr int fewest_halved = 32;        // grids with fewer intervals are not halved
constexpr std::size_t fewest_grids = 3;  // that a tolerance needs

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

Fields fields_of(const Level& level, const Problem& problem) {
  const Evaluation& at = level.at;
  Fields fields;
  fields.X = at.X;
  fields.P = level.state.P;
  fields.H = at.H;
  fields.density = at.density.value;
  fields.log_viscosity = at.viscosity.value;
  fields.flux = at.wedge - at.mobility * at.gradient;
  fields.offset = level.state.offset;
  // The rolling force falls only as 1/|X_a|: what lies further out is lambda Int dX/H with H = X^2/2 there.
  if (std::holds_alternative<Flooded>(problem.inlet)) fields.work_beyond_inlet = 2 * problem.groups.lambda / -at.X[0];
  return fields;
}

/// Least relative error that is stated for a film on a grid with few cells in the inlet zone. With more cells than
/// `safe_inlet_cells`, the differences of grids are enough. At least three times the error of equal cells,
/// Roelands, compressible, at (100, 10), (200, 15), (1000, 10), (1000, 20): 0.84 with 0.1 cells, 0.33 with 0.5, 0.16
/// with 0.9, 0.10 with 1.4, 0.03 with 2, 0.0075 with 5.
constexpr double safe_inlet_cells = 8, error_of_one_cell = 0.6;
double coarse_grid_error(double inlet_cells) { return error_of_one_cell / (inlet_cells * std::max(1.0, inlet_cells)); }

/// Grids may agree on one number by chance. So no number errs by less than this share of the larger error of the judged
/// films; the offset by that share of the film. Without it X*, the rolling force, the offset and the Couette film were
/// off by up to 25, 42, 106 and 2.8 times what was stated, at 36, 8, 4 and 1 of some 2,700 grids of 48 to 300
/// intervals.
/// The pressure maximum of reference.uniform was off by up to 25 times on 48 intervals.
double share_of_films(std::size_t grids) { return grids > 2 ? 0.3 : 1; }

/// A quantity on the finest of the levels and on all before it that have the quantity without a gap.
std::vector<double> values_on(const std::vector<Level>& levels, Quantity quantity) {
  std::vector<double> values;
  for (const Level& level : levels) {
    if (level.seen.contains(quantity))
      values.push_back(level.seen.at(quantity).value);
    else
      values.clear();
  }
  return values;
}

Judged judged_on(const std::vector<Level>& levels, Quantity quantity, bool extrapolate) {
  // Calibrated on 400 contacts of M = 0.05..1000, L = 0..25, both law sets, flooded and from M = 0.5 cut, asked for
  // 1e-3. With an earlier contact/estimate.hpp 312 were compared with 1600 intervals: no stated error was too small
  // with a factor of 2. With the present one and that factor (23.15, 15.05), Roelands, cut at -3.8, states an H_min to
  // 0.72 of its error, and 2 of 1500 films of 150 other contacts state too small an error, by 1.65 and 2.04. Values
  // that are not extrapolated need no further factor.
  constexpr double extrapolation_safety = 3;
  const std::vector<double> values = values_on(levels, quantity);
  const GridEstimate now = estimate(values, formal_order);
  const double error = extrapolate ? extrapolation_safety * now.extrapolated_error : now.error;
  return {.value = extrapolate ? now.extrapolated : now.value,
          .error = is_pressure_peak(quantity) ? peak_error(quantity, values, now, error) : error};
}

/// The study always needs the films, because their errors decide when it ends; and the spike, because it may be the
/// pressure maximum.
Wanted with_needed(Wanted wanted) {
  wanted.insert({Quantity::film_minimum, Quantity::film_central, Quantity::pressure_spike});
  return wanted;
}

/// The level without the nodes before `first`; the pressure there is set to zero.
std::pair<Grid, State> cut(const Level& level, Index first) {
  const Array& s = level.grid.fractions;
  const Index nodes = s.size() - first;
  Grid grid{
      .inlet = level.at.X[first], .fractions = s.tail(nodes) / s[first], .kappa = level.grid.kappa.tail(nodes - 1)};
  State state{.P = level.state.P.tail(nodes), .offset = level.state.offset, .exit = level.state.exit};
  state.P[0] = 0;
  return {std::move(grid), std::move(state)};
}

}  // namespace

double Level::cells_in_inlet_zone() const { return inlet_cells(at.X, central_film()); }

Study::Study(const Problem& problem, const Request& request)
    : problem_(problem),
      request_(request),
      budget_{.newton_iterations = request.max_iterations,
              .end = begin_ + std::chrono::duration_cast<Clock::duration>(
                                  std::chrono::duration<double>(std::min(request.time_limit_s, longest_time_s)))},
      expected_film_(ehd::expected_film({problem.groups.M, problem.groups.L})) {}

std::optional<Level> Study::attempt(const Equations& equations, const State& start) {
  NewtonResult run = newton(equations, start, budget_);
  const int intervals = equations.grid().intervals();
  budget_.newton_iterations -= run.iterations;
  spent_.newton_iterations += run.iterations;
  spent_.convolutions += run.kernel_products;
  spent_.viscosity_points += run.viscosity_points;
  spent_.density_points += run.density_points;
  point_products_ += static_cast<double>(run.kernel_products) * intervals;
  limit_reached_ = run.end == NewtonEnd::limit_reached;
  if (run.end != NewtonEnd::solved) return std::nullopt;

  Level level{.grid = equations.grid(),
              .state = std::move(run.state),
              .at = std::move(run.at),
              .iteration_error = run.iteration_error,
              .seen = {}};
  level.seen = observe(fields_of(level, problem_), with_needed(problem_.wanted));
  if (!level.seen.contains(Quantity::film_central)) return std::nullopt;
  GridRecord record;
  record.nodes = intervals;
  record.newton_iterations = run.iterations;
  record.residual = level.at.relative_residual();
  record.inlet_cells = level.cells_in_inlet_zone();
  record.observed = level.seen;
  grids_.push_back(std::move(record));
  return level;
}

std::optional<Level> Study::solve(const Grid& grid, bool insist) {
  const auto begin = Clock::now();
  const Equations equations(problem_, grid);
  std::optional<Level> level;
  for (const double factor : start_films) {
    const double film = factor * expected_film_;
    // Hertz' pressure where the film is thin, Martin's where it is thick, both between.
    if (expected_film_ < thickest_hertz_film)
      level = attempt(equations, hertz_start(equations, film, 1 + exit_per_inlet_zone * inlet_zone(film)));
    if (level || limit_reached_) break;
    if (expected_film_ > thinnest_rigid_film) level = attempt(equations, martin_start(equations, film));
    if (level || limit_reached_ || !insist) break;
  }
  last_grid_s_ = seconds_since(begin);
  return level;
}

std::optional<Level> Study::solve(const Grid& grid, const Level& from, bool insist) {
  const auto begin = Clock::now();
  const Equations equations(problem_, grid);
  std::optional<Level> level = attempt(equations, interpolated_start(equations, from.state, from.at));
  last_grid_s_ = seconds_since(begin);
  if (level || limit_reached_) return level;
  return solve(grid, insist);
}

bool Study::no_time_to_double() const {
  const double left_s = std::chrono::duration<double>(budget_.end - Clock::now()).count();
  return time_of_doubled_grid * last_grid_s_ > left_s;
}

std::optional<Truncation> Study::truncation(const Level& level) {
  const Array& X = level.at.X;
  const double near = std::max(X[0] / cut_part, nearest_cut * contact_length(level.central_film()));
  const Index first = std::lower_bound(X.begin(), X.end(), near) - X.begin();
  const auto [grid, start] = cut(level, first);
  const auto solved = attempt(Equations(problem_, grid), start);
  if (!solved) return std::nullopt;
  grids_.pop_back();  // a cut grid is no grid of the study
  const double ratio = X[0] / X[first];
  Truncation truncation{.inlet = X[0], .errors = {}};
  for (const auto& [quantity, reading] : level.seen) {
    if (is_self_check(quantity) || !solved->seen.contains(quantity)) continue;
    const double move = std::abs(solved->seen.at(quantity).value - reading.value) / (ratio * ratio - 1);
    truncation.errors[quantity].value =
        truncation_safety * move / (has_absolute_error(quantity) ? 1 : std::abs(reading.value));
  }
  return truncation;
}

Cost Study::cost(int finest) const {
  Cost cost = spent_;
  cost.wall_s = seconds_since(begin_);
  cost.work_units = finest > 0 ? point_products_ / finest : 0;
  cost.nodes = finest;
  cost.levels = static_cast<int>(grids_.size());
  return cost;
}

ErrorBudget Study::budget_of(Quantity quantity, const Judged& judged, const std::vector<Level>& levels,
                             const std::optional<Truncation>& truncation) const {
  const Level& finest = levels.back();
  const double cells = finest.cells_in_inlet_zone();
  const bool single = levels.size() == 1;
  ErrorBudget budget{.discretisation = judged.error, .iteration = finest.iteration_error, .truncation = 0};
  if (truncation && truncation->errors.contains(quantity))
    budget.truncation = truncation->errors.at(quantity).value * std::pow(truncation->inlet / finest.grid.inlet, 2);
  if (has_absolute_error(quantity)) {
    budget.discretisation *= std::abs(judged.value);
    budget.iteration *= finest.central_film();
  }
  if (is_film(quantity) && cells < safe_inlet_cells)
    budget.discretisation = std::max(single ? 0 : budget.discretisation, coarse_grid_error(cells));
  if (has_absolute_error(quantity) && single)  // H_0 is the film at X = 0 less a deflection of order one
    budget.discretisation = coarse_grid_error(cells) * (1 + finest.central_film());
  if (flooded() && !truncation) budget.truncation = std::numeric_limits<double>::infinity();
  return budget;
}

double Study::least_discretisation(const std::vector<Level>& levels, bool extrapolate) const {
  double of_films = 0;
  for (const Quantity film : judged_films)
    of_films = std::max(of_films, budget_of(film, judged_on(levels, film, extrapolate), levels, {}).discretisation);
  return share_of_films(levels.size()) * of_films;
}

Solution Study::report(const std::vector<Level>& levels, bool extrapolate,
                       const std::optional<Truncation>& truncation) const {
  const Level& finest = levels.back();
  Solution solution;
  solution.fields = fields_of(finest, problem_);
  if (levels.size() > 1) solution.beside = {pressure_alone(fields_of(levels[levels.size() - 2], problem_))};
  const double least = least_discretisation(levels, extrapolate);
  for (auto [quantity, reading] : finest.seen) {
    if (!is_self_check(quantity)) {
      const Judged judged = judged_on(levels, quantity, extrapolate);
      reading.value = judged.value;
      ErrorBudget budget = budget_of(quantity, judged, levels, truncation);
      if (std::ranges::count(judged_films, quantity) == 0)
        budget.discretisation =
            std::max(budget.discretisation, least * (has_absolute_error(quantity) ? finest.central_film() : 1));
      if (quantity == Quantity::film_central)
        budget.discretisation = std::max(budget.discretisation, roughness_at_centre(solution.fields));
      if (std::isfinite(budget.total())) reading.error = budget.total();
      if (const auto parts = row_of(quantity).budget) solution.record.*parts = budget;
    }
    solution.observables[quantity] = reading;
  }
  keep_known_pressures(solution.observables, problem_.wanted, solution.fields,
                       values_on(levels, Quantity::pressure_spike).size(), problem_.groups.L, solution.record.notes);
  keep_wanted(solution.observables, problem_.wanted);
  solution.record.status = StopReason::converged;
  solution.record.cost = cost(finest.grid.intervals());
  solution.record.grids = grids_;
  return solution;
}

Solution Study::without_film(StopReason status, std::string reason) const {
  Solution solution;
  solution.record.status = status;
  solution.record.reason = std::move(reason);
  solution.record.cost = cost(grids_.empty() ? 0 : grids_.back().nodes);
  solution.record.grids = grids_;
  return solution;
}

std::vector<int> doubled_sizes(int n0, int largest) {
  std::vector<int> sizes;
  for (int n = n0; n <= largest; n *= 2) sizes.push_back(n);
  return sizes;
}

std::vector<int> halved_sizes(int n, const std::function<bool(int)>& useful) {
  std::vector<int> sizes{n};
  while (sizes.back() >= fewest_halved && useful((sizes.back() + 1) / 2)) sizes.push_back((sizes.back() + 1) / 2);
  std::reverse(sizes.begin(), sizes.end());
  return sizes;
}

namespace {

std::string inlet_zone_is_narrow() { return "the inlet zone is narrower than " + plain(fewest_inlet_cells) + " cells"; }

/// Why a study has no film, though no limit ended it; `cells` are those of its finest grid in the inlet zone of the
/// expected film.
Solution no_grid_solved(const Study& study, double cells, const std::string& finest) {
  if (cells < fewest_inlet_cells)
    return study.without_film(StopReason::under_resolved,
                              inlet_zone_is_narrow() + " and no positive film solves the equations of " + finest);
  return study.without_film(StopReason::diverged, "no positive film was found on up to " + finest);
}

}  // namespace

Solution solve_grids(Study& study, const std::function<Grid(int)>& grid_of, const std::vector<int>& sizes,
                     const FilmTolerances& asked, bool extrapolate, const std::optional<Level>& start) {
  std::vector<Level> levels;
  std::optional<Level> last = start;
  std::optional<Truncation> truncation;
  Solution solution;
  bool out_of_time = false, no_time = false;
  for (const int n : sizes) {
    no_time = out_of_time = last && asked.any() && study.no_time_to_double();
    if (out_of_time) break;
    const bool insist = asked.any() || n == sizes.back();  // without this half only the error estimate is lost
    std::optional<Level> level = last ? study.solve(grid_of(n), *last, insist) : study.solve(grid_of(n), insist);
    out_of_time = study.limit_reached();
    if (out_of_time) break;
    if (!level) {
      levels.clear();
      last = start;
      continue;
    }
    last = level;
    if (asked.any() && level->cells_in_inlet_zone() < fewest_inlet_cells) continue;
    levels.push_back(*level);
    if (study.flooded() && !truncation) truncation = study.truncation(*level);
    solution = study.report(levels, extrapolate, truncation);
    if (levels.size() >= fewest_grids && asked.met_by(solution.record.film_minimum, solution.record.film_central))
      return solution;
  }

  const std::string finest = std::to_string(sizes.back()) + " intervals";
  const std::string limit = (no_time ? time_limit_reason : "iterations or time ended") + (" before " + finest);
  if (levels.empty() && out_of_time) return study.without_film(StopReason::limit_reached, limit);
  if (levels.empty())
    return no_grid_solved(study, inlet_cells(grid_of(sizes.back()).nodes(1), study.expected_film()), finest);
  if (out_of_time) {
    solution.record.cost = study.cost(solution.record.cost.nodes);  // with the cost of the grid that was given up
    solution.record.status = StopReason::limit_reached;
    solution.record.reason = limit;
  } else if (asked.any()) {
    solution.record.status = StopReason::tolerance_not_met;
    solution.record.reason = "the estimated errors of the films exceed the tolerance on " + finest;
  } else if (levels.back().cells_in_inlet_zone() < fewest_inlet_cells) {
    solution.record.status = StopReason::under_resolved;
    solution.record.reason = inlet_zone_is_narrow();
  } else if (const auto why = too_coarse(solution.record.film_minimum, solution.record.film_central)) {
    solution.record.status = StopReason::under_resolved;
    solution.record.reason = *why;
  }
  return solution;
}

}  // namespace ehd::reference
