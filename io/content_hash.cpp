// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sha256.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ehd {

namespace {

using Word = std::uint32_t;
constexpr std::size_t rounds = 64, block_bytes = 64;

/// The first 32 bits of the fractional part of a root: extended precision has 64 bits, of which a cube root of a prime
/// below 312 needs 3 before the point.
Word fraction_bits(long double root) { return static_cast<Word>((root - std::floor(root)) * 4294967296.0L); }

struct Constants {
  std::array<Word, 8> start{};       // square roots of the first 8 primes
  std::array<Word, rounds> added{};  // cube roots of the first 64 primes
  Constants() {
    std::size_t found = 0;
    for (int candidate = 2; found < rounds; ++candidate) {
      bool prime = true;
      for (int divisor = 2; divisor * divisor <= candidate; ++divisor) prime = prime && candidate % divisor != 0;
      if (!prime) continue;
      if (found < start.size()) start[found] = fraction_bits(std::sqrt(static_cast<long double>(candidate)));
      added[found++] = fraction_bits(std::cbrt(static_cast<long double>(candidate)));
    }
  }
};

void absorb(std::array<Word, 8>& state, const unsigned char* block, const Constants& constants) {
  std::array<Word, rounds> w{};
  for (std::size_t t = 0; t < 16; ++t)
    w[t] = static_cast<Word>(block[4 * t]) << 24 | static_cast<Word>(block[4 * t + 1]) << 16 |
           static_cast<Word>(block[4 * t + 2]) << 8 | static_cast<Word>(block[4 * t + 3]);
  for (std::size_t t = 16; t < rounds; ++t) {
    const Word s0 = std::rotr(w[t - 15], 7) ^ std::rotr(w[t - 15], 18) ^ (w[t - 15] >> 3);
    const Word s1 = std::rotr(w[t - 2], 17) ^ std::rotr(w[t - 2], 19) ^ (w[t - 2] >> 10);
    w[t] = w[t - 16] + s0 + w[t - 7] + s1;
  }
  auto [a, b, c, d, e, f, g, h] = state;
  for (std::size_t t = 0; t < rounds; ++t) {
    const Word s1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
    const Word s0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
    const Word first = h + s1 + ((e & f) ^ (~e & g)) + constants.added[t] + w[t];
    const Word second = s0 + ((a & b) ^ (a & c) ^ (b & c));
    h = g;
    g = f;
    f = e;
    e = d + first;
    d = c;
    c = b;
    b = a;
    a = first + second;
  }
  const std::array<Word, 8> mixed{a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < state.size(); ++i) state[i] += mixed[i];
}

}  // namespace

std::string sha256(std::string_view bytes) {
  static const Constants constants;
  std::array<Word, 8> state = constants.start;
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  const std::size_t whole = bytes.size() / block_bytes * block_bytes;
  for (std::size_t i = 0; i < whole; i += block_bytes) absorb(state, data + i, constants);
  // What is left, a one bit, zeros, the length in bits.
  std::array<unsigned char, 2 * block_bytes> tail{};
  const std::size_t left = bytes.size() - whole;
  for (std::size_t i = 0; i < left; ++i) tail[i] = data[whole + i];
  tail[left] = 0x80;
  const std::size_t tail_bytes = left + 9 <= block_bytes ? block_bytes : 2 * block_bytes;
  const std::uint64_t bits = 8 * static_cast<std::uint64_t>(bytes.size());
  for (std::size_t i = 0; i < 8; ++i) tail[tail_bytes - 1 - i] = static_cast<unsigned char>(bits >> (8 * i) & 0xff);
  for (std::size_t i = 0; i < tail_bytes; i += block_bytes) absorb(state, tail.data() + i, constants);
  std::string text;
  for (const Word word : state)
    for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[word >> shift & 0xf];
  return text;
}

}  // namespace ehd
