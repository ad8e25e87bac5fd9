// SPDX-License-Identifier: GPL-3.0-or-later
// The whole box of loads and materials at fixed settings: time, achieved error and reported error of each solver.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "verification/bench/setting.hpp"
#include "verification/bench/timing.hpp"
#include "verification/studies/box.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

/// Roelands, compressible, unless `roelands` says otherwise. M of 0.5 ... 5000 and L of 0 ... 30 with the inlet cut at
/// -max(4, 4 sqrt(2 H_cen)), H_cen by Moes' formula (104 contacts); the same flooded from M = 0.05 (128 contacts); a
/// few of them when quick.
[[nodiscard]] std::vector<BoxContact> bench_contacts(bool quick, std::vector<bool> roelands = {true});

/// Two tolerances and two numbers of intervals, for every solver.
[[nodiscard]] std::vector<Setting> box_settings();

struct BoxRow {
  Setting setting;
  BoxContact contact;
  std::string status = {};
  std::vector<double> wall_s = {};  ///< cold solves
  /// Relative, of H_min and H_cen; `achieved` and `truth_error` (of the truth itself) only where the truth is known.
  std::optional<double> reported[2] = {}, achieved[2] = {}, truth_error[2] = {};
};

struct BoxRequest {
  std::vector<const RegisteredSolver*> solvers;
  std::vector<BoxContact> contacts;
  std::vector<Setting> settings = box_settings();
  double truth_tolerance = 1e-8;            ///< asked of `truth`
  const RegisteredSolver* truth = nullptr;  ///< without one, no errors are judged
  double time_limit_s = 30;
  unsigned threads = 2;  ///< of the truths; times are taken one after another
  Repetition repetition = {.least = 3, .least_s = 0.01};
  std::function<void(const std::string&)> progress = {};
};
[[nodiscard]] std::vector<BoxRow> run_box_bench(const BoxRequest& request);

[[nodiscard]] Json to_json(const std::vector<BoxRow>& rows);
[[nodiscard]] std::string box_csv(const std::vector<BoxRow>& rows);
/// A line for each solver, setting and inlet: converged solves, times, largest errors, and how many achieved errors are
/// within the reported ones.
[[nodiscard]] std::string human_table(const std::vector<BoxRow>& rows);

}  // namespace ehd::verification
