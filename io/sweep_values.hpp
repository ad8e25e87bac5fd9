// SPDX-License-Identifier: GPL-3.0-or-later
// The values that a swept key takes: a list, or a range with its points and spacing. For source files only, as
// io/sweep_source.hpp.
#pragma once

#include <string>
#include <vector>

#include "io/substitution.hpp"
#include "io/sweep_source.hpp"

namespace ehd {

/// Throws CaseError for anything but a list of numbers and texts or a complete range.
[[nodiscard]] std::vector<TomlValue> swept_values(const SweepSource& source, const std::string& key,
                                                  const toml::node& node);

}  // namespace ehd
