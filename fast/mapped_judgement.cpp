// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/mapped_judgement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "contact/known_pressures.hpp"
#include "contact/observables.hpp"
#include "fast/extrapolation.hpp"
#include "fast/mapped_climb.hpp"

namespace ehd::fast {

namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

/// Relative film error of a lone grid of n intervals, times n^2. Calibrated on 464 problems (docs/fast-errors.md):
/// the largest error was 4e-2 at 64 intervals, 9e-3 at 128, 4e-3 at 256; on 16, 12 % at (20, 10) and 35 % at (1000,
/// 10).
constexpr double error_of_one_grid = 330;
/// Two or three coarse grids may agree by chance (M = 0.67, L = 26.5, 145 intervals: 2e-4 off at moves of 3e-5). With
/// fewer than `few_grids` the error is at least `least_of_few_grids`/n^2, except that of H_cen with a rule of its own.
constexpr std::size_t few_grids = 4;
constexpr double least_of_few_grids = 5;
/// Where the inlet is cut near the contact, both films have an error of at least `least_near_cut`/n^2 with fewer than
/// `few_grids`. At 300 contacts (M = 0.01..50, L = 1..45, cut at -2.5..-1.02) the other rules stated too small an error
/// for 167 of 6168 films of two and three grids, by a factor of 4.3 at most.
constexpr double nearest_usual_cut = -2.5, least_near_cut = 50;
/// Where the inlet is cut just before the contact, the error is at least `least`/n^2 with any number of grids. Of
/// 19,250 errors (M = 0.001..50, L = 0..30, cut at -2.5..-1.001, both laws, tolerances of 1e-2..1e-4) 1246 were too
/// small by the other rules, by a factor of 240 at most. The largest error times n^2 was 2082 beyond X = -1.05 and 267
/// beyond -1.2.
struct JustBefore {
  double cut, least;
};
constexpr JustBefore just_before[] = {{.cut = -1.05, .least = 2500}, {.cut = -1.2, .least = 350}};
/// The error rules were calibrated up to this M and L. Beyond, a film with L > 0.5 gets the rule for L of at least 15
/// on a map that is not settled, and that error is doubled (two grids: multiplied by four).
/// Measured at 300 contacts (M = 5e3..1e6, L = 0.5..10, both laws, tolerances of 1e-2..1e-5): without this 93 of 8600
/// errors were too small, by a factor of 47 at most; with it one is, by 1.02. At 100 other contacts up to L = 100 one
/// of 800 errors was too small, by 1.4 (L = 74). At M up to 5000 and L = 30..100 some 65 of 6300 were, by 1.6 at most,
/// before L counted too. Two grids: beyond M = 3.8e5 and L = 80 the error was twice the doubled one.
constexpr double calibrated_M = 5000, calibrated_L = 30, uncalibrated_safety = 2, uncalibrated_safety_of_two = 4;
/// Nearly isoviscous oil, two grids: H_min errs about as much as the films last moved. So its error is at least this
/// factor times the larger last move of the two films. At 45 contacts of M = 1e3..1e6 and L = 0 the error was 0.6 to
/// 0.8 of that move, at two of them 1.3; at 60 contacts of L > 0.5 at most 0.6.
constexpr double nearly_isoviscous_L = 0.5, of_two_isoviscous = 1.5;
/// Beside a narrow spike the error of two grids is up to 1.15 times the larger last move (M = 390..480, L = 17..30,
/// Barus). So beyond L = 15 the error of H_min is at least this factor times that move.
constexpr double of_two_narrow = 1.2;
/// Where H_cen is above `thick_film`, both films have nearly the same error, and the larger of both errors is stated
/// for H_cen. Without this H_cen missed its stated error by up to 2.5 times at four contacts (M = 0.027..0.054, L
/// = 2..10, cut at -6..-10, 510 to 770 intervals).
constexpr double thick_film = 10;
/// Rolling force: the work at a spike does not converge as the films do. So its error, which is at least the films'
/// share, is multiplied by this factor. On two grids that both miss the spike the work is nearly the same. Of 3114
/// errors on 128 to 4000 intervals (M of 0.05..5000, L of 0.5..30, three laws, flooded and cut) 4 are too small, by a
/// factor of 2.5 at most. With 3, and without the films' share, 40 were, by 6.4 at most. Beyond calibrated_M or
/// calibrated_L it is doubled as the films' error is: at M of 1e4..1e5 with a cut of -1.1..-4 two of some 500 errors
/// were too small by 1.3 and 1.7.
constexpr double work_safety = 6;
/// From this number of grids on each film has an error rule of its own.
constexpr std::size_t fewest_for_own_rule = 3;
/// The last five grids determine the limit and its error. A coarser grid on which Newton stalled does not matter: at
/// (2000, 30) flooded Newton left 5e-4 on 1024 intervals, while the last grid had 65,536.
constexpr std::ptrdiff_t grids_that_count = 5;

/// A quantity on the grids, moved to exactly N, N/2, N/4, … intervals.
std::vector<double> values_on_halves(const std::vector<GridRecord>& grids, Quantity quantity) {
  std::vector<double> values = values_of(grids, quantity);
  if (values.empty()) return values;
  std::vector<int> intervals;
  for (auto grid = grids.end() - std::ssize(values); grid != grids.end(); ++grid) intervals.push_back(grid->nodes);
  return on_exact_halves(std::move(values), intervals);
}

/// The limit of a quantity; empty where the finest grid lacks it.
std::optional<Limit> limit_on(const std::vector<GridRecord>& grids, Quantity quantity) {
  const std::vector<double> values = values_on_halves(grids, quantity);
  if (values.empty()) return std::nullopt;
  Limit limit = limit_of(values);
  // A spike passes between nodes. So its height does not converge as the films do, and its error is at least the last
  // moves. Without them 97 % of the pressure maxima and 90 % of the spikes of 102 problems were within their errors.
  if (is_pressure_peak(quantity)) limit.error = std::max(limit.error, error_of_moves(values));
  return limit;
}

double relative_error(const std::vector<GridRecord>& grids, Quantity quantity) {
  const auto limit = limit_on(grids, quantity);
  return limit ? limit->error / std::abs(limit->value) : unknown;
}

/// Relative discretisation error of a film, from its values on the grids. With two grids it is at least a share of the
/// larger error of both films.
double error_by_grids(const std::vector<GridRecord>& grids, Quantity film, MapFit fit, double L) {
  const double n = grids.back().nodes;
  if (grids.size() == 1) return error_of_one_grid / (n * n);
  const double least = grids.size() < few_grids ? least_of_few_grids / (n * n) : 0;
  const std::vector<double> smallest = values_on_halves(grids, Quantity::film_minimum),
                            at_centre = values_on_halves(grids, Quantity::film_central);
  if (grids.size() >= fewest_for_own_rule) {
    const double of_smallest = std::max(smallest_film_error(smallest, at_centre, fit, L, grids.back().nodes), least);
    if (film == Quantity::film_minimum) return of_smallest;
    if (at_centre.size() == grids.size()) {
      const double of_central = central_film_error(at_centre, smallest, fit, L);
      return at_centre.back() > thick_film ? std::max(of_central, of_smallest) : of_central;
    }
  }
  const double minimum = relative_error(grids, Quantity::film_minimum);
  const double central = relative_error(grids, Quantity::film_central);
  const double own = film == Quantity::film_minimum ? minimum : central;
  // Without X = 0 on the grid there is no central film.
  const double largest = std::isfinite(central) ? std::max(minimum, central) : minimum;
  double share = shared(grids.size());
  if (film == Quantity::film_minimum && grids.size() == 2)
    share = L <= nearly_isoviscous_L ? of_two_isoviscous : L > mild_L ? of_two_narrow : share;
  return std::max({own, share * largest, least});
}

/// The least error of a film times n^2, which depends on where the inlet is cut.
double least_by_cut(const Problem& problem, std::size_t grids) {
  const auto* const cut = std::get_if<TruncatedAt>(&problem.inlet);
  if (!cut) return 0;
  for (const JustBefore& one : just_before)
    if (cut->x > one.cut) return one.least;
  return grids < few_grids && is_cut_near_the_contact(problem) ? least_near_cut : 0;
}

/// Relative discretisation error of a film.
double film_discretisation(const MappedClimb& climb, Quantity film, const Problem& problem) {
  const double L = problem.groups.L;
  const std::vector<GridRecord>& grids = climb.grids;
  double error = is_calibrated(problem.groups)
                     ? error_by_grids(grids, film, climb.fit, L)
                     : (grids.size() == 2 ? uncalibrated_safety_of_two : uncalibrated_safety) *
                           error_by_grids(grids, film, MapFit::again, std::max(L, mild_L));
  error = std::max(error, least_by_cut(problem, grids.size()) / std::pow(grids.back().nodes, 2));
  if (film == Quantity::film_central) return std::max(error, roughness_at_centre(climb.fields));
  return is_trivial(problem.density)
             ? error
             : std::max(error,
                        compressible_film_error(values_on_halves(grids, Quantity::film_minimum), grids.back().nodes));
}

/// The error of one quantity. `of_films`: relative, the least error of every quantity but the spike; `film`: H_cen.
ErrorBudget budget_of(const MappedClimb& climb, const Groups& groups, Quantity quantity,
                      const std::optional<Limit>& limit, double of_films, double film) {
  if (quantity == Quantity::film_minimum) return climb.film_minimum;
  if (quantity == Quantity::film_central) return climb.film_central;
  const bool absolute = has_absolute_error(quantity);
  const double scale = absolute ? 1 + std::abs(film) : 1;  // H_0 is the film at X = 0 less a deflection of order one
  ErrorBudget budget = climb.film_central;
  budget.iteration *= scale;
  budget.truncation *= scale;
  budget.discretisation = limit ? limit->error / (absolute ? 1 : std::abs(limit->value)) : unknown;
  // The exit and the pressure maximum move as the films do; the spike has a rule of its own.
  if (quantity != Quantity::pressure_spike) budget.discretisation = std::max(budget.discretisation, of_films * scale);
  if (quantity == Quantity::rolling_force) {
    budget.discretisation *= work_safety * (is_calibrated(groups) ? 1 : uncalibrated_safety);
    budget.truncation *= truncation_of_work;
  }
  if (absolute) budget.truncation *= truncation_of_offset;
  return budget;
}

}  // namespace

