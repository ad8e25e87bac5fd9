// SPDX-License-Identifier: GPL-3.0-or-later
// The rollers of bearings as CSV.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflow/bearing_run.hpp"

namespace ehd {

/// A row a roller: force, displacement, film and Hertzian pressure at both raceways. Where a result has motion, a row a
/// roller and frequency, with the stiffness and damping of both contacts. A cell is empty where the law has no such
/// number. Two files may hold cases with one id: the column `file` tells them apart. Nothing where no law has a
/// balance. `results` holds the laws of each case.
[[nodiscard]] std::optional<std::string> bearing_csv(const std::vector<Case>& cases,
                                                     const std::vector<std::vector<BearingResult>>& results);

}  // namespace ehd
