// SPDX-License-Identifier: GPL-3.0-or-later
// How both solvers of this folder judge a solve: shared constants, values of the grids, and the sentences of its end.
#pragma once

#include <string>
#include <vector>

#include "contact/solution.hpp"

namespace ehd::fast {

/// Iteration stops where the residual is at most this share of the tolerance. At 96 problems (M of 0.5..1000, L of
/// 0..20, both law sets, flooded and -4) and three tolerances the film error was at most 0.24 times the residual at the
/// end.
constexpr double iteration_share = 1.0 / 30;
/// Newton's target on a given number of intervals, unless the caller asks for less: round-off.
constexpr double round_off_residual = 1e-11;

/// Truncation error of the rolling force and of H_0, over that of the films. The work before the domain falls only as
/// 1/|X_a|, and the tail adds a term with ln|X_a| to H_0. Measured with fast.uniform against the reference at ten
/// points of M = 0.05..100, both law sets: rolling force at most 4.7e-5 (reach 4), 2.8e-6 (reach 8); offset 1.3e-5,
/// 1.2e-6, discretisation included.
constexpr double truncation_of_work = 20, truncation_of_offset = 5;

/// The values of a quantity, coarse to fine, on the grids after the last one that lacks it.
[[nodiscard]] std::vector<double> values_of(const std::vector<GridRecord>& grids, Quantity quantity);

/// How a solve ended, with a sentence where it did not converge.
struct Ending {
  StopReason status;
  std::string reason = {};
};
[[nodiscard]] Ending limit_ending();
[[nodiscard]] Ending diverged_ending();
[[nodiscard]] Ending tolerance_ending();
/// How a solve on a given number of intervals ended: converged, or under-resolved where an error is too large.
[[nodiscard]] Ending given_grid_ending(const ErrorBudget& minimum, const ErrorBudget& central);

}  // namespace ehd::fast