bool is_cut_near_the_contact(const Problem& problem) {
  const auto* const cut = std::get_if<TruncatedAt>(&problem.inlet);
  return cut && cut->x > nearest_usual_cut;
}

bool is_calibrated(const Groups& groups) {
  return (groups.M <= calibrated_M && groups.L <= calibrated_L) || groups.L <= nearly_isoviscous_L;
}

double iteration_error(const MappedClimb& climb) {
  const auto last = std::min(std::ssize(climb.left), grids_that_count);
  return *std::max_element(climb.left.end() - last, climb.left.end());
}

ErrorBudget film_budget(const MappedClimb& climb, Quantity film, const Run& run) {
  return {.discretisation = film_discretisation(climb, film, run.problem),
          .iteration = iteration_error(climb),
          .truncation = run.truncation};
}

void judge(const MappedClimb& climb, const Problem& problem, Solution& solution) {
  SolveRecord& record = solution.record;
  record.film_minimum = climb.film_minimum;
  record.film_central = climb.film_central;
  Observables& observables = solution.observables;
  observables = climb.grids.back().observed;
  const std::size_t grids = climb.grids.size();
  const double of_films =
      shared(grids) * std::max(climb.film_minimum.discretisation, climb.film_central.discretisation);
  const auto central = limit_on(climb.grids, Quantity::film_central);
  for (auto& [quantity, reading] : observables) {
    if (is_self_check(quantity)) continue;
    const auto limit = limit_on(climb.grids, quantity);
    if (grids > 1 && limit) reading.value = limit->value;
    reading.error = budget_of(climb, problem.groups, quantity, limit, of_films, central ? central->value : 1).total();
    if (!std::isfinite(*reading.error)) reading.error.reset();
  }
  keep_known_pressures(observables, problem.wanted, climb.fields, grids, problem.groups.L, record.notes);
  keep_wanted(observables, problem.wanted);
}

Ending ending_of(const MappedClimb& climb, const Run& run, const Request& request) {
  if (run.limit_reached) return limit_ending();
  if (climb.grids.empty()) return diverged_ending();
  if (!climb.complete)
    return {.status = StopReason::tolerance_not_met,
            .reason = "Newton does not converge beyond " + std::to_string(climb.grids.back().nodes) + " intervals"};
  if (request.nodes) return given_grid_ending(climb.film_minimum, climb.film_central);
  if (!met(climb, request)) return tolerance_ending();
  return {.status = StopReason::converged};
}

}  // namespace ehd::fast
