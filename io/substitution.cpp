// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/substitution.hpp"

#include <charconv>
#include <cmath>

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

}  // namespace

std::string toml_text(const TomlValue& value) {
  return std::visit(Overloaded{[](std::int64_t whole) { return std::to_string(whole); },
                               [](double real) { return text_of_number(real); },
                               [](const std::string& content) { return quoted(content); }},
                    value);
}

}  // namespace ehd
