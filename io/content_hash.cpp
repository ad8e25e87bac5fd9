// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/content_hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <array>
#include <charconv>
#include <istream>
#include <memory>
#include <new>
#include <system_error>

namespace ehd {

namespace {

/// Bytes of a stream that are read at once.
constexpr std::size_t piece_bytes = 1 << 14;

std::string text_of(const XXH128_hash_t& hash) { return digits_of({.high = hash.high64, .low = hash.low64}); }

}  // namespace

std::string content_hash(std::string_view bytes) { return text_of(XXH3_128bits(bytes.data(), bytes.size())); }

std::string content_hash(std::istream& bytes) {
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(), &XXH3_freeState);
  if (!state || XXH3_128bits_reset(state.get()) != XXH_OK) throw std::bad_alloc();
  std::array<char, piece_bytes> piece{};
  while (bytes.read(piece.data(), piece_bytes) || bytes.gcount() > 0)
    XXH3_128bits_update(state.get(), piece.data(), static_cast<std::size_t>(bytes.gcount()));
  return text_of(XXH3_128bits_digest(state.get()));
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
