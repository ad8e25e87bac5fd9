// SPDX-License-Identifier: GPL-3.0-or-later
// The argument CASE and the option --set KEY=VALUE, as every command has them that reads a case.
#pragma once

#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "io/json.hpp"

namespace ehd {
struct Case;
}

namespace ehd::cli {

/// Other values for keys of the case. They pass every check that the file's own would.
struct CaseChanges {
  std::vector<std::string> settings;  ///< "KEY=VALUE", as given
  void add_to(Command& command);
  [[nodiscard]] bool any() const { return !settings.empty(); }
  /// The case that `name` names: a path, an id, or - for standard input. Its title says what was changed, and its
  /// expectations are left out where something was. Throws UsageError, CaseError.
  [[nodiscard]] Case read(const std::string& name) const;
  /// object["set"], where something was changed.
  void put_into(Json& object) const;
};

}  // namespace ehd::cli
