// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/registry.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "contact/interruption.hpp"
#include "fast/convolution.hpp"
#include "fast/mapped.hpp"
#include "fast/response.hpp"
#include "fast/uniform.hpp"
#include "reference/graded.hpp"
#include "reference/high_order.hpp"
#include "reference/hp/response.hpp"
#include "reference/uniform.hpp"
#include "workflow/deadline.hpp"

namespace ehd {

namespace {

/// Four dense N x N matrices of doubles: twice the kernel and the Jacobian, whose factors take its place.
double dense_memory(double N) { return 4 * 8 * N * N; }
/// Four dense matrices of the second discretisation, which has half as many intervals again.
double certified_memory(double N) { return 4 * 8 * 2.25 * N * N; }
/// Some hundred vectors of doubles on the finest grid, all levels, stages and Krylov directions together.
double vector_memory(double N) { return 200 * 8 * N; }

/// A thread keeps no workspace with a finer grid, which would hold more than 13 MB. Such a solve takes at least 13
/// times as long as a new workspace costs.
constexpr int largest_kept_grid = 8192;

struct Traits {
  double (*memory_bytes)(double intervals);
  bool uses_fft = false;
  bool is_default = false;
  bool certified = false;
  std::string_view twin_of = {};
  int look = 0;
  Response (*respond)(const Problem&, const ResponseRequest&) = nullptr;
  double response_tolerance = 0;
};

/// What a thread keeps between its solves. The second solve then plans nothing and allocates next to nothing. Its bits
/// are those of a first solve.
struct Kept {
  std::unique_ptr<fast::Workspace> workspace;

  template <class Work>
  auto use(const Work& work) {
    // Not kept while it is used: what an exception leaves behind is thrown away.
    std::unique_ptr<fast::Workspace> used = workspace ? std::move(workspace) : std::make_unique<fast::Workspace>();
    auto result = work(*used);
    if (used->largest_grid() <= largest_kept_grid) workspace = std::move(used);
    return result;
  }
};

/// What this thread keeps for the solver S.
template <class S>
Kept& kept() {
  thread_local Kept of_thread;
  return of_thread;
}

Response respond_fast(const Problem& problem, const ResponseRequest& request) {
  return kept<fast::Mapped>().use(
      [&](fast::Workspace& workspace) { return fast::response(problem, request, workspace); });
}

template <class S>
Solution solved_by(const S& solver, const Problem& problem, const Request& request) {
  if constexpr (requires(fast::Workspace & workspace) { solver.solve(problem, request, workspace); }) {
    return kept<S>().use([&](fast::Workspace& workspace) { return solver.solve(problem, request, workspace); });
  } else {
    return solver.solve(problem, request);
  }
}

/// Iterations end at the same place on every machine, a time limit or a caller does not: the reason says which it was.
void name_limit(StopReason status, std::string& reason, std::chrono::steady_clock::time_point begin, double limit_s) {
  if (status != StopReason::limit_reached) return;
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  if (reason.find(Deadline::out_of_time) != std::string::npos) return;
  if (passed.count() >= limit_s)
    reason += (reason.empty() ? "" : "; ") + std::string(Deadline::out_of_time);
  else if (interrupted())
    reason = interrupted_reason;
}

template <Solver S>
Solution solve_with(const Problem& problem, const Request& request) {
  const auto begin = std::chrono::steady_clock::now();
  Solution solution = solved_by(S(), problem, request);
  name_limit(solution.record.status, solution.record.reason, begin, request.time_limit_s);
  return solution;
}

template <Response (*respond)(const Problem&, const ResponseRequest&)>
Response respond_with(const Problem& problem, const ResponseRequest& request) {
  const auto begin = std::chrono::steady_clock::now();
  Response found = respond(problem, request);
  name_limit(found.status, found.reason, begin, request.time_limit_s);
  return found;
}

template <Solver S>
RegisteredSolver entry(const Traits& traits) {
  return {.name = std::string(S::description.name),
          .description = S::description,
          .solve = solve_with<S>,
          .uses_fft = traits.uses_fft,
          .memory_bytes = traits.memory_bytes,
          .is_default = traits.is_default,
          .certified = traits.certified,
          .twin_of = traits.twin_of,
          .look = traits.look,
          .respond = traits.respond,
          .response_tolerance = traits.response_tolerance};
}

/// The one row that has a trait.
const RegisteredSolver& the_one(bool RegisteredSolver::*trait) {
  const auto& list = solvers();
  return *std::find_if(list.begin(), list.end(), [trait](const RegisteredSolver& solver) { return solver.*trait; });
}

}  // namespace

const std::vector<RegisteredSolver>& solvers() {
  static const std::vector<RegisteredSolver> list{
      entry<reference::HighOrder>({.memory_bytes = certified_memory,
                                   .certified = true,
                                   .look = 1,
                                   .respond = respond_with<reference::hp::response>,
                                   .response_tolerance = 1e-8}),
      entry<reference::Graded>({.memory_bytes = dense_memory, .look = 3}),
      entry<reference::Uniform>({.memory_bytes = dense_memory, .look = 4}),
      entry<fast::Mapped>({.memory_bytes = vector_memory,
                           .uses_fft = true,
                           .is_default = true,
                           .look = 2,
                           .respond = respond_with<respond_fast>,
                           .response_tolerance = 1e-4}),
      entry<fast::Uniform>({.memory_bytes = vector_memory,
                            .uses_fft = true,
                            .twin_of = reference::Uniform::description.name,
                            .look = 5}),
  };
  return list;
}

const RegisteredSolver& default_solver() { return the_one(&RegisteredSolver::is_default); }
const RegisteredSolver& certified_solver() { return the_one(&RegisteredSolver::certified); }

std::vector<SolverTwins> solver_twins() {
  std::vector<SolverTwins> twins;
  for (const RegisteredSolver& solver : solvers())
    if (!solver.twin_of.empty()) twins.push_back({&solver, find_solver(solver.twin_of)});
  return twins;
}

const RegisteredSolver* find_solver(std::string_view name) {
  const auto& list = solvers();
  const auto at = std::find_if(list.begin(), list.end(), [&](const auto& solver) { return solver.name == name; });
  return at == list.end() ? nullptr : &*at;
}

std::string solver_names() {
  std::string names;
  for (const auto& solver : solvers()) names += (names.empty() ? "" : ", ") + solver.name;
  return names;
}

std::string responsive_solver_names() {
  std::string names;
  for (const auto& solver : solvers())
    if (solver.respond) names += (names.empty() ? "" : ", ") + solver.name;
  return names;
}

double available_memory_bytes() {
  double bytes = std::numeric_limits<double>::infinity();
  std::ifstream meminfo("/proc/meminfo");
  std::string key, unit;
  double kilobytes = 0;
  while (meminfo >> key >> kilobytes && std::getline(meminfo, unit)) {
    if (key == "MemAvailable:") bytes = kilobytes * 1024;
  }
  // A control group may allow less; "max" is no number and allows everything.
  double limit = 0, used = 0;
  std::ifstream limit_file("/sys/fs/cgroup/memory.max"), used_file("/sys/fs/cgroup/memory.current");
  if (limit_file >> limit && used_file >> used) bytes = std::min(bytes, std::max(limit - used, 0.0));
  return bytes;
}

bool measure_fft_plans(const std::string& wisdom) { return fast::measure_plans(wisdom); }

std::string learned_fft_plans() { return fast::measured_plans(); }

}  // namespace ehd
