// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of a solver: a class with a static description and solve(problem, request) -> Solution.
#pragma once

#include <algorithm>
#include <chrono>
#include <concepts>
#include <limits>
#include <optional>
#include <string_view>

#include "contact/problem.hpp"
#include "contact/solution.hpp"

namespace ehd {

/// Relative errors allowed in film.minimum and film.central. A film without a tolerance may have any error, which is
/// reported. By default neither has one; `Request` sets 1e-3 for both.
struct FilmTolerances {
  std::optional<double> minimum, central;

  constexpr FilmTolerances() = default;
  constexpr FilmTolerances(double both) : minimum(both), central(both) {}
  constexpr FilmTolerances(std::optional<double> both) : minimum(both), central(both) {}
  constexpr FilmTolerances(std::optional<double> of_minimum, std::optional<double> of_central)
      : minimum(of_minimum), central(of_central) {}

  [[nodiscard]] constexpr bool any() const { return minimum || central; }
  /// The smaller one; 0 where nothing is asked for.
  [[nodiscard]] constexpr double tightest() const {
    if (!any()) return 0;
    constexpr double not_asked = std::numeric_limits<double>::infinity();
    return std::min(minimum.value_or(not_asked), central.value_or(not_asked));
  }
  /// Both films meet the tolerances that are asked for.
  [[nodiscard]] bool met_by(const ErrorBudget& of_minimum, const ErrorBudget& of_central) const {
    return any() && !(minimum && !(of_minimum.total() <= *minimum)) && !(central && !(of_central.total() <= *central));
  }
  [[nodiscard]] constexpr bool operator==(const FilmTolerances&) const = default;
};

/// Either tolerances, or a number of intervals, inlet to exit.
struct Request {
  FilmTolerances tolerance = 1e-3;
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
