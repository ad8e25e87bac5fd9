// SPDX-License-Identifier: GPL-3.0-or-later
// The name that somebody may have meant: for unknown keys, options, subcommands and cases.
#pragma once

#include <string>
#include <vector>

namespace ehd {

/// The nearest of the names where at most two characters differ, and fewer than half of the word's. Else the shortest
/// name that begins with the word; else, from four characters on, the shortest that contains it. Empty where there is
/// none.
[[nodiscard]] std::string near_miss(const std::string& word, const std::vector<std::string>& names);

/// "did you mean NAME? ", or nothing.
[[nodiscard]] std::string did_you_mean(const std::string& word, const std::vector<std::string>& names);

}  // namespace ehd
