// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_result.hpp"

#include <algorithm>

namespace ehd {

int loaded_rollers(const std::vector<RollerRow>& rollers) {
  double largest_N = 0;
  for (const RollerRow& row : rollers) largest_N = std::max(largest_N, row.inner.force_N);
  return static_cast<int>(std::count_if(rollers.begin(), rollers.end(), [&](const RollerRow& row) {
    return bearing::is_loaded(row.inner.force_N, largest_N);
  }));
}

}  // namespace ehd
