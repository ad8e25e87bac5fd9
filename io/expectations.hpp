// SPDX-License-Identifier: GPL-3.0-or-later
// The [[expect]] tables of a case: numbers that a source gives for it.
#pragma once

#include <vector>

#include "workflow/case.hpp"

namespace ehd {

class CaseTree;

/// `of`: what the case states, already read. Throws CaseError, also for a quantity, law or scaling that this contact
/// or bearing does not have.
[[nodiscard]] std::vector<Expectation> read_expectations(const CaseTree& tree, const ContactCase& of);
[[nodiscard]] std::vector<Expectation> read_expectations(const CaseTree& tree, const BearingCase& of);

}  // namespace ehd
