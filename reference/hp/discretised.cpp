// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hp/discretised.hpp"

#include <algorithm>
#include <cmath>

#include "contact/observables.hpp"

namespace ehd::reference::hp {

namespace {

/// Error of an extrapolated value over the distance of the extrapolation, where a third floor confirms the line.
constexpr double floor_safety = 0.2;
/// The same without a confirmation.
constexpr double unconfirmed_safety = 2;
/// Multiplies what the curvature through three floors would change.
constexpr double curvature_safety = 3;
/// Peaks grow like a logarithm of the floor, so that their extrapolation is worth little.
constexpr double peak_safety = 10;
/// Above this floor values are not taken to be linear in the floor, whatever three of them show.
constexpr double highest_linear_floor = 1e-6;
/// Above this floor a solution says nothing about the solution without a floor.
constexpr double highest_floor = 1e-5;

}  // namespace

double size_of(Quantity quantity, double value) { return has_absolute_error(quantity) ? 1 : std::abs(value); }

void carry_to_zero(const Problem& problem, const Wanted& wanted, Discretised& done) {
  const auto apart = floors_apart(done.floors);
  if (done.last().floor == 0 || apart.size() < 2) return;
  const auto seen_at = [&](std::size_t k) { return observe(fields_of(problem, done.floors[apart[k]]), wanted); };
  const bool three = apart.size() > 2;
  const double f0 = done.last().floor, f1 = done.floors[apart[1]].floor;
  const Observables one = seen_at(1), two = three ? seen_at(2) : Observables{};
  for (auto& [quantity, reading] : done.seen) {
    if (is_self_check(quantity) || !one.contains(quantity)) continue;
    const double slope = (one.at(quantity).value - reading.value) / (f1 - f0), move = -f0 * slope;
    const bool confirmed = three && f0 <= highest_linear_floor;
    double error = confirmed ? floor_safety * std::abs(move) : unconfirmed_safety * std::abs(move);
    if (three && two.contains(quantity)) {
      const double f2 = done.floors[apart[2]].floor;
      const double further = (two.at(quantity).value - one.at(quantity).value) / (f2 - f1);
      error = std::max(error, curvature_safety * std::abs(f0 * f1 * (further - slope) / (f2 - f0)));
    }
    if (is_pressure_peak(quantity)) error = std::max(error, peak_safety * std::abs(move));
    if (f0 > highest_floor) error = std::max(error, size_of(quantity, reading.value));
    done.floor_errors[quantity] = error;
    if (!is_pressure_peak(quantity)) reading.value += move;
  }
}

}  // namespace ehd::reference::hp
