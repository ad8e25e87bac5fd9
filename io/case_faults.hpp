// SPDX-License-Identifier: GPL-3.0-or-later
// Unknown and missing keys of a case, all at once.
#pragma once

#include <string>

namespace ehd {

class CaseTree;
struct CaseTable;

/// "exactly one of [moes], [conditions], [hertz] and [bearing]": what has to state the problem.
[[nodiscard]] std::string one_statement();

/// `statement`: the table that states the problem; null where there is none, or more than one. Throws one CaseError
/// with a line for each unknown key, for each missing one, and for a missing problem. It looks at keys alone; the
/// readers refuse what follows from values. A missing key is left out where an unknown one was probably meant to be it.
void refuse_unknown_and_missing(const CaseTree& tree, const CaseTable* statement);

/// The unknown keys alone, for a tree that is not a whole case. Throws CaseError.
void refuse_unknown(const CaseTree& tree);

}  // namespace ehd
