// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/stated_error.hpp"

#include <algorithm>
#include <cmath>

namespace ehd {

std::optional<double> field_error(const Solution& solution) {
  if (solution.fields.X.size() == 0) return std::nullopt;
  double largest = 0;
  for (const Quantity film : judged_films) {
    const auto reported = solution.observables.find(film);
    const auto on_grid = row_of(film).observe(solution.fields);
    if (reported == solution.observables.end() || !reported->second.error || !on_grid) return std::nullopt;
    const Reading& best = reported->second;
    largest = std::max(largest, std::abs(on_grid->value / best.value - 1) + *best.error);
  }
  return largest;
}

}  // namespace ehd
