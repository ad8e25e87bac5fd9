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
  /// The table that states the problem, or has to: a case without one, but with tables of bearings alone, needs
  /// [bearing]. Where there are several, the first of the file. Null where it can be one of several.
  const CaseTable* table = nullptr;
  /// Lines of the refusal: no table states the problem, another one states it again, tables that do not belong to it.
  std::vector<std::string> faults = {};
};

/// A contact with one of the tables [lubricant] and [domain] has to have both. A dry one has neither.
[[nodiscard]] bool is_lubricated(const CaseTree& tree);
/// Whether a companion ([operation], [domain], ...) has to stand beside the statement.
[[nodiscard]] bool has_to_stand(const CaseTree& tree, const CaseTable& companion, const CaseTable& statement);

/// `needs`: the names of the keys that a table of this case has to have, for the refusal of a case that has no problem.
[[nodiscard]] CaseStatement statement_of(const CaseTree& tree,
                                         const std::function<std::vector<std::string>(const CaseTable& table)>& needs);

}  // namespace ehd
