// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/substitution.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include "contact/overloaded.hpp"
#include "io/near_miss.hpp"
#include "io/program_text.hpp"
#include "io/toml.hpp"
#include "workflow/case.hpp"

namespace ehd {

namespace {

std::string text_of_number(double value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
  const std::string text = shortest(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string quoted(const std::string& content) {
  std::string text = "\"";
  for (const char c : content) text += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
  return text + "\"";
}

/// Absent where one of them is no number.
std::optional<std::vector<double>> list_of_numbers(const toml::array& array) {
  std::vector<double> numbers;
  for (const toml::node& item : array) {
    const auto* whole = decimal_integer(item);
    const auto* real = item.as_floating_point();
    if (!whole && !real) return std::nullopt;
    numbers.push_back(whole ? static_cast<double>(whole->get()) : real->get());
  }
  return numbers;
}

/// What a line "key = TEXT" of a case file holds; absent where that is no TOML, or of a type that a case has nowhere.
std::optional<TomlValue> value_in_a_file(std::string_view text) {
  const auto printable = [](char c) { return c >= ' ' && c <= '~'; };  // on one line, too
  if (!std::all_of(text.begin(), text.end(), printable)) return std::nullopt;
  try {
    const toml::table line = parse_toml("key = " + std::string(text), "");
    const toml::node& node = *line.get("key");
    if (const auto* whole = decimal_integer(node)) return whole->get();
    if (const auto* real = node.as_floating_point()) return real->get();
    if (const auto* content = node.as_string()) return content->get();
    if (const auto* array = node.as_array())
      if (auto numbers = list_of_numbers(*array)) return std::move(*numbers);
  } catch (const CaseError&) {
  }
  return std::nullopt;
}

/// An integer of more than 64 bits, so that the refusal can name the key's range. A case has no key for numbers as
/// large.
std::optional<double> beyond_integers(std::string_view text) {
  const std::string_view digits = without_plus(text);
  const auto first = std::min(digits.find_first_of("123456789"), digits.size());
  if (first != (digits.starts_with('-') ? 1U : 0U)) return std::nullopt;
  if (digits.find_first_not_of("0123456789", first) != std::string_view::npos) return std::nullopt;
  double value = 0;
  const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return parsed.ec == std::errc() && !digits.empty() ? std::optional(value) : std::nullopt;
}

}  // namespace

TomlValue toml_value(std::string_view text) {
  const auto begin = std::min(text.find_first_not_of(' '), text.size());
  text = text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
  if (auto value = value_in_a_file(text)) return std::move(*value);
  if (const auto number = beyond_integers(text)) return *number;
  const bool in_quotes = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return std::string(in_quotes ? text.substr(1, text.size() - 2) : text);
}

std::string toml_text(const TomlValue& value) {
  return std::visit(Overloaded{[](std::int64_t whole) { return std::to_string(whole); },
                               [](double real) { return text_of_number(real); },
                               [](const std::string& content) { return quoted(content); },
                               [](const std::vector<double>& numbers) {
                                 std::string list;
                                 for (const double one : numbers)
                                   list += (list.empty() ? "" : ", ") + text_of_number(one);
                                 return "[" + list + "]";
                               }},
                    value);
}

}  // namespace ehd
