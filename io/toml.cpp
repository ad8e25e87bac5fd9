// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/toml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string_view>

#include "contact/text.hpp"
#include "io/case_keys.hpp"
#include "io/case_text.hpp"
#include "io/near_miss.hpp"
#include "workflow/case.hpp"

namespace ehd {

namespace {

constexpr std::size_t longest_text = 60;  // of a value in a message

/// Where the column-th character of a line begins.
std::size_t byte_of_column(std::string_view line, std::size_t column) {
  std::size_t i = 0;
  for (std::size_t c = 1; c < column && i < line.size(); ++c)
    i += static_cast<unsigned char>(line[i]) < 0x80 ? 1 : std::max<std::size_t>(utf8_length(line.substr(i)), 1);
  return std::min(i, line.size());
}

std::string trimmed(std::string_view line) {
  const auto begin = line.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return "";
  return std::string(line.substr(begin, line.find_last_not_of(" \t") - begin + 1));
}

std::string sizes_of_numbers() {
  using Limits = std::numeric_limits<double>;
  return fmt::format("a size of {} to {}", plain(Limits::min(), 2), plain(Limits::max(), 2));
}

/// A line without its comment. A line with a quotation mark before the first # is left as it is: the # may stand in a
/// text.
std::string_view without_comment(std::string_view line) {
  const std::string_view before = line.substr(0, line.find('#'));
  return before.find_first_of("\"'") == std::string_view::npos ? before : line;
}

/// The text of the value in the file: its first line.
std::string source_of(const toml::node& node, const std::vector<std::string>& lines) {
  const auto& region = node.source();
  const auto first = static_cast<std::size_t>(region.begin.line);
  if (first < 1 || first > lines.size()) return "";
  const std::string& line = lines[first - 1];
  const std::size_t begin = byte_of_column(line, region.begin.column);
  const bool one = region.end.line == region.begin.line;
  const std::size_t end = one ? byte_of_column(line, region.end.column) : line.size();
  return line.substr(begin, std::max(begin, end) - begin);
}

/// What the key of a line "key = value" may hold, where that is a number and no text; empty elsewhere. `table`: the
/// header above the line.
std::string number_allowed(std::string_view table, std::string_view line) {
  const CaseTable* const row = find_case_table(table);
  const std::string name = trimmed(line.substr(0, line.find('=')));
  if (!row) return "";
  for (const CaseKey& key : row->keys) {
    const bool number = std::holds_alternative<Interval>(key.allowed) ||
                        std::holds_alternative<allowed::Integer>(key.allowed) ||
                        std::holds_alternative<allowed::OneOf>(key.allowed);
    if (key.name == name) return number ? fmt::format("{}, for example {}", text_of(key.allowed), key.example) : "";
  }
  return "";
}

/// The table that the line stands in; empty above the first.
std::string table_above(const std::vector<std::string>& lines, int line) {
  for (int i = line - 1; i >= 0; --i) {
    const std::string content = trimmed(lines[static_cast<std::size_t>(i)]);
    if (!content.starts_with('[')) continue;
    const auto first = content.find_first_not_of("[ ");
    return first == std::string::npos ? "" : content.substr(first, content.find_first_of(" ]", first) - first);
  }
  return "";
}

/// What is wrong with a line "key = value" that is no TOML, and what is allowed, in the words of its writer. Empty
/// where it is none of the usual slips.
std::string slip_of(std::string_view line, std::string_view table) {
  constexpr std::string_view latin = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ", decimal = "0123456789";
  const auto equals = line.find('=');
  if (equals == std::string_view::npos || line.find('=', equals + 1) != std::string_view::npos) return "";
  const std::string value = trimmed(line.substr(equals + 1, line.find('#') - equals - 1));
  const auto begins_with = [](std::string_view text, std::string_view any) {
    return !text.empty() && any.find(text.front()) != std::string_view::npos;
  };
  // A value of these words is TOML: the line is wrong elsewhere.
  const auto begins_with_value = [&](std::string_view text) {
    const std::string_view word = text.substr(0, text.find_first_not_of(latin));
    return word == "nan" || word == "inf" || word == "true" || word == "false";
  };
  const auto number = value.find_first_not_of("+-.eE_0123456789");
  if (begins_with_value(value)) return "";
  const std::string wanted = number_allowed(table, line);
  if (value.empty() && !wanted.empty()) return "has no value; allowed is " + wanted;
  if (begins_with(value, latin)) {
    if (!wanted.empty()) return "is a text; allowed is " + wanted;
    return value.find_first_of(" \"'") == std::string::npos
               ? "is a text without quotation marks; allowed is \"" + value + "\""
               : "";
  }
  if (!begins_with(value, decimal) && !begins_with(value, "+-.")) return "";
  const std::string no_number = wanted.empty() ? "" : "is no number in TOML; allowed is " + wanted;
  if (number == std::string::npos) return no_number;
  const std::string_view prefix = std::string_view(value).substr(value.find_first_not_of("+-"), 2);
  if (prefix == "0x" || prefix == "0o" || prefix == "0b")
    return "is no hexadecimal, octal or binary number; allowed is a decimal number";
  const std::string rest = trimmed(std::string_view(value).substr(number));
  if (begins_with_value(rest)) return "";
  if (const std::string comma = comma_in_number(value); !comma.empty()) return comma;
  if (begins_with(rest, ",") && !wanted.empty()) return std::string(several_numbers) + "; allowed is " + wanted;
  if ((begins_with(rest, latin) && !begins_exponent(rest)) || begins_with(rest, "%"))
    return "has a unit; allowed is the number alone, in the unit that the key names";
  return no_number;
}

}  // namespace

std::vector<std::pair<std::string, const toml::node*>> unknown_keys(const toml::table& table,
                                                                    const std::vector<std::string>& allowed) {
  std::vector<std::pair<std::string, const toml::node*>> unknown;
  for (auto&& [key, node] : table)
    if (std::find(allowed.begin(), allowed.end(), key.str()) == allowed.end())
      unknown.emplace_back(std::string(key.str()), &node);
  std::stable_sort(unknown.begin(), unknown.end(),
                   [](const auto& one, const auto& other) { return line_of(*one.second) < line_of(*other.second); });
  return unknown;
}

const toml::value<std::int64_t>* decimal_integer(const toml::node& node) {
  constexpr auto other_base = toml::value_flags::format_as_hexadecimal | toml::value_flags::format_as_octal |
                              toml::value_flags::format_as_binary;
  const auto* whole = node.as_integer();
  return whole && (whole->flags() & other_base) == toml::value_flags::none ? whole : nullptr;
}

std::string type_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table: return "a table";
    case toml::node_type::array: return "an array";
    case toml::node_type::string: return "a text";
    case toml::node_type::integer: return decimal_integer(node) ? "an integer" : "no decimal number";
    case toml::node_type::floating_point: return "a number";
    case toml::node_type::boolean: return "a boolean";
    default: return "a date or time";
  }
}

