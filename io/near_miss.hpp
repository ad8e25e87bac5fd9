// SPDX-License-Identifier: GPL-3.0-or-later
// The name that somebody may have meant: for unknown keys, options, subcommands, cases and words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ehd {

/// A to Z become a to z.
[[nodiscard]] std::string in_small_letters(std::string text);

/// The first of these that exists, else empty. Capital letters count as small ones.
/// - The nearest name where at most two characters differ (two swapped neighbours count as one), and fewer than half of
///   the word's. Where one character differs, the longer of word and name counts: "lw" is law. A name that begins with
///   the word goes before one where two differ.
/// - The shortest name that begins with the word.
/// - For a word of four characters and more: the shortest name that contains it, or the name that has most of the
///   word's parts between "_".
/// - For a word of two or three: the only name that has the word between "_".
[[nodiscard]] std::string near_miss(const std::string& typed, const std::vector<std::string>& names);

/// At most two characters differ: the word is the mistyped name. Where more differ, the word may mean something else.
[[nodiscard]] bool is_mistyped(const std::string& word, const std::string& name);

/// "did you mean NAME? ", or nothing.
[[nodiscard]] std::string did_you_mean(const std::string& word, const std::vector<std::string>& names);

/// "is unknown; did you mean NAME? allowed is ALLOWED", of a word that is none of the allowed: "one, two", each as it
/// is or in quotation marks.
[[nodiscard]] std::string is_unknown(const std::string& word, const std::string& allowed);

/// "has a comma in a number; allowed is a point, 1.0e5", of "1,0e5"; empty of any other text.
[[nodiscard]] std::string comma_in_number(std::string_view text);

/// What is wrong with "1e-2,1e-3" in the place of a number.
inline constexpr const char* several_numbers = "has a comma, and is not one number";

/// Without the sign of "+5", which std::from_chars does not know. "+-5" stays, and is no number.
[[nodiscard]] std::string_view without_plus(std::string_view number);

/// What stands behind a number is "e", "d5" or "E+": a slip in an exponent. No unit begins so.
[[nodiscard]] bool begins_exponent(std::string_view text);

}  // namespace ehd
