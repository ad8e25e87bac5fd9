// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hp/discretised.hpp"

#include <algorithm>
#include <cmath>

#include "contact/observables.hpp"
#include "reference/hp/steep_layer.hpp"

namespace ehd::reference::hp {

namespace {

/// Error of an extrapolated value over the distance of the extrapolation, where a third floor confirms the line.
constexpr double floor_safety = 0.2;
/// The same without a confirmation.
constexpr double unconfirmed_safety = 2;
/// Multiplies the bend that three floors show. Of H_min at (500, 8), Barus, cut at -3, floors of 1e-9 to 1e-8, the
/// value without the bend errs by 1.2 to 1.3 bends, and with it by a fifth to a third of one.
constexpr double bend_safety = 1.25;
/// Peaks grow like a logarithm of the floor, so that their extrapolation is worth little.
constexpr double peak_safety = 10;
/// Above this floor values are not taken to be linear in the floor, whatever three of them show.
constexpr double highest_linear_floor = 1e-6;
/// Above this floor a solution says nothing about the solution without a floor.
constexpr double highest_floor = 1e-5;

double slope_between(const AtFloor& a, const AtFloor& b) { return (b.value - a.value) / (b.floor - a.floor); }

/// What the bend through three floors adds to the line through the lower two at floor 0. The film under a spike has a
/// term b delta ln delta beside its line: its slope over [delta, r delta] is b (ln delta + r ln r/(r - 1)), and the
/// line misses the value at 0 by b delta r ln r/(r - 1).
double bend_at_zero(const AtFloor& lowest, const AtFloor& next, const AtFloor& third) {
  const auto excess = [](double r) { return r * std::log(r) / (r - 1); };
  const double r = next.floor / lowest.floor, s = third.floor / next.floor;
  const double change = slope_between(next, third) - slope_between(lowest, next);
  return lowest.floor * excess(r) * change / (std::log(r) + excess(s) - excess(r));
}

/// Largest minus smallest film within `distance` of X = 0, and at the next node on each side.
double change_around_centre(const Fields& fields, double distance) {
  const Array &X = fields.X, &H = fields.H;
  const auto first = std::max(std::lower_bound(X.begin(), X.end(), -distance) - X.begin() - 1, std::ptrdiff_t{0});
  const auto last = std::min(std::upper_bound(X.begin(), X.end(), distance) - X.begin(), X.size() - 1);
  const auto around = H.segment(first, last - first + 1);
  return around.maxCoeff() - around.minCoeff();
}

}  // namespace

double size_of(Quantity quantity, double value) { return has_absolute_error(quantity) ? 1 : std::abs(value); }

AtZero carried_to_zero(const std::vector<AtFloor>& floors) {
  const AtFloor &lowest = floors[0], &next = floors[1];
  const bool three = floors.size() > 2;
  // The slopes have two signs: the values differ because their meshes err, and not because of their floors.
  if (three && slope_between(lowest, next) * slope_between(next, floors[2]) < 0)
    return {.value = lowest.value,
            .error = std::max(std::abs(next.value - lowest.value), std::abs(floors[2].value - lowest.value))};
  const bool confirmed = three && lowest.floor <= highest_linear_floor;
  const double move = -lowest.floor * slope_between(lowest, next);
  const double bend = three ? bend_at_zero(lowest, next, floors[2]) : 0;
  return {.value = lowest.value + (confirmed ? move + bend : move),
          .error =
              std::max((confirmed ? floor_safety : unconfirmed_safety) * std::abs(move), bend_safety * std::abs(bend))};
}

namespace {

/// carried_to_zero() for the film at X = 0, which the steep layer passes or nears when the floor falls.
AtZero central_film_at_zero(const Discretised& done, std::vector<AtFloor> floors) {
  const std::vector<SteepPlace> places = places_apart(done.floors);
  const LayerPath path = *expected_path(places);
  if (floors.size() > 2 && is_at_centre(path, places.front())) floors.pop_back();
  const AtZero carried = carried_to_zero(floors);
  if (!is_at_centre(path, places.back())) return carried;
  const double change = change_around_centre(done.fields, unsettled_distance(path));
  return {.value = floors.front().value, .error = std::max(carried.error, change)};
}

}  // namespace

void carry_to_zero(const Problem& problem, const Wanted& wanted, Discretised& done) {
  const std::vector<std::size_t> apart = floors_apart(done.floors);
  if (done.last().floor == 0 || apart.size() < 2) return;
  std::vector<Observables> above;  // at most two more floors
  for (std::size_t k = 1; k < std::min<std::size_t>(apart.size(), 3); ++k)
    above.push_back(observe(fields_of(problem, done.floors[apart[k]]), wanted));
  for (auto& [quantity, reading] : done.seen) {
    if (is_self_check(quantity)) continue;
    std::vector<AtFloor> floors{{done.last().floor, reading.value}};
    for (std::size_t k = 0; k < above.size() && above[k].contains(quantity); ++k)
      floors.push_back({done.floors[apart[k + 1]].floor, above[k].at(quantity).value});
    if (floors.size() < 2) continue;
    AtZero zero = quantity == Quantity::film_central ? central_film_at_zero(done, floors) : carried_to_zero(floors);
    if (is_pressure_peak(quantity)) {
      zero.error = std::max(zero.error, peak_safety * std::abs(zero.value - reading.value));
      zero.value = reading.value;
    }
    if (done.last().floor > highest_floor) zero.error = std::max(zero.error, size_of(quantity, reading.value));
    done.floor_errors[quantity] = zero.error;
    reading.value = zero.value;
  }
}

}  // namespace ehd::reference::hp
