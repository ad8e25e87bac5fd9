// SPDX-License-Identifier: GPL-3.0-or-later
// The one store of solved contacts of bearings and sweeps. ContactMemory (contact_memory.hpp) asks it on behalf of a
// bearing, and a sweep shares it between rows and threads.
//
// The store counts its own solves; what a bearing reports is counted in its ContactMemory. A row of a sweep reports the
// contacts that it would solve alone, so that its numbers do not depend on the rows that were computed before it.
#pragma once

#include <cstddef>
#include <functional>
#include <future>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "contact/solver.hpp"

namespace ehd {

using ContactSolver = std::function<Solution(const Problem&, const Request&)>;

/// Problem and request as numbers; equal keys mean the same solve. Sources are functions and have no place in a key: a
/// caller keeps no problem that has some.
[[nodiscard]] std::vector<double> solve_key(const Problem& problem, const Request& request);

/// The part of a solution that the cache keeps: no fields.
struct KeptSolution {
  StopReason status = StopReason::diverged;
  std::string reason;
  Observables observables;
};

/// Solutions by problem and request. An equal problem with an equal request is solved once; other threads that ask for
/// it meanwhile wait. Safe to use from several threads.
class ContactCache {
 public:
  /// Contacts beyond the first `most` are solved but not kept. One contact takes some 600 bytes.
  explicit ContactCache(ContactSolver solver, std::size_t most = 1000000);

  /// Throws what the solver throws, now and whenever the same contact is asked for again. A problem with sources
  /// (manufactured solutions) is solved each time and not kept: sources are functions and cannot be compared.
  [[nodiscard]] KeptSolution solve(const Problem& problem, const Request& request);
  [[nodiscard]] long solves() const;   ///< calls of the function
  [[nodiscard]] long recalls() const;  ///< answers without a call

 private:
  ContactSolver solver_;
  std::size_t most_;
  mutable std::mutex mutex_;
  std::map<std::vector<double>, std::shared_future<KeptSolution>> known_;
  long solves_ = 0, recalls_ = 0;
};

}  // namespace ehd
