// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "contact/overloaded.hpp"
#include "contact/text.hpp"

namespace ehd {

bool Interval::contains(double x) const {
  return (or_zero && x == 0) || ((open_low ? x > low : x >= low) && x <= high);
}

std::string Interval::text() const {
  return fmt::format("{}{}{} to {}", or_zero ? "0, or " : "", open_low ? "more than " : "", plain(low), plain(high));
}

std::string text_of(const Allowed& allowed) {
  return std::visit(
      Overloaded{
          [](const Interval& interval) { return "a number, " + interval.text(); },
          [](const allowed::Integer& range) { return fmt::format("an integer, {} to {}", range.low, range.high); },
          [](const allowed::Pair&) { return std::string("[low, high], contact forces with 0 < low < high"); },
          [](const allowed::OneOf& few) { return fmt::format("one of {}", fmt::join(few.numbers(), ", ")); },
          [](const allowed::Word& word) { return quoted_list(word.words()); },
          [](const allowed::Text& text) { return std::string(text.what); },
          [](const allowed::Inlet& inlet) {
            return fmt::format("\"{}\", or X = x/b before the contact, {} to less than {}", inlet.word,
                               plain(inlet.farthest), plain(inlet.edge));
          },
      },
      allowed);
}

const CaseTable* find_case_table(std::string_view name) {
  const auto tables = case_tables();
  const auto at = std::find_if(tables.begin(), tables.end(), [&](const auto& table) { return table.name == name; });
  return at == tables.end() ? nullptr : &*at;
}

const CaseKey& row_of_case_key(std::string_view path) {
  const auto first = path.find('.');
  const CaseTable* table = find_case_table(first == std::string_view::npos ? "" : path.substr(0, first));
  const std::string_view name = path.substr(path.rfind('.') + 1);  // npos + 1 = 0
  if (table) {
    const auto at =
        std::find_if(table->keys.begin(), table->keys.end(), [&](const auto& key) { return key.name == name; });
    if (at != table->keys.end()) return *at;
  }
  throw std::logic_error("the table of case keys has no row for " + std::string(path));
}

std::vector<std::string> names_of_keys(const CaseTable& table, bool in_contact_case) {
  std::vector<std::string> names;
  for (const CaseKey& key : table.keys) {
    if (!(in_contact_case && key.bearing_only)) names.emplace_back(key.name);
  }
  return names;
}

std::vector<std::string> names_of_companions(bool of_bearing) {
  std::vector<std::string> names;
  for (const CaseTable& table : case_tables()) {
    if (table.role == TableRole::companion && (of_bearing ? table.in_bearing : table.in_contact))
      names.emplace_back(table.name);
  }
  return names;
}

bool is_substitutable(const CaseTable& table) {
  return table.role == TableRole::statement || table.role == TableRole::companion;
}

std::string quoted_list(const std::vector<std::string>& items) {
  std::string quoted;
  for (const auto& item : items) quoted += (quoted.empty() ? "\"" : ", \"") + item + "\"";
  return quoted;
}

std::string list(const std::vector<std::string>& items) { return fmt::format("{}", fmt::join(items, ", ")); }

}  // namespace ehd
