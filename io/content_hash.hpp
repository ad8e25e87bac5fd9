// SPDX-License-Identifier: GPL-3.0-or-later
// SHA-256 (FIPS 180-4): names what a result was computed from, and tells a damaged line from a whole one.
#pragma once

#include <string>
#include <string_view>

namespace ehd {

/// 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256(std::string_view bytes);

}  // namespace ehd
