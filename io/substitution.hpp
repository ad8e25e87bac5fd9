// SPDX-License-Identifier: GPL-3.0-or-later
// Another value for one key of a case: what a sweep varies.
#pragma once

#include <cstdint>
#include <string>
#include <variant>

namespace ehd {

/// A value as TOML has it.
using TomlValue = std::variant<std::int64_t, double, std::string>;
/// The text of a value in TOML. A number has the fewest digits that identify it.
[[nodiscard]] std::string toml_text(const TomlValue& value);

/// A value for a key of a case, "operation.radial_load_N". It replaces the value in the file, or is added to its table.
struct Substitution {
  std::string key;
  TomlValue value;
};

}  // namespace ehd
