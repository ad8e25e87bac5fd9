// SPDX-License-Identifier: GPL-3.0-or-later
// The load distribution of a bearing in the numbers that an engineer asks for first, a column a law.
#pragma once

#include <string>
#include <vector>

#include "bearing/geometry.hpp"
#include "workflow/bearing_result.hpp"
#include "workflow/case.hpp"

namespace ehd {

/// Digits of a number with films whose error is not known.
inline constexpr int unstated_digits = 3;

/// The azimuth of a roller, and of its mirror image where it has one: "0", "+-16.364".
[[nodiscard]] std::string azimuth_text(const bearing::RollerGroup& group, double azimuth_deg);

/// Displacement, largest load and its pressure, load zone, thinnest film, stiffness, and where pressure and film are.
/// Brackets are the errors in units of the last digit; a result without `errors` has none. A fitted law has an error of
/// its stiffness only with the law ehd beside it.
[[nodiscard]] std::string summary_table(const BearingCase& body, const std::vector<BearingResult>& results);

}  // namespace ehd