int line_of(const toml::node& node) { return std::max(1, static_cast<int>(node.source().begin.line)); }

std::string text_of(const toml::node& node, const std::vector<std::string>& lines) {
  if (line_of(node) > static_cast<int>(lines.size())) return "";
  const bool one = node.source().end.line == node.source().begin.line;
  return shortened(source_of(node, lines), longest_text) + (one ? "" : "...");
}

toml::table parse_toml(const std::string& text, const std::filesystem::path& file) {
  try {
    return toml::parse(std::string_view(text));
  } catch (const toml::parse_error& error) {
    const std::vector<std::string> lines = lines_of(text);
    const auto content_of = [&](int line) {
      return trimmed(without_comment(lines[static_cast<std::size_t>(line - 1)]));
    };
    int line = std::clamp(static_cast<int>(error.source().begin.line), 1, static_cast<int>(lines.size()));
    std::string what(error.description());
    // "Error while parsing key-value pair: cannot redefine existing integer 'a'"
    if (const auto colon = what.find(": "); colon != std::string::npos && what.starts_with("Error while parsing"))
      what = what.substr(colon + 2);
    const bool duplicate = what.find("cannot redefine") != std::string::npos;
    const bool too_large = what.find("is not representable in 64 bits") != std::string::npos;
    std::string allowed = "allowed is TOML";
    if (duplicate) {
      // toml++ 3.3.0 may garble a name in quotation marks in its description; the line shows it correctly.
      what = "is a duplicate (" + what.substr(0, what.find(" '")) + ")";
      allowed = "allowed is each key and each table once";
    } else if (what.find("unescaped control characters") != std::string::npos) {
      what = "a text is not closed on its line";
    } else if (too_large) {
      const bool integer = error.description().find(" integer: ") != std::string_view::npos;
      what = integer ? "is too large for an integer" : "is too large or too small for a number";
      allowed = integer ? fmt::format("allowed is a size of up to {}, or a number with a decimal point",
                                      std::numeric_limits<std::int64_t>::max())
                        : "allowed is 0, or " + sizes_of_numbers();
      if (const std::string of_key = number_allowed(table_above(lines, line), content_of(line)); !of_key.empty())
        allowed = "allowed is " + of_key;
    } else if (what.find("encountered end-of-file") != std::string::npos) {
      what = "the file ends in the middle (" + what + ")";
      while (line > 1 && content_of(line).empty()) --line;
    }
    // Only a line that looks like a key or a table is repeated: another file may be private.
    const std::string content = content_of(line);
    const bool ours = content.find('=') != std::string::npos || content.starts_with('[');
    const std::string source = ours ? shortened(content, longest_text) : "";
    const std::string slip = too_large || duplicate ? "" : slip_of(content, table_above(lines, line)),
                      says = slip.empty() ? shortened(what, 200) + "; " + allowed : slip;
    throw CaseError(one_line(
        fmt::format("{}:{}{}: {}", file.string(), line, source.empty() ? "" : ": " + source, shortened(says, 300))));
  }
}

}  // namespace ehd
