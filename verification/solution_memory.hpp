// SPDX-License-Identifier: GPL-3.0-or-later
// Solutions of one run of the suite: a problem that several topics give to one solver is solved once. Claims read
// fields and costs, which workflow/contact_cache.hpp drops after each solve; both have the same key.
//
// Do not use it for claims about repeated solves, about counters or times of a solver, or about random points, which
// never repeat.
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "contact/solution.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

/// Solutions by solver, problem and request. Threads may share a memory: two that ask for the same problem at the same
/// time both solve it.
class SolutionMemory {
 public:
  /// No further solution is kept once the fields take `most_bytes`.
  explicit SolutionMemory(double most_bytes) : most_bytes_(most_bytes) {}

  /// The solution from memory, or a new one. Not kept are problems with sources, which are functions, and solves that
  /// ended at a limit, because a limit of time depends on the machine.
  [[nodiscard]] Solution solve(const RegisteredSolver& solver, const Problem& problem, const Request& request);

  /// How many solutions were taken from memory.
  [[nodiscard]] long recalls() const;
  void forget();

 private:
  using Key = std::pair<std::string, std::vector<double>>;
  double most_bytes_, bytes_ = 0;
  long recalls_ = 0;
  std::map<Key, Solution> known_;
  mutable std::mutex mutex_;
};

/// The memory of the suite's run.
[[nodiscard]] SolutionMemory& run_memory();

/// A solver of workflow/registry by name, whose solve() asks that memory first.
[[nodiscard]] const RegisteredSolver& remembered(std::string_view name);

}  // namespace ehd::verification
