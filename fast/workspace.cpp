// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/workspace.hpp"

#include <algorithm>

namespace ehd::fast {

int Workspace::largest_grid() const {
  int most = 0;
  for (const auto& one : grids_seen_) most = std::max(most, one->n);
  return most;
}

Workspace::OnGrid& Workspace::on(int intervals) {
  for (const auto& one : grids_seen_) {
    if (one->n == intervals) return *one;
  }
  grids_seen_.push_back(std::make_unique<OnGrid>());
  grids_seen_.back()->n = intervals;
  return *grids_seen_.back();
}

}  // namespace ehd::fast
