// SPDX-License-Identifier: GPL-3.0-or-later
// What the first solve of a process costs beside a later one: FFT planning, new memory, first use of the program.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "contact/conditions.hpp"
#include "io/json.hpp"
#include "verification/bench/timing.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

/// Times are processor times [s]; planning_s, which the solver measures itself, and c_s are wall times.
struct FirstSolveRow {
  std::string solver;
  MoesGroups contact;
  double tolerance = 0;
  std::string why;  ///< where nothing was measured
  double first_s = 0;
  double planning_s = 0;  ///< within the first
  double later_s = 0;     ///< median of solves in the same thread
  double c_s = 0;         ///< one padded convolution of 512 intervals
};

struct FirstSolveRequest {
  std::vector<const RegisteredSolver*> solvers;
  std::vector<MoesGroups> contacts = {{5, 5}, {20, 10}, {200, 15}};
  double tolerance = 1e-3;
  double time_limit_s = 30;
  Repetition repetition = {};
  std::function<void(const std::string&)> progress = {};
};

/// Each contact in a child of its own. This process must not have planned a transform yet, since a child begins with
/// what its parent has learned.
[[nodiscard]] std::vector<FirstSolveRow> run_first_solves(const FirstSolveRequest& request);

[[nodiscard]] Json to_json(const std::vector<FirstSolveRow>& rows);
[[nodiscard]] std::string human_table(const std::vector<FirstSolveRow>& rows);

}  // namespace ehd::verification
