// SPDX-License-Identifier: GPL-3.0-or-later
// Work against precision: time and work of each solver over the error that it achieves, which is measured against a
// truth at least ten times more accurate.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "verification/bench/timing.hpp"
#include "verification/bench/work_rows.hpp"
#include "workflow/case.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

struct WorkPrecisionRequest {
  std::vector<Case> cases;  ///< lubricated contacts, see contacts_named
  std::vector<const RegisteredSolver*> solvers;
  bool quick = false;        ///< fewer tolerances and grids
  double time_limit_s = 30;  ///< for each solve
  Repetition repetition = {};
  std::function<void(const std::string&)> progress = {};
};

/// The cases of a full run, and of a quick one.
[[nodiscard]] std::vector<std::string> work_precision_cases(bool quick);
/// The settings of a solver: tolerances, then grids.
[[nodiscard]] std::vector<Setting> settings_of(const RegisteredSolver& solver, bool quick);
/// The error levels at which times are compared, falling.
[[nodiscard]] std::vector<double> error_levels(Judged judged);

struct WorkPrecisionResult {
  std::vector<Truth> truths;
  std::vector<WorkRow> rows;
  std::vector<std::string> solvers;
  /// CPU time over wall time of the whole run, which is one thread. Well below 1, other processes took time, and the
  /// measured times are too long by an unknown factor.
  double cpu_share = 1;
  double c_s = 0;  ///< one padded convolution of 512 intervals: the median of measurements before each case
  [[nodiscard]] bool anything_judged() const;
};

/// Reads cases by id or file; throws CaseError for one that cannot be read or is no lubricated contact.
[[nodiscard]] std::vector<Case> contacts_named(const std::vector<std::string>& names);
/// Throws CaseError for a bearing and for a dry contact.
void require_lubricated(const Case& one);

/// One thread. The rows of a case take turns, so that a slower machine slows all of them.
[[nodiscard]] WorkPrecisionResult run_work_precision(const WorkPrecisionRequest& request);

[[nodiscard]] Json to_json(const WorkPrecisionResult& result);
[[nodiscard]] std::string work_precision_csv(const WorkPrecisionResult& result);
[[nodiscard]] std::string human_table(const WorkPrecisionResult& result);

}  // namespace ehd::verification
