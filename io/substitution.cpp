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

/// The whole text as a number of that type; empty where it is none.
template <class Number>
std::optional<Number> whole_number(std::string_view text) {
  Number value = 0;
  const char* const end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, value);
  return parsed.ptr == end && parsed.ec == std::errc() ? std::optional(value) : std::nullopt;
}

/// "[2000, 12000]"; empty where the text is no list of numbers.
std::optional<std::vector<double>> list_of_numbers(std::string_view text) {
  if (!text.starts_with('[') || !text.ends_with(']')) return std::nullopt;
  std::vector<double> numbers;
  for (std::size_t begin = 1; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size() - 1);
    const std::string_view item = text.substr(begin, end - begin);
    const std::size_t first = std::min(item.find_first_not_of(' '), item.size());
    const auto number = whole_number<double>(item.substr(first, item.find_last_not_of(' ') + 1 - first));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    begin = end + 1;
  }
  return numbers;
}

}  // namespace

TomlValue toml_value(std::string_view text) {
  const bool in_quotes = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  if (in_quotes) return std::string(text.substr(1, text.size() - 2));
  const std::string_view number = without_plus(text);
  if (const auto whole = whole_number<std::int64_t>(number)) return *whole;
  if (const auto real = whole_number<double>(number)) return *real;
  if (auto numbers = list_of_numbers(text)) return std::move(*numbers);
  return std::string(text);
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
