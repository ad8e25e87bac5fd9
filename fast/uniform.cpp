// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/uniform.hpp"

#include <utility>

#include "fast/run.hpp"
#include "fast/uniform_climb.hpp"
#include "fast/uniform_judgement.hpp"

namespace ehd::fast {

namespace {

/// Calibrated against reach 64 at 29 points of M = 0.3..4, L = 0..4, where the truncation is largest, and ten from
/// (0.05, 0) to (1000, 10), both law sets: reach 4 leaves at most 2.5e-6, reach 8 at most 2e-7, both at L = 0 and M
/// near 1.5. No flooded solve meets a tolerance below 3e-7.
constexpr FloodedInlet usual_inlet{.reach = 4, .truncation = 3e-6}, longer_inlet{.reach = 8, .truncation = 3e-7};
/// Below this tolerance the inlet is the longer one.
constexpr double longer_below = 2e-5;

FloodedInlet flooded_inlet(double tolerance) {
  return tolerance > 0 && tolerance < longer_below ? longer_inlet : usual_inlet;
}

}  // namespace

Solution Uniform::solve(const Problem& problem, const Request& request) const {
  Workspace workspace;
  return solve(problem, request, workspace);
}

Solution Uniform::solve(const Problem& problem, const Request& request, Workspace& workspace) const {
  workspace.grids.use(nullptr);
  Run run = begin_run(problem, request, workspace, flooded_inlet(request.tolerance.tightest()));
  UniformClimb climb = climb_uniform(run, request);

  Solution solution;
  SolveRecord& record = solution.record;
  if (!climb.grids.empty()) judge(climb, run, solution);
  auto [status, reason] = ending_of(climb, run, request, record);
  record.status = status;
  record.reason = std::move(reason);
  record.grids = std::move(climb.grids);
  solution.fields = std::move(climb.fields);
  solution.beside = std::move(climb.beside);
  fill_cost(record, run);
  return solution;
}

}  // namespace ehd::fast
