// SPDX-License-Identifier: GPL-3.0-or-later
// The whole box of loads and materials by one solver: time, error achieved, error reported, at fixed settings.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "io/tables.hpp"
#include "verification/bench/timing.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

/// A place of the box, Roelands compressible.
struct BoxContact {
  double M = 0, L = 0;
  bool flooded = false;
  Problem problem;
};
/// M of 0.5 .. 5000 and L of 0 .. 30 with the inlet cut at -max(4, 4 sqrt(2 H_cen)) by Moes' film (104 contacts), the
/// same flooded from M = 0.05 (128); a few of them when quick.
[[nodiscard]] std::vector<BoxContact> box_contacts(bool quick);

/// What a solver is asked: a tolerance or a number of intervals (then iterated to half the grid's error).
struct BoxSetting {
  std::optional<double> tolerance;
  std::optional<int> nodes;
  [[nodiscard]] std::string text() const;
};
[[nodiscard]] std::vector<BoxSetting> box_settings();

struct BoxRow {
  std::string solver;
  BoxSetting setting;
  double M = 0, L = 0;
  bool flooded = false;
  std::string status;
  std::vector<double> wall_s;  ///< cold solves
  /// Relative, of H_min and H_cen; achieved and the truth's own error only where the truth is known.
  std::optional<double> reported[2], achieved[2], truth_error[2];
};

struct BoxRequest {
  std::vector<const RegisteredSolver*> solvers;
  std::vector<BoxContact> contacts;
  std::vector<BoxSetting> settings = box_settings();
  double truth_tolerance = 1e-8;  ///< asked of `truth`; what it then reports counts
  const RegisteredSolver* truth = nullptr;
  double time_limit_s = 30;
  unsigned threads = 2;  ///< of the truths; times are taken one after another
  Repetition repetition = {.least = 3, .least_s = 0.01};
  std::function<void(const std::string&)> progress = {};
};
[[nodiscard]] std::vector<BoxRow> run_box(const BoxRequest& request);

[[nodiscard]] Json to_json(const std::vector<BoxRow>& rows);
[[nodiscard]] std::string box_csv(const std::vector<BoxRow>& rows);
/// A line a solver, setting and inlet: how many converged, times, largest errors, how many within their bars.
[[nodiscard]] std::string human_table(const std::vector<BoxRow>& rows);

}  // namespace ehd::verification
