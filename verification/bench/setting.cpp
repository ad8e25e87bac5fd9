// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/text.hpp"

namespace ehd::verification {

namespace {

/// Share of the grid's error. Further iteration costs time and does not make the films on that grid more accurate.
constexpr double iteration_share_on_grids = 0.5;

}  // namespace

const Reading* reading_of(const Solution& solution, Quantity quantity) {
  const auto at = solution.observables.find(quantity);
  return at == solution.observables.end() || !std::isfinite(at->second.value) ? nullptr : &at->second;
}

std::string Setting::text() const { return tolerance ? plain(*tolerance) : fmt::format("n = {}", nodes.value_or(0)); }

Request Setting::request(double time_limit_s) const {
  return {.tolerance = tolerance,
          .nodes = nodes,
          .iteration_share = nodes ? std::optional(iteration_share_on_grids) : std::nullopt,
          .time_limit_s = time_limit_s};
}

double stated_error(const Solution& solution) {
  double worst = 0;
  const bool ended =
      solution.record.status == StopReason::converged || solution.record.status == StopReason::tolerance_not_met;
  for (std::size_t which = 0; which < 2; ++which) {
    const Reading* reading = reading_of(solution, judged_films[which]);
    if (!ended || !reading || !reading->error) return std::numeric_limits<double>::infinity();
    worst = std::max(worst, *reading->error);
  }
  return worst;
}

}  // namespace ehd::verification
