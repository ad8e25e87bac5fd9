// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the atlas share: a solver that solves nothing, and an atlas of six points.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "tests/files.hpp"
#include "verification/atlas/atlas.hpp"

namespace ehd::verification::made_atlas {

/// A value of each quantity that tells the problem and the quantity apart; the error is `relative` of it.
inline Solution made_solution(const Problem& problem, double relative) {
  Solution solution;
  solution.record.status = StopReason::converged;
  solution.record.cost.nodes = 320;
  solution.record.cost.wall_s = 0.25;
  const double base = 0.1 * problem.groups.M + 0.001 * problem.groups.L + 0.01 * M_E;
  double factor = 1;
  for (const Quantity quantity : all_quantities) {
    factor *= 1.1;
    Reading reading{.value = base * factor, .error = relative};
    if (quantity == Quantity::film_offset) reading = {.value = -base / M_PI, .error = relative / 7};  // absolute
    if (quantity == Quantity::pressure_spike) reading.place = 0.9 + base / 1e6;
    if (quantity == Quantity::pressure_spike && problem.groups.L == 0) continue;
    solution.observables[quantity] = reading;
  }
  GridRecord grid;
  grid.observed = solution.observables;
  solution.record.grids = {grid, grid};
  return solution;
}

/// Solves nothing; counts, and throws at the solve number `fails_at`. Solves of the version are not counted.
struct Fake {
  std::atomic<int> solves = 0, fails_at = 0;
  std::atomic<double> relative = 3e-11;

  [[nodiscard]] RegisteredSolver solver() {
    RegisteredSolver fake = *find_solver("reference");
    fake.name = "fake";
    fake.solve = [this](const Problem& problem, const Request& request) {
      const bool of_an_atlas = problem.groups.M != 0.7 && problem.groups.M != 7 && problem.groups.M != 15;
      if (of_an_atlas && ++solves == fails_at) throw std::runtime_error("interrupted");
      return made_solution(problem,
                           of_an_atlas ? std::max<double>(relative, request.tolerance.tightest() / 1e9) : 1e-9);
    };
    return fake;
  }
};

inline std::vector<AtlasPoint> few_points() {
  return {{AtlasLaws::isoviscous, 0.2, 0, Flooded{}}, {AtlasLaws::isoviscous, 50, 0, TruncatedAt{-4}},
          {AtlasLaws::barus, 2, 2.5, Flooded{}},      {AtlasLaws::barus, 20, 5, TruncatedAt{-4}},
          {AtlasLaws::roelands, 20, 10, Flooded{}},   {AtlasLaws::roelands, 1000, 30, TruncatedAt{-4}}};
}

inline AtlasRequest request_in(const test::Folder& folder) {
  return {.folder = folder.path() / "atlas", .points = few_points(), .only = {}, .threads = 2};
}

inline AtlasRecord record_of(const AtlasPoint& point) {
  Fake fake;
  return solve_point(point, fake.solver(), point.usual_tolerance(), 30);
}

}  // namespace ehd::verification::made_atlas
