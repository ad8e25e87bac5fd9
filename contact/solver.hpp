// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of a solver: a class with a static description and solve(problem, request) -> Solution.
#pragma once

#include <chrono>
#include <concepts>
#include <optional>
#include <string_view>

#include "contact/problem.hpp"
#include "contact/solution.hpp"

namespace ehd {

/// Either a tolerance (relative, on film.minimum and film.central), or a number of intervals, inlet to exit.
struct Request {
  std::optional<double> tolerance = 1e-3;
  std::optional<int> nodes = {};
  /// Used with `nodes`. The iteration ends where its estimated error of both films is this share of the discretisation
  /// error, which is expected from the coarser grids. Empty: the iteration goes on to round-off.
  std::optional<double> iteration_share = {};
  int max_iterations = 2000;  ///< Newton iterations over all grids
  double time_limit_s = 300;
};

struct SolverDescription {
  std::string_view name;     ///< "fast.uniform"
  std::string_view method;   ///< one sentence
  std::string_view cite;     ///< where the method comes from
  double formal_order = 0;   ///< of the films on smooth solutions
  double work_exponent = 0;  ///< run time ~ n^work_exponent
};

template <class S>
concept Solver = requires(const S solver, const Problem& problem, const Request& request) {
  { S::description } -> std::convertible_to<SolverDescription>;
  { solver.solve(problem, request) } -> std::same_as<Solution>;
};

}  // namespace ehd
