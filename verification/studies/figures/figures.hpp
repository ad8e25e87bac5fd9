// SPDX-License-Identifier: GPL-3.0-or-later
// The data of the figures: profiles of the cases, convergence, maps over M and L, the bearing. They are computed beside
// the suite and written into results.json, so that making a report runs no solver. Nothing here is judged.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "io/json.hpp"
#include "workflow/deadline.hpp"

namespace ehd::verification {

struct FiguresRequest {
  /// 5: manufactured solutions; 8: grids; 10: cases and maps; 11: bearing; others: none; absent: all.
  std::optional<int> rung = {};
  std::optional<std::string> case_id = {};  ///< profiles (or the bearing) of this case alone
  bool quick = false;                       ///< few grids, few points of the maps, light cases
  unsigned threads = 0;                     ///< 0: as many as there are cores
  Deadline deadline = {};                   ///< solves end by then, and nothing is returned
  /// Called after each piece of work, one thread at a time.
  std::function<void(std::size_t done, std::size_t all, const std::string& name)> progress = {};
};

/// {"threads", "cases", "convergence", "maps", "bearing", "dynamics", "statements", "statement_study", "force_law"}; a
/// key is absent where its part was not made. "times": what the pieces of each part took, added up. "failed": a
/// sentence for each piece that threw (absent where none did). Times are of cold solves, one in a thread, while
/// `threads` of them share the machine. Throws CaseError for a named case that cannot be read. Null where the deadline
/// has passed.
[[nodiscard]] Json figures(const FiguresRequest& request);

}  // namespace ehd::verification
