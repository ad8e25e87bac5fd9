// SPDX-License-Identifier: GPL-3.0-or-later
// Another value for one key of a case: what a sweep varies, and what --set gives.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ehd {

/// A value as TOML has it.
using TomlValue = std::variant<std::int64_t, double, std::string, std::vector<double>>;
/// The text of a value in TOML. A number has the fewest digits that identify it.
[[nodiscard]] std::string toml_text(const TomlValue& value);

/// The value that a text of the command line stands for: an integer, a number, a list of numbers "[2000, 12000]", or a
/// text, with quotes or without.
[[nodiscard]] TomlValue toml_value(std::string_view text);

/// A value for a key of a case, "operation.radial_load_N". It replaces the value in the file, or is added to its table.
struct Substitution {
  std::string key;
  TomlValue value;
  std::string option = {};  ///< "--set KEY=VALUE" where the command line gave it: refusals then name that
};

}  // namespace ehd
