// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11, the parts of a bearing, a file a part. Expected values come from the printed formulas, written out again in
// by_hand.hpp, and from contacts that `reference` solves in SI, never from bearing/'s own functions.
#pragma once

#include "verification/claim.hpp"
#include "workflow/case.hpp"
#include "workflow/contact_memory.hpp"

namespace ehd::verification::bearing_parts {

[[nodiscard]] Findings judge_energy();
[[nodiscard]] Findings judge_many_rollers();
[[nodiscard]] Findings judge_dry_laws();
[[nodiscard]] Findings judge_plane();
[[nodiscard]] Findings judge_light_load();
[[nodiscard]] Findings judge_random_bearings();
/// Of random bearings.
[[nodiscard]] Findings judge_bearing_symmetry();
[[nodiscard]] Findings judge_forms(const Case& bearing_case);
[[nodiscard]] Findings judge_kinematics(const Case& na4908);
[[nodiscard]] Findings judge_contacts_asked(const Case& bearing_case);
[[nodiscard]] Findings judge_datum(const Case& bearing_case, ContactMemory& memory);
[[nodiscard]] Findings judge_fit(const Case& bearing_case, ContactMemory& memory);
[[nodiscard]] Findings judge_roughness(const Case& bearing_case, ContactMemory& memory);
[[nodiscard]] Findings judge_curve(const Case& bearing_case, ContactMemory& memory);
[[nodiscard]] Findings judge_full_relation(const Case& bearing_case, ContactMemory& memory);
[[nodiscard]] Findings judge_zero_speed(const Case& bearing_case, ContactMemory& memory);
/// Rollers and contacts in motion, against their equations of motion.
[[nodiscard]] Findings judge_rollers_in_motion();
[[nodiscard]] Findings judge_dynamics(const Case& bearing_case, ContactMemory& memory);
[[nodiscard]] Findings judge_torque(const Case& bearing_case, ContactMemory& memory);

}  // namespace ehd::verification::bearing_parts
