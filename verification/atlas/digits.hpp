// SPDX-License-Identifier: GPL-3.0-or-later
// Decimal texts with as many digits as are known.
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

/// So many digits that `error` (absolute) is below half a unit of the last one, at most 15. Absent where no digit is
/// known, the value is 0, value or error is not finite, or the error is not positive.
[[nodiscard]] std::optional<KnownDigits> known_digits(double value, double error);

/// Significant digits in a decimal text.
[[nodiscard]] int count_digits(std::string_view text);

}  // namespace ehd::verification
