// SPDX-License-Identifier: GPL-3.0-or-later
// Unknown and missing keys of a case, all at once.
#pragma once

namespace ehd {

class CaseTree;
struct CaseTable;

/// `statement`: the table that states the problem; null where that is not clear. Throws one CaseError with a line for
/// each unknown key and for each missing one. It looks at keys alone; the readers refuse what follows from values. A
/// missing key is left out where an unknown one was probably meant to be it.
void refuse_unknown_and_missing(const CaseTree& tree, const CaseTable* statement);

/// The unknown keys alone, for a tree that is not a whole case. Throws CaseError.
void refuse_unknown(const CaseTree& tree);

}  // namespace ehd
