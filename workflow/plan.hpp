// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of a run, and the stages that are skipped with the reason. A plan is made before the run, and the run
// follows it. `ehd plan` prints it without a run.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ehd {

struct SkippedStage {
  std::string stage;
  std::string why;
};

struct Plan {
  std::vector<std::string> run;  ///< stages in order
  std::vector<SkippedStage> skipped;

  /// Puts a stage among those that run, or among the skipped ones where there is a reason to skip it.
  void decide(std::string stage, std::string why_skipped = "") {
    if (why_skipped.empty()) {
      run.push_back(std::move(stage));
    } else {
      skipped.push_back({std::move(stage), std::move(why_skipped)});
    }
  }
  [[nodiscard]] bool runs(std::string_view stage) const {
    return std::find(run.begin(), run.end(), stage) != run.end();
  }
};

}  // namespace ehd
