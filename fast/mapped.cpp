// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/mapped.hpp"

#include <utility>

#include "fast/mapped_judgement.hpp"
#include "fast/mapped_ways.hpp"

namespace ehd::fast {

namespace {

Solution solve_mapped(const Problem& problem, const Request& request, Workspace& workspace, const Solution* from) {
  Run run = begin_mapped(problem, request, workspace);
  MappedClimb climb = best_climb(run, request, care_for(request, problem.groups), from);

  Solution solution;
  SolveRecord& record = solution.record;
  if (!climb.grids.empty()) judge(climb, problem, solution);
  auto [status, reason] = ending_of(climb, run, request);
  record.status = status;
  record.reason = std::move(reason);
  record.grids = std::move(climb.grids);
  solution.fields = std::move(climb.fields);
  solution.beside = std::move(climb.beside);
  fill_cost(record, run);
  return solution;
}

}  // namespace

Solution Mapped::solve(const Problem& problem, const Request& request) const {
  Workspace workspace;
  return solve_mapped(problem, request, workspace, nullptr);
}

Solution Mapped::solve(const Problem& problem, const Request& request, Workspace& workspace) const {
  return solve_mapped(problem, request, workspace, nullptr);
}

Solution Mapped::solve(const Problem& problem, const Request& request, Workspace& workspace,
                       const Solution& start) const {
  return solve_mapped(problem, request, workspace, &start);
}

}  // namespace ehd::fast
