// SPDX-License-Identifier: GPL-3.0-or-later
// The topics of the suite, a file a topic. A new topic is one file here, one line below and one in suite.cpp.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "verification/claim.hpp"
#include "workflow/case.hpp"

namespace ehd::verification {

/// A piece of work that ends in claims. Topics run in threads side by side; each keeps its own state.
struct Topic {
  std::string name;
  std::set<int> rungs;       ///< that its claims stand on
  std::string case_id = {};  ///< the case that it is about; empty for none
  bool slow = false;         ///< left out with --quick
  std::function<Findings()> judge;
  double expected_s = 0;  ///< roughly, on one core, where more than a second; for the order and the time left
};

/// A case file: the case, or the error that reading gave.
struct LoadedCase {
  std::string id;  ///< the file's name where it could not be read
  std::variant<Case, CaseError> content;
};

[[nodiscard]] std::vector<Topic> input_topics();
[[nodiscard]] std::vector<Topic> oil_grade_topics();
[[nodiscard]] std::vector<Topic> law_topics();
[[nodiscard]] std::vector<Topic> property_topics();
[[nodiscard]] std::vector<Topic> kernel_topics();
[[nodiscard]] std::vector<Topic> exact_topics();
[[nodiscard]] std::vector<Topic> reynolds_topics();
[[nodiscard]] std::vector<Topic> coupled_topics();
[[nodiscard]] std::vector<Topic> iteration_topics();
[[nodiscard]] std::vector<Topic> twin_topics();
[[nodiscard]] std::vector<Topic> box_topics();
[[nodiscard]] std::vector<Topic> heavy_topics();
/// `runs` random runs for each law set and question; of fast five times as many points.
[[nodiscard]] std::vector<Topic> random_topics(int runs);
[[nodiscard]] std::vector<Topic> grid_topics();
[[nodiscard]] std::vector<Topic> truncation_topics();
[[nodiscard]] std::vector<Topic> stated_error_topics();
[[nodiscard]] std::vector<Topic> film_table_topics();
[[nodiscard]] std::vector<Topic> regime_topics();
[[nodiscard]] std::vector<Topic> response_topics();
[[nodiscard]] std::vector<Topic> response_motion_topics();
[[nodiscard]] std::vector<Topic> fast_response_topics();
[[nodiscard]] std::vector<Topic> atlas_topics();
[[nodiscard]] std::vector<Topic> atlas_motion_topics();
[[nodiscard]] std::vector<Topic> literature_topics();
/// A topic for each case in the list, bearings left out; a case that could not be read is a failing claim.
[[nodiscard]] std::vector<Topic> contact_topics(const std::vector<LoadedCase>& cases);
[[nodiscard]] std::vector<Topic> bearing_topics(const std::vector<LoadedCase>& cases);
/// Parts of NA4908 where it is in the list; both forms of balance of every bearing case.
[[nodiscard]] std::vector<Topic> bearing_part_topics(const std::vector<LoadedCase>& cases);

}  // namespace ehd::verification
