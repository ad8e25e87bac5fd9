// SPDX-License-Identifier: GPL-3.0-or-later
// A sequence of grids solved one after the other, and the Solution with errors that is made of it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "contact/solver.hpp"
#include "reference/grid_newton.hpp"
#include "reference/lengths.hpp"

namespace ehd::reference {

/// A grid that was solved.
struct Level {
  Grid grid;
  State state;
  Evaluation at;
  double iteration_error = 0;
  Observables seen;  ///< without errors
  [[nodiscard]] double central_film() const { return seen.at(Quantity::film_central).value; }
  [[nodiscard]] double minimum_film() const { return seen.at(Quantity::film_minimum).value; }
  [[nodiscard]] double cells_in_inlet_zone() const;  ///< by its own film
};

/// The error of each observable (relative; offset and approach absolute) because the domain begins at `inlet`.
struct Truncation {
  double inlet = 0;
  Observables errors;
};

/// The value of a quantity by a sequence of grids, and its error.
struct Judged {
  double value = 0;
  double error = 0;  ///< relative
};

class Study {
 public:
  Study(const Problem& problem, const Request& request);

  /// Central film by Moes' formula (contact/film_formulas.hpp).
  [[nodiscard]] double expected_film() const { return expected_film_; }
  /// Solves from scratch: Hertz' or Martin's pressure with the expected film; if `insist`, also with 2, 1/2, 4 times
  /// it.
  [[nodiscard]] std::optional<Level> solve(const Grid& grid, bool insist = true);
  /// Solves from the solution on another grid; from scratch where that fails.
  [[nodiscard]] std::optional<Level> solve(const Grid& grid, const Level& from, bool insist = true);
  /// Iterations or time have run out.
  [[nodiscard]] bool limit_reached() const { return limit_reached_; }
  /// A grid with twice the intervals of the last one would not end in time (run time ~ n^3).
  [[nodiscard]] bool no_time_to_double() const;

  /// Everything spent so far; its work units are for `finest` intervals.
  [[nodiscard]] Cost cost(int finest) const;
  [[nodiscard]] bool flooded() const { return std::holds_alternative<Flooded>(problem_.inlet); }
  /// The error that the place X_a of the inlet causes. The level is solved again without its far nodes; the difference
  /// is extrapolated as X_a^-2 and doubled. Empty where the cut grid could not be solved.
  [[nodiscard]] std::optional<Truncation> truncation(const Level& level);

  /// The last of `levels` (coarse to fine, one family) with an error for each quantity. `extrapolate`: Richardson where
  /// the observed ratio supports it.
  [[nodiscard]] Solution report(const std::vector<Level>& levels, bool extrapolate,
                                const std::optional<Truncation>& truncation) const;
  /// No film: what could not be solved, and why.
  [[nodiscard]] Solution without_film(StopReason status, std::string reason) const;

 private:
  using Clock = std::chrono::steady_clock;
  std::optional<Level> attempt(const Equations& equations, const State& start);
  /// The parts of a quantity's error. `judged`: the quantity by `levels`.
  [[nodiscard]] ErrorBudget budget_of(Quantity quantity, const Judged& judged, const std::vector<Level>& levels,
                                      const std::optional<Truncation>& truncation) const;
  /// The least discretisation error of every number but the judged films, by theirs.
  [[nodiscard]] double least_discretisation(const std::vector<Level>& levels, bool extrapolate) const;

  Problem problem_;
  Request request_;
  Clock::time_point begin_ = Clock::now();
  Budget budget_;
  double expected_film_;
  bool limit_reached_ = false;
  Cost spent_;
  double point_products_ = 0;  ///< kernel products times their intervals
  double last_grid_s_ = 0;
  std::vector<GridRecord> grids_;
};

/// Solves grid_of(n) for each n of `sizes` (coarse to fine, each about twice the one before), the first from `start`.
/// - with tolerances: ends at the first of at least three grids whose films are estimated within them; grids that
///   cannot see the inlet zone serve as starts only.
/// - without: the last size is the answer, the others its start and its error estimate.
[[nodiscard]] Solution solve_grids(Study& study, const std::function<Grid(int)>& grid_of, const std::vector<int>& sizes,
                                   const FilmTolerances& asked, bool extrapolate, const std::optional<Level>& start);

/// sizes 2^k n0 up to `largest`.
[[nodiscard]] std::vector<int> doubled_sizes(int n0, int largest);
/// n and its halves, coarse to fine, as long as `useful(half)`, but not below 16.
[[nodiscard]] std::vector<int> halved_sizes(int n, const std::function<bool(int)>& useful);

}  // namespace ehd::reference
