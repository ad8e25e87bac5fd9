// SPDX-License-Identifier: GPL-3.0-or-later
// A hash of a text. It tells which inputs a result was computed from, and whether a stored line is damaged. It gives no
// security: somebody can make two texts with one hash.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ehd {

inline constexpr std::size_t content_hash_digits = 32;

/// XXH3, 128 bits (xxHash), as lower-case hexadecimal digits in the canonical order, high half first.
[[nodiscard]] std::string content_hash(std::string_view bytes);

}  // namespace ehd
