// SPDX-License-Identifier: GPL-3.0-or-later
// Digits printed = digits known.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ehd::verification {

/// A number with the digits that are known, and the uncertainty of just this text: its error and its rounding.
struct KnownDigits {
  std::string text;
  std::string relative;  ///< uncertainty over |text|, rounded up to two digits
  std::string absolute;
};

/// As many digits as leave `error` (absolute) below half a unit of the last one, at most 15; absent where not even the
/// first one is known, the value is 0, either is not finite, or the error is not positive.
[[nodiscard]] std::optional<KnownDigits> known_digits(double value, double error);

/// Significant digits in a decimal text.
[[nodiscard]] int count_digits(std::string_view text);

}  // namespace ehd::verification
