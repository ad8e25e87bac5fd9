// SPDX-License-Identifier: GPL-3.0-or-later
// The words of an enum, counted by the compiler, so that a table that lacks one does not compile.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace ehd {

/// Whether a scoped enum has a word for this value. Compilers write a word as "Law::hertz", any other value as a cast,
/// "(Law)7", or as a number.
template <auto value>
consteval bool is_word() {
  const std::string_view signature = __PRETTY_FUNCTION__;  // "bool ehd::is_word() [with auto value = Law::hertz]"
  return signature[signature.find_last_of(":)")] == ':';
}

/// How many words an enum has whose values are 0, 1, 2, …
template <class Enum, std::size_t from = 0>
consteval std::size_t word_count() {
  if constexpr (is_word<static_cast<Enum>(from)>())
    return word_count<Enum, from + 1>();
  else
    return from;
}

/// All of them, in order.
template <class Enum>
inline constexpr std::array<Enum, word_count<Enum>()> all_words = [] {
  std::array<Enum, word_count<Enum>()> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Enum>(i);
  return all;
}();

/// The word whose name is `text`; nothing where no word has it. A function to_string(Enum) names the words.
template <class Enum>
std::optional<Enum> word_from(std::string_view text) {
  for (const Enum word : all_words<Enum>)
    if (to_string(word) == text) return word;
  return std::nullopt;
}

}  // namespace ehd
