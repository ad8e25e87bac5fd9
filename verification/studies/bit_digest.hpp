// SPDX-License-Identifier: GPL-3.0-or-later
// A hash of numbers, 64 bits, FNV-1a: it changes with any bit of any of them.
#pragma once

#include <bit>
#include <cstdint>

namespace ehd::verification {

class BitDigest {
 public:
  void add(std::uint64_t bits) {
    constexpr std::uint64_t prime = 1099511628211u;
    for (int byte = 0; byte < 8; ++byte) value_ = (value_ ^ ((bits >> (8 * byte)) & 0xFF)) * prime;
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037u;
};

}  // namespace ehd::verification
