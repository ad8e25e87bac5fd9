// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/contact_cache.hpp"

#include <exception>
#include <optional>
#include <utility>
#include <variant>

namespace ehd {

namespace {

void append(std::vector<double>& key, const std::vector<double>& part) {
  key.insert(key.end(), part.begin(), part.end());
}

/// Two numbers, so that an absent value equals no present one.
template <class Number>
void append(std::vector<double>& key, const std::optional<Number>& value) {
  key.insert(key.end(), {value ? 1.0 : 0.0, value ? static_cast<double>(*value) : 0.0});
}

/// A visit: a new kind of inlet does not compile until it has a key.
struct InletKey {
  std::vector<double> operator()(const Flooded&) const { return {0}; }
  std::vector<double> operator()(const TruncatedAt& cut) const {
    const auto& [x] = cut;
    return {1, x};
  }
};

KeptSolution kept(const Solution& solution) {
  return {.status = solution.record.status, .reason = solution.record.reason, .observables = solution.observables};
}

}  // namespace

std::vector<double> solve_key(const Problem& problem, const Request& request) {
  // Structured bindings name every member: a struct that gets another one does not compile here.
  const auto& [groups, viscosity, density, inlet, wanted, sources] = problem;
  const auto& [M, L, lambda, alpha_p_H] = groups;
  const auto& [tolerance, nodes, iteration_share, max_iterations, time_limit_s] = request;
  static_cast<void>(sources);  // no caller keeps a problem with sources
  std::vector<double> key{M, L, lambda, alpha_p_H};
  append(key, cache_key(viscosity));
  append(key, cache_key(density));
  append(key, std::visit(InletKey{}, inlet));
  append(key, tolerance.minimum);
  append(key, tolerance.central);
  append(key, nodes);
  append(key, iteration_share);
  key.insert(key.end(), {static_cast<double>(max_iterations), time_limit_s});
  for (const Quantity quantity : wanted) key.push_back(static_cast<double>(quantity));
  return key;
}

ContactCache::ContactCache(ContactSolver solver, std::size_t most) : solver_(std::move(solver)), most_(most) {}

KeptSolution ContactCache::solve(const Problem& problem, const Request& request) {
  std::promise<KeptSolution> promise;
  {
    std::unique_lock lock(mutex_);
    if (!problem.sources) {
      std::vector<double> key = solve_key(problem, request);
      const auto at = known_.find(key);
      if (at != known_.end()) {
        ++recalls_;
        const std::shared_future<KeptSolution> coming = at->second;
        lock.unlock();
        return coming.get();
      }
      if (known_.size() < most_) known_.emplace(std::move(key), promise.get_future().share());
    }
    ++solves_;
  }
  try {
    KeptSolution solved = kept(solver_(problem, request));
    promise.set_value(solved);
    return solved;
  } catch (...) {
    promise.set_exception(std::current_exception());
    throw;
  }
}

long ContactCache::solves() const {
  const std::lock_guard lock(mutex_);
  return solves_;
}

long ContactCache::recalls() const {
  const std::lock_guard lock(mutex_);
  return recalls_;
}

}  // namespace ehd
