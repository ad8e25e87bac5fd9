// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and messages as people read them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ehd {

/// The shortest plain text of a number to `digits` significant ones: 0.001, 1e6, 2.2e-8.
[[nodiscard]] std::string plain(double value, int digits = 6);
/// The same of a positive number, rounded up: an error that is above a bound does not look like the bound.
[[nodiscard]] std::string rounded_up(double value, int digits);
/// Rounded down: what holds up to a number holds up to the printed one.
[[nodiscard]] std::string rounded_down(double value, int digits);

/// Digits printed = digits known: value 0.0741427, relative error 2e-4 -> "0.07414(2)", the bracket being the error
/// (rounded up) in units of the last digit. Without an error, or with one that is not finite: `plain`, 6 digits.
[[nodiscard]] std::string with_error(double value, std::optional<double> relative_error);
/// The same for an absolute error.
[[nodiscard]] std::string with_absolute_error(double value, std::optional<double> absolute_error);

/// So many decimals: "12.50"; with a sign, "+12.50"; with a power of ten, "1.25e+01".
[[nodiscard]] std::string fixed(double value, int decimals);
[[nodiscard]] std::string signed_fixed(double value, int decimals);
[[nodiscard]] std::string scientific(double value, int decimals);

/// A share in per cent, with the unit: "1.25 %".
[[nodiscard]] std::string percent(double share, int digits = 6);
/// A length in um or mm, with the unit.
[[nodiscard]] std::string micrometre(double metre, int digits = 4);
[[nodiscard]] std::string millimetre(double metre, int digits = 4);

/// The number at the beginning of a text that this program wrote, NaN where there is none. The host's locale does not
/// count: that of std::stod may want a comma.
[[nodiscard]] double number_in(std::string_view text);

/// Half a unit of the last digit of a decimal text, relative to the number ("0.0741" -> 0.00005/0.0741); absolute where
/// the number is 0.
[[nodiscard]] double relative_half_unit(std::string_view digits);

/// Control characters escaped (a line feed becomes \n), invalid UTF-8 bytes written as \xNN: always one line.
[[nodiscard]] std::string one_line(std::string_view text);

/// At most `length` bytes, cut between characters, "..." where something was cut.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t length);

/// The number of bytes of the well-formed UTF-8 character at the beginning of `text`, 0 where there is none.
[[nodiscard]] std::size_t utf8_length(std::string_view text);

}  // namespace ehd
