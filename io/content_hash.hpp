// SPDX-License-Identifier: GPL-3.0-or-later
// A hash that tells contents apart: which inputs a result was computed from, and a damaged line from a whole one. It
// has no security purpose; contents that are made to collide are not its concern.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ehd {

inline constexpr std::size_t content_hash_digits = 32;

/// XXH3, 128 bits (xxHash), as lower-case hexadecimal digits in the canonical order, high half first.
[[nodiscard]] std::string content_hash(std::string_view bytes);

}  // namespace ehd
