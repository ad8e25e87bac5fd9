// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of one bearing: decided from the case alone, and obeyed by run_bearing.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bearing/equilibrium.hpp"
#include "bearing/law_table.hpp"
#include "workflow/case.hpp"
#include "workflow/plan.hpp"

namespace ehd {

/// Names of the stages; those of a law or raceway end in its name.
namespace bearing_stage {
inline constexpr std::string_view geometry = "geometry and kinematics";
inline constexpr std::string_view dry = "dry balance for datum and ranges";
inline constexpr std::string_view datum = "datum of the approach";
inline constexpr std::string_view solves = "EHD contact solves";
inline constexpr std::string_view fit = "straight-line fit";
inline constexpr std::string_view curve = "load-approach curve";
inline constexpr std::string_view variant = "ehd-linear cut at delta = 0";
inline constexpr std::string_view lambda = "lambda ratios";
inline constexpr std::string_view across = "balance across the load";
inline constexpr std::string_view cage = "cage positions over one pitch";
inline constexpr std::string_view torque = "rolling torque";
inline constexpr std::string_view dynamics = "stiffness in motion";
inline constexpr std::string_view response = "response of the films, for damping";
[[nodiscard]] std::string balance(bearing::Law law);
[[nodiscard]] std::string film(bearing::Law law);
}  // namespace bearing_stage

/// What run_bearing will do, from the case alone. `asked`: laws asked for; those that the case cannot have are skipped
/// with the reason.
[[nodiscard]] Plan plan_bearing(const BearingCase& body, const std::vector<bearing::Law>& asked,
                                bearing::Form form = bearing::Form::plane, int cage_positions = 0,
                                bool dynamic = false);

}  // namespace ehd
