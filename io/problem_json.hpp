// SPDX-License-Identifier: GPL-3.0-or-later
// A contact case for a program that reads no TOML: every group, the laws as formulas with their numbers, the inlet.
#pragma once

#include "io/json.hpp"
#include "workflow/case.hpp"

namespace ehd {

/// docs/schema/ehd-problem-1.json describes it. Pressures are in units of p_H. A dry contact has no groups, laws or
/// inlet. The case's expectations are not in it.
[[nodiscard]] Json problem_json(const Case& contact_case);

}  // namespace ehd
