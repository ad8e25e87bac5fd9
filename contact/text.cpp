// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace ehd {

std::string plain(double value, int digits) {
  std::string text = fmt::format("{:.{}g}", value, digits);
  // 1e+06 -> 1e6, 2.2e-08 -> 2.2e-8
  if (const auto e = text.find('e'); e != std::string::npos) {
    std::string exponent = text.substr(e + 1);
    const bool negative = exponent.front() == '-';
    const auto first = exponent.find_first_not_of("+-0");
    exponent = first == std::string::npos ? "0" : exponent.substr(first);
    text = text.substr(0, e + 1) + (negative ? "-" : "") + exponent;
  }
  return text;
}

namespace {

/// 0.02 over its unit of 0.001 may be 20 + 4e-15.
constexpr double rounding_of_units = 1e-12;

double last_unit(double value, int digits) { return std::pow(10.0, std::floor(std::log10(value)) - digits + 1); }

bool has_digits(double value) { return value > 0 && std::isfinite(value); }

}  // namespace

std::string rounded_up(double value, int digits) {
  if (!has_digits(value)) return plain(value, digits);
  const double unit = last_unit(value, digits);
  return plain(std::ceil(value / unit * (1 - rounding_of_units)) * unit, digits);
}

std::string rounded_down(double value, int digits) {
  if (!has_digits(value)) return plain(value, digits);
  const double unit = last_unit(value, digits);
  return plain(std::floor(value / unit * (1 + rounding_of_units)) * unit, digits);
}

std::string with_absolute_error(double value, std::optional<double> absolute_error) {
  constexpr int most_digits = 15;  // what a double holds
  if (!std::isfinite(value) || !absolute_error || !std::isfinite(*absolute_error) || *absolute_error < 0)
    return plain(value);
  if (*absolute_error == 0 || value == 0) return plain(value, most_digits);
  if (*absolute_error >= std::abs(value)) {  // no digit is known; of the value, what the error's own digit leaves
    const double unit = std::pow(10.0, std::floor(std::log10(*absolute_error)));
    return fmt::format("{} (error {})", plain(std::round(value / unit) * unit + 0.0, 1),
                       rounded_up(*absolute_error, 1));
  }
  const int leading = static_cast<int>(std::floor(std::log10(std::abs(value))));
  // No digit beyond those of a double, nor below its smallest power of ten.
  const int deepest = std::max(leading - most_digits + 1, std::numeric_limits<double>::min_exponent10);
  int last = std::max(static_cast<int>(std::floor(std::log10(*absolute_error))), deepest);
  int units = static_cast<int>(std::ceil(*absolute_error / std::pow(10.0, last)));
  if (units > 9) {  // 9.3 units are 1 of the next digit
    units = 1;
    ++last;
  }
  constexpr int widest = 6;  // decimals before the exponent form takes over
  if (leading >= -3 && leading <= widest && last <= 0) return fmt::format("{:.{}f}({})", value, -last, units);
  const std::string text = scientific(value, std::max(leading - last, 0));
  const auto e = text.find('e');
  return fmt::format("{}({})e{}", text.substr(0, e), units, std::stoi(text.substr(e + 1)));
}

std::string with_error(double value, std::optional<double> relative_error) {
  if (!relative_error) return plain(value);
  return with_absolute_error(value, *relative_error * std::abs(value));
}

std::string fixed(double value, int decimals) { return fmt::format("{:.{}f}", value, decimals); }
std::string signed_fixed(double value, int decimals) { return fmt::format("{:+.{}f}", value, decimals); }
std::string scientific(double value, int decimals) { return fmt::format("{:.{}e}", value, decimals); }

double number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::string percent(double share, int digits) {
  return plain(number_in(plain(100 * share, digits))) + " %";  // 790 %, not 7.9e2 %
}
std::string micrometre(double metre, int digits) { return plain(1e6 * metre, digits) + " um"; }
std::string millimetre(double metre, int digits) { return plain(1e3 * metre, digits) + " mm"; }

double relative_half_unit(std::string_view digits) {
  const auto exponent_at = digits.find_first_of("eE");
  const std::string_view mantissa = digits.substr(0, exponent_at);
  const double exponent = exponent_at == std::string_view::npos ? 0 : number_in(digits.substr(exponent_at + 1));
  const auto point = mantissa.find('.');
  const double decimals = point == std::string_view::npos ? 0 : static_cast<double>(mantissa.size() - point - 1);
  const double half = 0.5 * std::pow(10.0, exponent - decimals);
  const double value = std::abs(number_in(digits));
  return value > 0 ? half / value : half;
}

std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (text.empty()) return 0;
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
  unsigned code = lead & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return 0;
    code = (code << 6) | (byte(i) & 0x3Fu);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return overlong || surrogate || code > 0x10FFFF ? 0 : length;
}

std::string one_line(std::string_view text) {
  if (std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; })) return std::string(text);
  std::string line;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text.substr(i));
    const auto byte = static_cast<unsigned char>(text[i]);
    // C0 and C1 control characters (C2 80 .. C2 9F), the two Unicode line separators and the marks that turn the
    // direction of writing (U+202A .. U+202E, U+2066 .. U+2069) would break, colour or reorder a line.
    const bool c1 = length == 2 && byte == 0xC2 && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    const std::string_view character = text.substr(i, length);
    const bool separator = length == 3 && ((character >= "\u2028" && character <= "\u202E") ||
                                           (character >= "\u2066" && character <= "\u2069"));
    if (text[i] == '\n') {
      line += "\\n";
    } else if (text[i] == '\t') {
      line += ' ';
    } else if (length == 0 || byte < 0x20 || byte == 0x7F) {
      line += fmt::format("\\x{:02X}", byte);
    } else if (c1 || separator) {
      line += '?';
    } else {
      line += character;
    }
    i += std::max<std::size_t>(length, 1);
  }
  return line;
}

std::string shortened(std::string_view text, std::size_t length) {
  if (text.size() <= length) return std::string(text);
  std::size_t end = length;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
  return std::string(text.substr(0, end)) + "...";
}

}  // namespace ehd
