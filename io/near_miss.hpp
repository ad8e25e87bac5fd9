// SPDX-License-Identifier: GPL-3.0-or-later
// The name that somebody may have meant: for unknown keys, options, subcommands, cases and words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ehd {

/// The nearest of the names where at most two characters differ, and fewer than half of the word's (of the name's where
/// one alone is missing: lw is law); capital letters are small ones here. A name that begins with the word is nearer
/// than one where two characters differ. Else the shortest name that begins with the word; else, from four characters
/// on, the shortest that contains it, or the one that has most of its words between "_". Of two and three characters:
/// the only name that has the word between "_". Empty where there is none.
[[nodiscard]] std::string near_miss(const std::string& word, const std::vector<std::string>& names);

/// At most two characters differ: the word is the mistyped name. Where more differ, the word may mean something else.
[[nodiscard]] bool is_mistyped(const std::string& word, const std::string& name);

/// "did you mean NAME? ", or nothing.
[[nodiscard]] std::string did_you_mean(const std::string& word, const std::vector<std::string>& names);

/// "is unknown; did you mean NAME? allowed is ALLOWED", of a word that is none of the allowed: "one, two", each as it
/// is or in quotation marks.
[[nodiscard]] std::string is_unknown(const std::string& word, const std::string& allowed);

/// "has a comma in a number; allowed is a point, 1.0e5", of "1,0e5"; empty of any other text.
[[nodiscard]] std::string comma_in_number(std::string_view text);

}  // namespace ehd
