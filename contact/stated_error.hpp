// SPDX-License-Identifier: GPL-3.0-or-later
// What follows from the errors that a solver states: whether a given grid may call itself converged, and how far the
// fields of that grid are off.
#pragma once

#include <optional>
#include <string>

#include "contact/solution.hpp"

namespace ehd {

/// A solve on a given number of intervals ends as `converged` only where the stated error of both films is below this.
/// The contract with users' scripts; every solver keeps it.
inline constexpr double least_error_under_resolved = 0.1;

/// Why a given grid is under-resolved by that rule. Empty where both errors are below the limit; an error that is not a
/// finite number is not.
[[nodiscard]] std::optional<std::string> too_coarse(const ErrorBudget& film_minimum, const ErrorBudget& film_central);

/// The equations of the last grid were solved. The grid may be too coarse for its contact, or the tolerance may be
/// missed: the values are those of the grid, with their errors. For studies that judge values on a given grid.
[[nodiscard]] bool solved_on_its_grid(const Solution& solution);

/// Relative error of the fields as they stand on their grid. A reported film may be extrapolated from several grids, so
/// that it is better than the fields of the finest one. The error is the larger one of both judged films: the distance
/// of the film in the fields from the reported one, relative to the reported one, plus its stated error. Empty where a
/// judged film or its error is not reported.
///
/// Measured on 50 fields: ten contacts (M = 0.2..1000, L = 2.5..28, both law sets, flooded and cut), `fast` at
/// 1e-2..1e-4, fast.uniform at 1e-2, reference.linear at 1e-3, against `fast` at 1e-7. More than 0.03 from the spike,
/// H(X) errs at every node by at most 1.3 times this number. Beside a spike that the grid does not resolve H(X) errs by
/// up to 23 times the number (1.4e-2 at most). P(X) has no such bound: without a spike it erred by at most 3.2e-3 p_H,
/// beside one by as much as the spike is high. That height is known only where pressure.spike is reported.
[[nodiscard]] std::optional<double> field_error(const Solution& solution);

/// Relative error of P(X) in L2 over the domain, ||P - P*||/||P*||, by the largest distance to the pressures of
/// Solution::beside. Empty where there are none. The height of a spike has an error of its own.
[[nodiscard]] std::optional<double> pressure_error(const Solution& solution);

}  // namespace ehd
