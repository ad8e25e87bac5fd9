// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/mapped_ways.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "fast/mapped_climb.hpp"
#include "fast/mapped_start.hpp"

namespace ehd::fast {

namespace {

/// Reach 16 leaves at most 5.8e-9 at the points of uniform.cpp.
constexpr FloodedInlet flooded_inlet{.reach = 16, .truncation = 1e-8};
/// Milder neighbours, each reached from the next, before a solve gives up.
constexpr int most_neighbours = 5;
/// The tolerance of a neighbour's solution, which is a start only.
constexpr double neighbour_tolerance = 1e-2;

/// Films to this tolerance, or on more intervals than this, need fine tables.
constexpr double tight_tolerance = 1e-7;
/// Above this M the usual tables leave 1e-6 in H_min: 39 of 174 stated errors missed (M of 2e4..1e6, L of .1..3, asked
/// for 1e-5 to 1e-6). So fine tables are needed from this tolerance on.
constexpr double heavy_M = 2e4, tight_tolerance_heavy = 3e-5;
constexpr int many_intervals = 4096;

Tables tables_for(const Request& request, const Groups& groups) {
  const double tight = groups.M > heavy_M ? tight_tolerance_heavy : tight_tolerance;
  const bool fine = request.nodes ? *request.nodes > many_intervals : request.tolerance.tightest() <= tight;
  return fine ? Tables::fine : Tables::usual;
}

/// The same contact at half the load, below M = 1 at twice the load: the milder of the two.
Problem milder(const Problem& problem) {
  Problem other = problem;
  const Groups& groups = problem.groups;
  move_to(other, {.M = groups.M < 1 ? 2 * groups.M : groups.M / 2, .L = groups.L});
  return other;
}

/// The last resort, needed where a short inlet starves a light load: from the solution of a milder problem.
MappedClimb climb_from_milder(Run& run, const Request& request, int neighbours) {
  Request rough = request;
  rough.nodes.reset();
  rough.tolerance = neighbour_tolerance;
  const auto now = std::chrono::steady_clock::now();
  rough.time_limit_s = request.time_limit_s - std::chrono::duration<double>(now - run.begin).count();
  rough.max_iterations = request.max_iterations - static_cast<int>(run.counters.newton);
  const Problem other = milder(run.problem);
  const Care care = care_for(rough, other.groups);
  Run beside = begin_mapped(other, rough, run.workspace);
  const Solution neighbour{
      .fields = best_climb(beside, rough, care, nullptr, neighbours + 1).fields, .observables = {}, .record = {}};
  run.counters.add(beside.counters);
  if (neighbour.fields.X.size() == 0) return {};
  return climb_mapped(run, request, recipes[0], &neighbour, Care::full);
}

/// Climbs once more, from the solution of the first map, whose grids did not suffice.
void climb_with_more_care(Run& run, const Request& request, MappedClimb& best) {
  const Solution rough{.fields = best.fields, .observables = {}, .record = {}};
  MappedClimb climb = climb_mapped(run, request, recipes[0], &rough, Care::full);
  if (climb.complete) best = std::move(climb);
}

/// Enough nodes to interpolate between, and all fields on them.
bool usable(const Solution& start) {
  const auto nodes = start.fields.X.size();
  return nodes >= 4 && start.fields.P.size() == nodes && start.fields.H.size() == nodes;
}

}  // namespace

Run begin_mapped(const Problem& problem, const Request& request, Workspace& workspace) {
  Run run = begin_run(problem, request, workspace, flooded_inlet);
  run.tables = tables_for(request, problem.groups);
  return run;
}

MappedClimb best_climb(Run& run, const Request& request, Care care, const Solution* from, int neighbours) {
  MappedClimb best;
  if (from && usable(*from)) best = climb_mapped(run, request, recipes[0], from, care);
  const auto attempt = [&](int fineness) {
    for (Recipe recipe : recipes) {
      if (best.complete || run.limit_reached) return;
      recipe.fineness = fineness;
      MappedClimb climb = climb_mapped(run, request, recipe, nullptr, care);
      if (climb.complete || climb.grids.size() > best.grids.size()) best = std::move(climb);
    }
  };
  const bool thin = run.lengths.film < thin_film;
  if (thin) {
    std::ranges::for_each(finer_grids, attempt);
  } else {
    attempt(1);
  }
  if (care == Care::least && best.complete && !request.nodes && !met(best, request) && !run.limit_reached)
    climb_with_more_care(run, request, best);
  if (best.grids.empty() && !run.limit_reached && !run.problem.sources && neighbours < most_neighbours)
    best = climb_from_milder(run, request, neighbours);
  if (!thin) std::ranges::for_each(finer_grids, attempt);
  return best;
}

}  // namespace ehd::fast
