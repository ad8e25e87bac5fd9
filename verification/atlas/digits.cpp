// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/atlas/digits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "contact/text.hpp"

namespace ehd::verification {

namespace {

/// `value` to the decimal place 10^place, which is not above its first digit.
std::string rounded_text(double value, int leading, int place) {
  constexpr int largest_plain = 5, smallest_plain = -3;  // 999999 and 0.001; the exponent form beyond
  if (place <= 0 && leading <= largest_plain && leading >= smallest_plain) return fixed(value, -place);
  const std::string text = scientific(value, leading - place);
  const auto e = text.find('e');
  const int exponent = std::stoi(text.substr(e + 1));
  std::string mantissa = text.substr(0, e);
  if (exponent > leading) mantissa += leading > place ? "0" : ".0";  // 9.96e-5 to 1e-6 is 1.00e-4, not 1.0e-4
  return exponent == 0 ? mantissa : fmt::format("{}e{}", mantissa, exponent);
}

/// Two significant digits, rounded up: an uncertainty may grow, never shrink.
std::string rounded_up(double size) {
  const int leading = static_cast<int>(std::floor(std::log10(size)));
  constexpr double rounding = 1e-9;  // 1.2 is 1.2, not 1.3
  for (const int place : {leading - 1, leading}) {
    const double units = std::ceil(size / std::pow(10.0, place) * (1 - rounding));
    if (units > 99) continue;
    return plain(std::strtod(fmt::format("{:.0f}e{}", units, place).c_str(), nullptr), 2);
  }
  return plain(size, 2);
}

}  // namespace

std::optional<KnownDigits> known_digits(double value, double error) {
  constexpr int most_digits = 15;  // what a double holds
  if (!std::isfinite(value) || !std::isfinite(error) || !(error > 0) || value == 0) return std::nullopt;
  int place = static_cast<int>(std::floor(std::log10(2 * error)));
  while (!(error < 0.5 * std::pow(10.0, place))) ++place;
  const int leading = static_cast<int>(std::floor(std::log10(std::abs(value))));
  place = std::max(place, leading - most_digits + 1);
  if (place > leading) return std::nullopt;
  KnownDigits known{.text = rounded_text(value, leading, place), .relative = {}, .absolute = {}};
  const double printed = std::strtod(known.text.c_str(), nullptr);
  const double uncertainty = error + std::abs(printed - value);
  known.relative = rounded_up(uncertainty / std::abs(printed));
  known.absolute = rounded_up(uncertainty);
  return known;
}

int count_digits(std::string_view text) {
  int digits = 0;
  for (const char c : text.substr(0, text.find_first_of("eE"))) {
    if (c < '0' || c > '9') continue;
    if (digits > 0 || c != '0') ++digits;
  }
  return digits;
}

}  // namespace ehd::verification
