// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of a contact case: [moes], [conditions] or [hertz], with [lubricant] and [domain].
#pragma once

#include <string>

#include "workflow/case.hpp"

namespace ehd {

class CaseTree;

/// `statement`: the table that states the contact. Throws CaseError, also where the statement makes no problem
/// (nondimensionalise is tried).
[[nodiscard]] ContactCase read_contact(const CaseTree& tree, const std::string& statement);

}  // namespace ehd
