// SPDX-License-Identifier: GPL-3.0-or-later
// What several topics need: numbers read off a solution, how a solve ended, and tolerances with one reason.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "contact/solution.hpp"
#include "fast/state.hpp"
#include "verification/claim.hpp"
#include "workflow/case.hpp"

namespace ehd::verification {

/// Stands for a number that could not be measured. No claim passes with it.
inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// The isoviscous elastic limit, film x M^(1/5), as README.md prints it: of the Couette film and of the smallest.
inline constexpr const char *couette_limit = "2.489479", *smallest_limit = "1.982128";

[[nodiscard]] inline bool converged(const Solution& solution) {
  return solution.record.status == StopReason::converged;
}

/// "converged", "tolerance-not-met: …".
[[nodiscard]] inline std::string how_it_ended(const Solution& solution) {
  return std::string(to_string(solution.record.status)) +
         (solution.record.reason.empty() ? "" : ": " + solution.record.reason);
}

/// Null where the quantity was not observed.
[[nodiscard]] inline const Reading* observed(const Observables& observables, Quantity quantity) {
  const auto at = observables.find(quantity);
  return at == observables.end() ? nullptr : &at->second;
}
[[nodiscard]] inline const Reading* observed(const Solution& solution, Quantity quantity) {
  return observed(solution.observables, quantity);
}

/// The same, and null where the solve did not converge: it measures nothing.
[[nodiscard]] inline const Reading* reading(const Solution& solution, Quantity quantity) {
  return converged(solution) ? observed(solution, quantity) : nullptr;
}

[[nodiscard]] inline double value_of(const Reading* seen) { return seen ? seen->value : nothing; }
[[nodiscard]] inline double place_of(const Reading* seen) { return seen ? seen->place.value_or(nothing) : nothing; }
[[nodiscard]] inline double error_of(const Reading* seen) { return seen ? seen->error.value_or(nothing) : nothing; }

/// A film for which every solver states an error.
[[nodiscard]] inline bool is_judged_film(const Expectation& expectation) {
  return std::any_of(judged_films.begin(), judged_films.end(),
                     [&](Quantity film) { return expectation.quantity == to_string(film); });
}

/// A dozen products, roots and powers of inputs that are known to half a unit of their last bit.
[[nodiscard]] inline Tolerance rounding() { return Tolerance::round_off(64); }

[[nodiscard]] inline Tolerance order_over_four_grids() {
  return Tolerance::calibrated(0.1, "fitted orders over four grids are read to a tenth");
}

/// How a problem looks to the parts of fast/, without a flooded inlet's tail.
[[nodiscard]] inline fast::Setting setting_of(const Problem& problem, double inlet) {
  return {.groups = problem.groups,
          .viscosity = problem.viscosity,
          .density = problem.density,
          .inlet = inlet,
          .sources = problem.sources};
}

}  // namespace ehd::verification
