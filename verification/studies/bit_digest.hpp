// SPDX-License-Identifier: GPL-3.0-or-later
// The hash (io/content_hash) of the bits of numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "io/content_hash.hpp"

namespace ehd::verification {

class BitDigest {
 public:
  void add(double value) { add_bytes(&value, sizeof value); }
  void add(std::uint64_t value) { add_bytes(&value, sizeof value); }
  [[nodiscard]] std::string text() const { return content_hash(bytes_); }

 private:
  void add_bytes(const void* first, std::size_t size) { bytes_.append(static_cast<const char*>(first), size); }
  std::string bytes_;
};

}  // namespace ehd::verification
