// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/content_hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <charconv>
#include <system_error>

namespace ehd {

std::string content_hash(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return digits_of({.high = hash.high64, .low = hash.low64});
}

std::optional<HashNumber> hash_number(std::string_view digits) {
  constexpr std::size_t half = content_hash_digits / 2;
  if (digits.size() != content_hash_digits) return std::nullopt;
  const auto read = [&](std::size_t begin, std::uint64_t& number) {
    const char* end = digits.data() + begin + half;
    const auto parsed = std::from_chars(digits.data() + begin, end, number, 16);
    return parsed.ec == std::errc() && parsed.ptr == end;
  };
  HashNumber number;
  if (!read(0, number.high) || !read(half, number.low)) return std::nullopt;
  return number;
}

std::string digits_of(const HashNumber& number) { return fmt::format("{:016x}{:016x}", number.high, number.low); }

}  // namespace ehd
