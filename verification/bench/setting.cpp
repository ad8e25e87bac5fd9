// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/setting.hpp"

#include "contact/text.hpp"

namespace ehd::verification {

namespace {

/// Of the grid's own error: iterating further makes a run on a given grid dearer, not better.
constexpr double iteration_share_on_grids = 0.5;

}  // namespace

std::string Setting::text() const { return tolerance ? plain(*tolerance) : "n = " + std::to_string(nodes.value_or(0)); }

Request Setting::request(double time_limit_s) const {
  return {.tolerance = tolerance,
          .nodes = nodes,
          .iteration_share = nodes ? std::optional(iteration_share_on_grids) : std::nullopt,
          .time_limit_s = time_limit_s};
}

}  // namespace ehd::verification
