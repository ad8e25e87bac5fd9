// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_result.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ehd {

int loaded_rollers(const std::vector<RollerRow>& rollers) {
  double largest_N = 0;
  for (const RollerRow& row : rollers) largest_N = std::max(largest_N, row.inner.force_N);
  return static_cast<int>(std::count_if(rollers.begin(), rollers.end(), [&](const RollerRow& row) {
    return bearing::is_loaded(row.inner.force_N, largest_N);
  }));
}

std::optional<std::pair<double, double>> geometric_load_zone_deg(const BearingResult& result, double clearance_m) {
  constexpr double degrees = 180 / std::numbers::pi;
  const double along = result.displacement_m, across = result.displacement_lateral_m;
  const double moved = std::hypot(along, across), cosine = clearance_m / 2 / moved;
  if (!(moved > 0) || cosine >= 1) return std::nullopt;
  const double middle = std::atan2(across, along) * degrees, half = std::acos(std::max(cosine, -1.0)) * degrees;
  return std::pair(middle - half, middle + half);
}

}  // namespace ehd
