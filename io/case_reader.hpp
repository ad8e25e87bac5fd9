// SPDX-License-Identifier: GPL-3.0-or-later
// The strict reader of case files: TOML text -> Case, or one line that says what is wrong.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/substitution.hpp"
#include "workflow/case.hpp"

namespace ehd {

/// Reads and checks a case; throws CaseError. Every error that can be found without a solve is found here, M and L out
/// of range too: nondimensionalise is tried.
[[nodiscard]] Case read_case(const std::filesystem::path& file);

/// The same of a text in memory. `file` names the text in messages; its stem must be the id.
[[nodiscard]] Case read_case(std::string text, const std::filesystem::path& file);

/// The same with other values, which pass every check that the file's own would. Messages about them name no line, but
/// the option that gave them, if any. The file's expectations are left out: they hold for the file's own numbers.
[[nodiscard]] Case read_case(std::string text, const std::filesystem::path& file,
                             const std::vector<Substitution>& substitutions);

/// The same of a text that has no file. It stands for the file that its id names: messages begin with "ID.toml", or
/// with "case" where it has no id.
[[nodiscard]] Case read_case_in_memory(std::string text);

/// A fully flooded contact by its groups. `lubricant`: the body of a [lubricant] table; messages name it
/// "lubricant:LINE", where line 1 is the heading [lubricant] itself. Throws CaseError.
[[nodiscard]] ContactCase read_moes_contact(const MoesGroups& groups, const std::string& lubricant);

}  // namespace ehd
