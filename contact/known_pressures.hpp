// SPDX-License-Identifier: GPL-3.0-or-later
// Which pressures of a solve on a sequence of grids are known well enough to be reported. A spike is narrower than most
// cells (1e-4 at (20, 10), 2e-11 at (200, 15)), so that grids may agree on a wrong height, or not see the spike at all.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "contact/estimate.hpp"
#include "contact/solution.hpp"

namespace ehd {

/// Estimates of a spike's height are multiplied by this. Measured with fast.uniform against the ten-digit heights of
/// six points, flooded and -4, at four tolerances: an estimate below 3 % was never too small, one of 9 % up to five
/// times.
inline constexpr double spike_safety = 3;

/// The least error of a pressure maximum or spike with these values on grids, coarse to fine: spike_safety times the
/// largest of its last three moves, the earlier ones divided by 2 and 4. Absolute; 0 for fewer than two values.
[[nodiscard]] double error_of_moves(const std::vector<double>& heights);

/// The error of a pressure maximum or spike on grids that do not follow the spike, relative: spike_safety times the one
/// that contact/estimate.hpp finds, at least error_of_moves(). Infinite for a spike whose heights do not settle, that
/// is whose last moves do not fall by 1.5: three grids of (20, 10) agree to 2.0 % on a spike that is 2.6 % low.
[[nodiscard]] double peak_error(Quantity peak, const std::vector<double>& values, const GridEstimate& found,
                                double relative_error);

/// Removes a spike and a maximum whose heights are not known to 5 %, and a maximum that the spike may exceed. Removing
/// a `wanted` one leaves a note. A spike is not known on fewer than four grids, nor where `fields`, nodal values of the
/// finest grid, do not resolve it. `grids`: how many grids saw the spike, or could have seen it. L: up to 2.5
/// there is no spike.
void keep_known_pressures(Observables& seen, const Wanted& wanted, const Fields& fields, std::size_t grids, double L,
                          std::vector<std::string>& notes);

}  // namespace ehd
