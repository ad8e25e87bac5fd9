// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hp/error_report.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "contact/text.hpp"

namespace ehd::reference::hp {

namespace {

/// Error over difference of the two discretisations. With 3, and with differences that the films do not share, 17 of
/// some 2000 error bars were too short in a review, by up to 4.4 times.
constexpr double discretisation_safety = 5;
/// The same on meshes of so many intervals and fewer, as light contacts with a cut inlet have. There both
/// discretisations may agree by chance, and every number has the films' differences. With the factor above and without
/// this 21 of 910 offsets, 9 rolling forces and 6 smallest films of 140 contacts were off by up to 7.3, 4.2 and 2.7
/// times what was stated (M of 0.001..10, L of 0..45, asked for 1e-4..1e-8), all at the level of 1e-9 and below.
constexpr int few_intervals = 100;
constexpr double safety_of_few = 15;
/// The same for the maximum and the spike of the pressure.
constexpr double peak_safety = 10;
/// Error over difference from the guide.
constexpr double guide_safety = 1.5;
/// A peak less certain than this is not reported.
constexpr double vaguest_peak = 0.05;

/// The largest relative differences of two discretisations. Numbers of one solution move together: a small difference
/// of one of them may be chance, and is no small error.
struct Differences {
  double films = 0, all = 0;
};

Differences differences(const Discretised& first, const Discretised& second) {
  Differences largest;
  for (const auto& [quantity, reading] : first.seen) {
    if (is_self_check(quantity) || is_pressure_peak(quantity) || !second.seen.contains(quantity)) continue;
    const double differ = std::abs(reading.value - second.seen.at(quantity).value) / size_of(quantity, reading.value);
    largest.all = std::max(largest.all, differ);
    if (is_film(quantity)) largest.films = std::max(largest.films, differ);
  }
  return largest;
}

/// The parts of the error of one quantity that both discretisations have.
ErrorBudget budget_of(Quantity quantity, const Reading& reading, const Discretised& first, const Discretised& second,
                      const Discretised* guide, const Differences& largest, double rounding) {
  const double size = size_of(quantity, reading.value), film = first.last().run.state.flux;
  const bool few = first.last().equations->intervals() <= few_intervals;
  const double safety = few ? safety_of_few : is_pressure_peak(quantity) ? peak_safety : discretisation_safety;
  ErrorBudget budget;
  budget.discretisation = safety * std::abs(reading.value - second.seen.at(quantity).value) / size;
  double shared = is_film(quantity) ? safety * largest.films : largest.all;
  if (few) shared = std::max(shared, safety * largest.films * (has_absolute_error(quantity) ? film : 1));
  budget.discretisation = std::max(budget.discretisation, shared);
  if (guide && guide->seen.contains(quantity))
    budget.discretisation =
        std::max(budget.discretisation, guide_safety * std::abs(reading.value - guide->seen.at(quantity).value) / size);
  budget.iteration = first.last().run.iteration_error + rounding;
  if (has_absolute_error(quantity)) budget.iteration *= film;
  if (first.last().floor > 0)
    budget.discretisation += first.floor_errors.contains(quantity) ? first.floor_errors.at(quantity) / size : 1;
  return budget;
}

}  // namespace

Solution report(const Problem& problem, const Discretised& first, const Discretised& second, const Discretised* guide,
                double rounding) {
  if (guide && guide->last().equations->intervals() <= first.last().equations->intervals()) guide = nullptr;
  const double floor = first.last().floor;
  const Differences largest = differences(first, second);
  Solution solution;
  solution.fields = first.fields;
  solution.beside = {pressure_alone(second.fields)};
  if (const auto apart = floors_apart(first.floors); floor > 0 && apart.size() > 1)
    solution.beside.push_back(pressure_alone(fields_of(problem, first.floors[apart[1]])));
  auto& record = solution.record;
  record.status = StopReason::converged;
  for (auto [quantity, reading] : first.seen) {
    if (is_self_check(quantity)) {
      if (problem.wanted.contains(quantity)) solution.observables[quantity] = reading;
      continue;
    }
    if (!second.seen.contains(quantity)) continue;
    const ErrorBudget budget = budget_of(quantity, reading, first, second, guide, largest, rounding);
    // A maximum behind the centre is the spike, or becomes the spike as the floor falls.
    const bool on_a_floor = floor > 0 && reading.place.value_or(0) > 0;
    if (is_pressure_peak(quantity) && (on_a_floor || !(budget.total() <= vaguest_peak))) {
      if (problem.wanted.contains(quantity))
        record.notes.push_back(std::string(to_string(quantity)) +
                               " omitted: the spike is not resolved. Try a smaller tolerance, or more nodes.");
      continue;
    }
    reading.error = budget.total();
    if (const auto parts = row_of(quantity).budget) record.*parts = budget;
    if (problem.wanted.contains(quantity)) solution.observables[quantity] = reading;
  }
  if (floor > 0)
    record.notes.push_back(
        "the descent ended at a fluidity floor of " + plain(floor, 2) +
        ": films are extrapolated to floor 0, and their errors include that; profiles are those of the floor");
  return solution;
}

}  // namespace ehd::reference::hp
