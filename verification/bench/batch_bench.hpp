// SPDX-License-Identifier: GPL-3.0-or-later
// Many contacts over threads: the speed-up, and whether the results stay the same.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

/// Contacts of the box M 2 … 500, L 2.5 … 15, both law sets, cut at X = -4 and flooded; a few of them when quick.
[[nodiscard]] std::vector<Problem> batch_problems(bool quick);

struct BatchRow {
  std::string solver;
  double tolerance = 0;
  std::size_t problems = 0, converged = 0;
  unsigned threads = 1;
  std::vector<double> wall_s;  ///< of the whole batch
  double speed_up = 1;         ///< against one thread, medians
  bool same_results = true;    ///< as with one thread, bit for bit
};

struct BatchRequest {
  std::vector<const RegisteredSolver*> solvers;
  std::vector<Problem> problems;
  double tolerance = 1e-3;
  double time_limit_s = 30;
  std::vector<unsigned> threads = {1, 2};  ///< the others are compared with the first
  int rounds = 3;                          ///< the numbers of threads take turns
  std::function<void(const std::string&)> progress = {};
};
[[nodiscard]] std::vector<BatchRow> run_batch(const BatchRequest& request);

[[nodiscard]] Json to_json(const std::vector<BatchRow>& rows);
[[nodiscard]] std::string human_table(const std::vector<BatchRow>& rows);

}  // namespace ehd::verification
