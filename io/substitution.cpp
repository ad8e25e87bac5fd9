// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/substitution.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>

#include "contact/overloaded.hpp"

namespace ehd {

namespace {

std::string text_of_number(double value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  const std::string shortest(text, end);
  return shortest.find_first_of(".e") == std::string::npos ? shortest + ".0" : shortest;
}

std::string quoted(const std::string& content) {
  std::string text = "\"";
  for (const char c : content) text += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
  return text + "\"";
}

/// The whole text as a number of that type; empty where it is none.
template <class Number>
std::optional<Number> whole_number(std::string_view text) {
  Number value = 0;
  const char* const end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, value);
  return parsed.ptr == end && parsed.ec == std::errc() ? std::optional(value) : std::nullopt;
}

}  // namespace

TomlValue toml_value(std::string_view text) {
  const bool in_quotes = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  if (in_quotes) return std::string(text.substr(1, text.size() - 2));
  const std::string_view number = text.substr(text.starts_with('+') ? 1 : 0);
  if (const auto whole = whole_number<std::int64_t>(number)) return *whole;
  if (const auto real = whole_number<double>(number)) return *real;
  return std::string(text);
}

std::string toml_text(const TomlValue& value) {
  return std::visit(Overloaded{[](std::int64_t whole) { return std::to_string(whole); },
                               [](double real) { return text_of_number(real); },
                               [](const std::string& content) { return quoted(content); }},
                    value);
}

}  // namespace ehd
