// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/judgement.hpp"

#include <utility>

#include "contact/stated_error.hpp"

namespace ehd::fast {

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

Ending limit_ending() {
  return {.status = StopReason::limit_reached, .reason = "the limit on iterations or time was reached"};
}

Ending diverged_ending() {
  return {.status = StopReason::diverged, .reason = "Newton found no admissible solution from any start"};
}

Ending tolerance_ending() {
  return {.status = StopReason::tolerance_not_met,
          .reason = "the finest grid's estimated error is above the tolerance"};
}

Ending given_grid_ending(const ErrorBudget& minimum, const ErrorBudget& central) {
  if (auto reason = too_coarse(minimum, central))
    return {.status = StopReason::under_resolved, .reason = std::move(*reason)};
  return {.status = StopReason::converged};
}

}  // namespace ehd::fast
