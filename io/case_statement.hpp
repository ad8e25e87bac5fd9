// SPDX-License-Identifier: GPL-3.0-or-later
// Which table states the problem of a case.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace ehd {

class CaseTree;
struct CaseTable;

struct CaseStatement {
  /// The table that states the problem; where there are several, the first of the file. Without one: the only table
  /// that can stand beside the case's other tables ([bearing] beside tables of bearings), else null.
  const CaseTable* table = nullptr;
  /// Lines of the refusal: no table states the problem, another one states it again, tables that do not belong to it.
  std::vector<std::string> faults = {};
};

/// The contact has a table [lubricant] or [domain]. It must then have both; a dry one has neither.
[[nodiscard]] bool is_lubricated(const CaseTree& tree);
/// Whether a companion ([operation], [domain], ...) has to stand beside the statement.
[[nodiscard]] bool has_to_stand(const CaseTree& tree, const CaseTable& companion, const CaseTable& statement);

/// `needs`: the names of the keys that a table of this case has to have, for the refusal of a case that has no problem.
[[nodiscard]] CaseStatement statement_of(const CaseTree& tree,
                                         const std::function<std::vector<std::string>(const CaseTable& table)>& needs);

}  // namespace ehd
