// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/uniform_judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/estimate.hpp"
#include "contact/known_pressures.hpp"
#include "contact/observables.hpp"
#include "fast/uniform.hpp"

namespace ehd::fast {

namespace {

/// Discretisation error of one quantity, from its values on the grids; infinite where only one grid has it.
double discretisation_error(const std::vector<GridRecord>& grids, Quantity quantity) {
  const std::vector<double> values = values_of(grids, quantity);
  if (values.empty()) return std::numeric_limits<double>::infinity();
  const GridEstimate judged = estimate(values, Uniform::description.formal_order);
  if (is_pressure_peak(quantity)) return peak_error(quantity, values, judged, judged.error);
  return has_absolute_error(quantity) ? judged.error * std::abs(judged.value) : judged.error;
}

/// Relative film error of a lone grid of n intervals, times n^2. Of 400 contacts (M 0.2..30, L 0..30, both laws,
/// flooded and cut) on 16 to 62 intervals the largest was 2100, and 98 % were below 300. The inlet cells alone missed
/// 358 of 2756 central films there, by up to 14.
constexpr double error_of_lone_grid = 1500;

/// The calibrated film error, where the grids say too little: a lone grid, or one that hardly sees the inlet zone.
double least_error(const UniformClimb& climb) {
  const double by_cells = error_of_inlet_cells(climb.cells);
  if (climb.grids.size() < 2)
    return climb.grids.empty() ? by_cells : std::max(by_cells, error_of_lone_grid / std::pow(climb.grids[0].nodes, 2));
  return climb.cells < fewest_inlet_cells ? by_cells : 0;
}

/// A finest grid that was accepted without a Newton step has H_0 and X* of the grid before: no move judges them, and
/// all numbers err by more than the iteration's share. Of 170 contacts (M .003..50, L 0..20) asked for 1e-2 and 3e-2,
/// films erred by up to 1.4 times that share, X* by 1.9 times.
constexpr double of_unmoved_grid = 2.5;

/// Grids may agree on one number by chance. So no number errs by less than this share of the larger error of the judged
/// films. Without it X*, the rolling force and the Couette film were off by up to 10, 1.7 and 3.6 times what was
/// stated, at 6, 4 and 1 of 1,300 grids of 64 to 512 intervals.
/// The pressure maximum was off by up to 34 times on 63 and 80 intervals.
double share_of_films(std::size_t grids) { return grids > 2 ? 0.3 : 1; }

double at_least(double error, double least) { return std::isfinite(error) ? std::max(error, least) : least; }

void put_errors(const UniformClimb& climb, const Run& run, const SolveRecord& record, Observables& observables) {
  const double least = least_error(climb);
  const double film =
      observables.contains(Quantity::film_central) ? observables.at(Quantity::film_central).value : run.lengths.film;
  const double of_films = share_of_films(climb.grids.size()) *
                          std::max(record.film_minimum.discretisation, record.film_central.discretisation);
  const double offset_scale = 1 + film;  // H_0 is the film at X = 0 less a deflection of order one
  for (auto& [quantity, reading] : observables) {
    if (is_self_check(quantity)) continue;
    ErrorBudget budget = error_budget(climb, quantity, run.truncation);
    budget.discretisation = std::max(budget.discretisation, of_films * (has_absolute_error(quantity) ? film : 1));
    double error = budget.total();
    if (quantity == Quantity::film_minimum) error = record.film_minimum.total();
    if (quantity == Quantity::film_central) error = record.film_central.total();
    if (least > 0 && quantity == Quantity::film_couette) error = at_least(error, least);
    if (least > 0 && has_absolute_error(quantity)) error = at_least(error, least * offset_scale);
    if (has_absolute_error(quantity))  // the budget's other shares are relative
      error += truncation_of_offset * run.truncation * offset_scale + budget.iteration * (offset_scale - 1);
    if (std::isfinite(error)) reading.error = error;
  }
}

}  // namespace

double error_of_inlet_cells(double cells) { return 0.5 / (cells * cells); }

ErrorBudget error_budget(const UniformClimb& climb, Quantity quantity, double truncation) {
  double of_grids = discretisation_error(climb.grids, quantity);
  // Two grids may agree on one film by chance. H_cen of 64 and 128 intervals at (0.8625, 24.82), Barus, differed by a
  // quarter of its error.
  if (climb.grids.size() == 2 && std::ranges::count(judged_films, quantity) > 0)
    for (const Quantity film : judged_films) of_grids = std::max(of_grids, discretisation_error(climb.grids, film));
  const double least = quantity == Quantity::film_central ? roughness_at_centre(climb.fields) : 0;
  const bool unmoved = climb.grids.size() > 1 && climb.grids.back().newton_iterations == 0;
  return {.discretisation = std::max(of_grids, least),
          .iteration = climb.iteration * (unmoved ? of_unmoved_grid : 1),
          .truncation = truncation * (quantity == Quantity::rolling_force ? truncation_of_work : 1)};
}

void judge(const UniformClimb& climb, const Run& run, Solution& solution) {
  SolveRecord& record = solution.record;
  record.film_minimum = climb.film_minimum;
  record.film_central = climb.film_central;
  for (ErrorBudget* const film : {&record.film_minimum, &record.film_central})
    film->discretisation = at_least(film->discretisation, least_error(climb));
  solution.observables = climb.grids.back().observed;
  put_errors(climb, run, record, solution.observables);
  keep_known_pressures(solution.observables, run.problem.wanted, climb.fields,
                       values_of(climb.grids, Quantity::pressure_spike).size(), run.problem.groups.L, record.notes);
  keep_wanted(solution.observables, run.problem.wanted);
}

Ending ending_of(const UniformClimb& climb, const Run& run, const Request& request, const SolveRecord& record) {
  if (run.limit_reached) return limit_ending();
  if (climb.cells < fewest_inlet_cells)
    return {.status = StopReason::under_resolved,
            .reason = "the grid has fewer than 1.5 cells in the inlet zone of width H_cen^(2/3)"};
  if (climb.grids.empty()) return diverged_ending();
  if (climb.refused > 0)
    return {.status = StopReason::tolerance_not_met,
            .reason = fmt::format("Newton does not converge on {} intervals; the values are those of {}", climb.refused,
                                  climb.grids.back().nodes)};
  if (request.nodes) return given_grid_ending(record.film_minimum, record.film_central);
  if (!request.tolerance.met_by(record.film_minimum, record.film_central)) return tolerance_ending();
  return {.status = StopReason::converged};
}

}  // namespace ehd::fast
