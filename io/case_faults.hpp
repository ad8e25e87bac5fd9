// SPDX-License-Identifier: GPL-3.0-or-later
// Unknown and missing keys and tables of a case, all at once.
#pragma once

namespace ehd {

class CaseError;
class CaseTree;
struct CaseTable;

/// The table that states the problem. Throws one CaseError with a line for each unknown key, for each table that is too
/// many, and for each key and table that is missing. It looks at keys alone; the readers refuse what follows from
/// values. A missing key is left out where an unknown one was probably meant to be it.
[[nodiscard]] const CaseTable& statement_without_faults(const CaseTree& tree);

/// A refusal of the case, and after it every other value that its key's row does not allow, in the order of the rows.
[[nodiscard]] CaseError with_wrong_values(const CaseTree& tree, const CaseError& refusal);

/// The unknown keys alone, for a tree that is not a whole case. Throws CaseError.
void refuse_unknown(const CaseTree& tree);

}  // namespace ehd
