// SPDX-License-Identifier: GPL-3.0-or-later
// What would be computed and what is skipped, as data: made before anything runs, obeyed by what runs, and printed.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace ehd {

struct SkippedStage {
  std::string stage;
  std::string why;
};

struct Plan {
  std::vector<std::string> run;  ///< stages in order
  std::vector<SkippedStage> skipped;
  [[nodiscard]] bool runs(std::string_view stage) const {
    return std::find(run.begin(), run.end(), stage) != run.end();
  }
};

}  // namespace ehd
