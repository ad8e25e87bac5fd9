// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of a bearing case: [bearing] with its companions.
#pragma once

#include "workflow/case.hpp"

namespace ehd {

class CaseTree;

/// Throws CaseError.
[[nodiscard]] BearingCase read_bearing(const CaseTree& tree);

}  // namespace ehd
