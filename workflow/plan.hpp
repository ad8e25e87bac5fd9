// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of a run, and the stages that are skipped with the reason. A plan is made before the run; the run follows
// it, and the plan can be printed without a run.
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
