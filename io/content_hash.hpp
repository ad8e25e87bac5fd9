// SPDX-License-Identifier: GPL-3.0-or-later
// A hash of a text. It tells which inputs a result was computed from, and whether a stored line is damaged. It gives no
// security: somebody can make two texts with one hash.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

namespace ehd {

inline constexpr std::size_t content_hash_digits = 32;

/// XXH3, 128 bits (xxHash), as lower-case hexadecimal digits in the canonical order, high half first.
[[nodiscard]] std::string content_hash(std::string_view bytes);
/// The hash of the rest of a stream. The stream is read piece by piece, so that its length needs no memory.
[[nodiscard]] std::string content_hash(std::istream& bytes);

/// The digits of a content_hash as a number, for where millions are held: 16 bytes instead of 80.
struct HashNumber {
  std::uint64_t high = 0, low = 0;
  friend auto operator<=>(const HashNumber&, const HashNumber&) = default;
};
/// Absent where the text is not content_hash_digits hexadecimal digits.
[[nodiscard]] std::optional<HashNumber> hash_number(std::string_view digits);
[[nodiscard]] std::string digits_of(const HashNumber& number);

}  // namespace ehd
