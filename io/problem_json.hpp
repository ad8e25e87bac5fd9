// SPDX-License-Identifier: GPL-3.0-or-later
// A contact case for a program that reads no TOML: every group, the laws as formulas with their numbers, the inlet.
#pragma once

#include "io/json.hpp"
#include "workflow/case.hpp"

namespace ehd {

/// docs/schema/ehd-problem-1.json describes it. Pressures are in units of p_H. A dry contact has no groups, laws or
/// inlet. The case's expectations are not in it.
[[nodiscard]] Json problem_json(const Case& contact_case);

/// The numbers of a bearing case, by the tables and keys of its file, with their defaults. The speeds are those of both
/// rings; an oil by its grade stands under "oil", and what follows from it under "lubricant".
[[nodiscard]] Json bearing_inputs_json(const BearingCase& body);

}  // namespace ehd
