// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of one bearing: decided from the case alone, and obeyed by run_bearing.
#pragma once

#include <string>
#include <vector>

#include "bearing/equilibrium.hpp"
#include "bearing/law_table.hpp"
#include "workflow/case.hpp"
#include "workflow/plan.hpp"

namespace ehd {

/// Names of the stages; those of a law or raceway end in its name.
namespace bearing_stage {
inline constexpr const char* geometry = "geometry and kinematics";
inline constexpr const char* dry = "dry balance for datum and ranges";
inline constexpr const char* datum = "datum of the approach";
inline constexpr const char* solves = "EHD contact solves";
inline constexpr const char* fit = "straight-line fit";
inline constexpr const char* curve = "load-approach curve";
inline constexpr const char* variant = "ehd-linear cut at delta = 0";
inline constexpr const char* lambda = "lambda ratios";
inline constexpr const char* across = "balance across the load";
inline constexpr const char* cage = "cage positions over one pitch";
inline constexpr const char* torque = "rolling torque";
inline constexpr const char* dynamics = "stiffness in motion";
inline constexpr const char* response = "response of the films, for damping";
[[nodiscard]] std::string balance(bearing::Law law);
[[nodiscard]] std::string film(bearing::Law law);
}  // namespace bearing_stage

/// What run_bearing will do, from the case alone. `asked`: laws asked for; those that the case cannot have are skipped
/// with the reason.
[[nodiscard]] Plan plan_bearing(const BearingCase& body, const std::vector<bearing::Law>& asked,
                                bearing::Form form = bearing::Form::plane, int cage_positions = 0,
                                bool dynamic = false);

}  // namespace ehd
