// SPDX-License-Identifier: GPL-3.0-or-later
// The strict reader of case files: TOML text -> Case, or the one line that says what is wrong.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "workflow/case.hpp"

namespace ehd {

/// Reads and checks a case; throws CaseError. Everything that can be refused without solving is refused here, the
/// groups' range included (nondimensionalise is tried).
[[nodiscard]] Case read_case(const std::filesystem::path& file);

/// The same of a text that is at hand, as if it stood in `file`: its name is the id, and stands in messages.
[[nodiscard]] Case read_case(std::string text, const std::filesystem::path& file);

/// A value as TOML has it.
using TomlValue = std::variant<std::int64_t, double, std::string>;
/// As TOML would write it, a number with as many digits as tell it from every other.
[[nodiscard]] std::string toml_text(const TomlValue& value);

/// A value for a key of a case, "operation.radial_load_N", in the place of the one in the file or beside those there.
struct Substitution {
  std::string key;
  TomlValue value;
};

/// The same with other values, which pass every check that the file's own would; messages name the line of the value
/// that was replaced, or of its table. The file's expectations are left out, since they speak of its own numbers.
[[nodiscard]] Case read_case(std::string text, const std::filesystem::path& file,
                             const std::vector<Substitution>& substitutions);

}  // namespace ehd
