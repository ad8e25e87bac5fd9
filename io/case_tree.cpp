// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "contact/overloaded.hpp"
#include "contact/text.hpp"
#include "io/case_keys.hpp"
#include "io/case_text.hpp"
#include "io/near_miss.hpp"
#include "io/toml.hpp"

namespace ehd {

namespace {

constexpr std::size_t longest_text = 60;  // of a key in a message
constexpr int not_of_the_file = 0;        // the line of a substituted value: messages name none

CaseNode node_of(const toml::node& node) {
  CaseNode made{.type = type_of(node)};
  if (const auto* whole = decimal_integer(node)) made.content = whole->get();
  if (const auto* real = node.as_floating_point()) made.content = real->get();
  if (const auto* text = node.as_string()) made.content = text->get();
  if (const auto* array = node.as_array()) {
    std::vector<CaseNode> items;
    for (const toml::node& item : *array) items.push_back(node_of(item));
    made.content = std::move(items);
  }
  return made;
}

CaseNode node_of_list(const std::vector<double>& numbers) {
  std::vector<CaseNode> items;
  for (const double one : numbers) items.push_back({.type = "a number", .content = one});
  return {.type = "a list", .content = std::move(items)};
}

CaseNode node_of(const TomlValue& value) {
  return std::visit(Overloaded{[](std::int64_t whole) { return CaseNode{.type = "an integer", .content = whole}; },
                               [](double real) { return CaseNode{.type = "a number", .content = real}; },
                               [](const std::string& text) { return CaseNode{.type = "a text", .content = text}; },
                               [](const std::vector<double>& numbers) { return node_of_list(numbers); }},
                    value);
}

std::vector<std::string> names_of_substitutable_tables() {
  std::vector<std::string> names;
  for (const CaseTable& table : case_tables()) {
    if (is_substitutable(table)) names.emplace_back(table.name);
  }
  return names;
}

std::vector<std::string> substitutable_paths() {
  std::vector<std::string> paths;
  for (const CaseTable& table : case_tables())
    for (const CaseKey& key : table.keys)
      if (is_substitutable(table)) paths.push_back(fmt::format("{}.{}", table.name, key.name));
  return paths;
}

/// "table.key" in two parts; the second is empty where there is no dot.
std::pair<std::string, std::string> parts_of(const std::string& path) {
  const auto dot = path.find('.');
  return {path.substr(0, dot), dot == std::string::npos ? "" : path.substr(dot + 1)};
}

/// What an unknown key may have been meant to be: a path, and its words in a message. Empty where nothing is near.
struct Meant {
  std::string path, words;
};

/// " (E', not Young's modulus: ...)": what the suggested key is. Nothing where the key was only mistyped.
std::string in_words(const std::string& given, const std::string& path) {
  if (path.find('.') == std::string::npos || find_case_table(path)) return "";
  const CaseKey& row = row_of_case_key(path);
  if (is_mistyped(given, std::string(row.name))) return "";
  return fmt::format(" ({})", row.what());
}

/// Both can stand in one case.
bool stand_together(const CaseTable& one, const CaseTable& other) {
  const bool two_statements = one.role == TableRole::statement && other.role == TableRole::statement;
  return !two_statements && ((one.in_contact && other.in_contact) || (one.in_bearing && other.in_bearing));
}

/// A key of another table than the one where it stands. First come the tables that such a case has to have, with their
/// near keys too, then those that it may have, then all.
Meant meant_elsewhere(const std::string& key, const std::string& table_name) {
  const CaseTable* const table = find_case_table(table_name);
  const auto may_stand = [table](const CaseTable& other) { return table && stand_together(*table, other); };
  const auto has_to_stand = [&](const CaseTable& other) { return may_stand(other) && other.required; };
  const auto any = [](const CaseTable&) { return true; };
  const auto found = [&](const auto& admits, bool exactly) -> Meant {
    for (const CaseTable& other : case_tables()) {
      if (other.name.empty() || other.name == table_name || !admits(other)) continue;
      const auto names = names_of_keys(other);
      const bool has_it = std::find(names.begin(), names.end(), key) != names.end();
      const std::string name = has_it ? key : exactly ? "" : near_miss(key, names);
      if (!name.empty()) {
        const std::string path = fmt::format("{}.{}", other.name, name);
        return {.path = path, .words = fmt::format("{} in [{}]{}", name, other.name, in_words(key, path))};
      }
    }
    return {};
  };
  for (Meant meant : {found(has_to_stand, true), found(has_to_stand, false), found(may_stand, true), found(any, true)})
    if (!meant.path.empty()) return meant;
  return {};
}

Meant meant_by(const std::string& key, const std::string& table, bool is_table,
               const std::vector<std::string>& allowed) {
  if (const std::string name = near_miss(key, allowed); !name.empty()) {
    const std::string path = table.empty() ? name : table + "." + name;
    return {.path = path, .words = find_case_table(name) && is_table ? "[" + name + "]" : name + in_words(key, path)};
  }
  return meant_elsewhere(key, table);
}

/// What an unknown "table.key" may have been meant to be, in words; empty where nothing is near.
std::string words_meant_by(const std::string& path, bool in_contact) {
  const auto [table, key] = parts_of(path);
  if (const CaseTable* row = find_case_table(table); row && is_substitutable(*row)) {
    if (const std::string name = near_miss(key, names_of_keys(*row, in_contact)); !name.empty())
      return name + in_words(key, fmt::format("{}.{}", table, name));
    const std::string other = meant_elsewhere(key, table).path;
    const CaseTable* found = find_case_table(parts_of(other).first);
    return found && is_substitutable(*found) ? other + in_words(key, other) : "";
  }
  const std::string other = near_miss(path, substitutable_paths());
  return other + in_words(key.empty() ? path : key, other);
}

/// Whether a case file has the key, although it keeps its value: those above the first table, and what is expected.
bool keeps_its_value(const std::string& table_name, const std::string& key) {
  const CaseTable* table = find_case_table(key.empty() ? "" : table_name);
  if (!table || is_substitutable(*table)) return false;
  const std::vector<std::string> keys = names_of_keys(*table);
  return std::find(keys.begin(), keys.end(), key.empty() ? table_name : key) != keys.end();
}

void require_substitutable(const Substitution& substitution, bool in_contact) {
  const std::string& path = substitution.key;
  const auto [table_name, key] = parts_of(path);
  const CaseTable* table = find_case_table(table_name);
  if (table && !is_substitutable(*table)) table = nullptr;
  const std::vector<std::string> keys = table ? names_of_keys(*table) : std::vector<std::string>();
  if (std::find(keys.begin(), keys.end(), key) != keys.end()) return;
  const std::string allowed = table ? list(names_of_keys(*table, in_contact))
                                    : "table.key with one of the tables " + list(names_of_substitutable_tables());
  const std::string fault = keeps_its_value(table_name, key) ? "cannot be given another value"
                            : table                          ? fmt::format("is unknown in [{}]", table_name)
                                                             : "is unknown";
  const std::string meant = words_meant_by(path, in_contact);
  const std::string subject =
      substitution.option.empty() ? shortened(path, longest_text) : "ehd: " + substitution.option;
  throw CaseError(one_line(fmt::format("{}: {}; {}allowed is {}", subject, fault,
                                       meant.empty() ? "" : "did you mean " + meant + "? ", allowed)));
}

/// Whether the key may stand in the table. Above the first table the names of tables may stand, too.
bool may_stand_in(const CaseTable& table, std::string_view key) {
  const auto named = [key](const auto& row) { return row.name == key; };
  return std::any_of(table.keys.begin(), table.keys.end(), named) ||
         (table.role == TableRole::heading && !key.empty() && find_case_table(key));
}
std::vector<std::string> names_in(const CaseTable& table, bool in_contact) {
  std::vector<std::string> names = names_of_keys(table, in_contact);
  if (table.role != TableRole::heading) return names;
  for (const CaseTable& other : case_tables())
    if (other.role != TableRole::heading) names.emplace_back(other.name);
  return names;
}

/// Whether the file states a contact, where [lubricant] has fewer keys than in a bearing.
bool states_contact(const toml::table& root) {
  const auto tables = case_tables();
  return std::any_of(tables.begin(), tables.end(), [&root](const CaseTable& table) {
    return table.role == TableRole::statement && table.in_contact && root.contains(table.name);
  });
}

}  // namespace

/// Goes through the parser's tree once and puts its nodes into a CaseTree.
class TreeBuilder {
 public:
  TreeBuilder(CaseTree& tree, const std::string& text) : tree_(tree), lines_(lines_of(text)) {}

  void add(const toml::table& root) {
    in_contact_ = states_contact(root);
    add_keys(root, "", *find_case_table(""));
    for (auto&& [name, node] : root) {
      const CaseTable* table = find_case_table(name.str());
      if (!table && node.is_table()) table = table_meant_by(std::string(name.str()), *node.as_table(), root);
      if (!table || table->role == TableRole::heading) continue;
      if (table->role == TableRole::expectation)
        add_expectations(node, *table);
      else
        add_table(node, *table);
    }
  }

 private:
  /// The table that a mistyped name was probably meant to be, so that the faults of its keys are found too. Null where
  /// nothing is near, where it has keys and none is near one of that table, and where the file has that table as well.
  [[nodiscard]] const CaseTable* table_meant_by(const std::string& name, const toml::table& content,
                                                const toml::table& root) const {
    const std::string meant = meant_by(name, "", true, names_in(*find_case_table(""), in_contact_)).path;
    const CaseTable* const table = meant.empty() ? nullptr : find_case_table(meant);
    const bool keyed = table && table->role != TableRole::heading && table->role != TableRole::expectation;
    if (!keyed || root.contains(meant) || tree_.has(meant)) return nullptr;
    const std::vector<std::string> names = names_of_keys(*table, in_contact_);
    const auto is_near = [&names](const auto& entry) {
      return !near_miss(std::string(entry.first.str()), names).empty();
    };
    return content.empty() || std::ranges::any_of(content, is_near) ? table : nullptr;
  }

  void add_table(const toml::node& node, const CaseTable& table) {
    const std::string name(table.name);
    if (!node.is_table()) tree_.fail(name, fmt::format("is {}; allowed is a table, [{}]", type_of(node), name));
    if (!tree_.has(name)) put(name, node);  // under its right name, where it is mistyped
    add_keys(*node.as_table(), name, table);
  }

  void add_expectations(const toml::node& node, const CaseTable& table) {
    const std::string name(table.name);
    const toml::array* array = node.as_array();
    if (!array || !std::all_of(array->begin(), array->end(), [](const toml::node& n) { return n.is_table(); }))
      tree_.fail(name, fmt::format("is {}; allowed is [[expect]], a table for each expectation", type_of(node)));
    for (const toml::node& entry : *array) {
      const std::string path = fmt::format("{}.{}", name, tree_.expectations_++);
      put(path, entry);
      add_keys(*entry.as_table(), path, table);
    }
  }

  void add_keys(const toml::table& table, const std::string& path, const CaseTable& row) {
    const auto known = [&](const auto& entry) { return may_stand_in(row, entry.first.str()); };
    if (!std::all_of(table.begin(), table.end(), known)) keep_unknown(table, path, names_in(row, in_contact_));
    for (auto&& [key, node] : table) {
      put(std::string(path).append(path.empty() ? "" : ".").append(key.str()), node);
    }
  }

  void put(std::string path, const toml::node& node) {
    tree_.put(std::move(path), node_of(node),
              {.line = line_of(node), .text = node.is_table() ? "" : text_of(node, lines_)});
  }

  void keep_unknown(const toml::table& table, const std::string& path, const std::vector<std::string>& allowed) {
    const std::string where = path.empty() ? "" : path.starts_with("expect") ? " in [[expect]]" : " in [" + path + "]";
    for (const auto& [key, node] : unknown_keys(table, allowed)) {
      std::string subject = key;
      if (!node->is_table()) subject += " = " + text_of(*node, lines_);
      if (node->is_table() && path.empty()) subject = "[" + subject + "]";
      const Meant meant = meant_by(key, path, node->is_table(), allowed);
      tree_.unknown_.push_back({.line = line_of(*node),
                                .message = one_line(fmt::format(
                                    "{}:{}: {}: is unknown{}; {}allowed is {}", tree_.places_.file.string(),
                                    line_of(*node), shortened(subject, 2 * longest_text), where,
                                    meant.words.empty() ? "" : "did you mean " + meant.words + "? ", list(allowed))),
                                .meant = meant.path});
    }
  }

  CaseTree& tree_;
  std::vector<std::string> lines_;
  bool in_contact_ = false;
};

CaseTree::CaseTree(const std::string& text, const std::filesystem::path& file,
                   const std::vector<Substitution>& substitutions) {
  places_.file = file.empty() ? nameless_case : file;
  places_.places[""].line = 1;
  toml::table root = parse_toml(text, places_.file);
  if (const auto id = root["id"].value<std::string>(); id && file.empty()) places_.file = *id + ".toml";
  for (const Substitution& substitution : substitutions) require_substitutable(substitution, states_contact(root));
  if (!substitutions.empty()) root.erase("expect");
  TreeBuilder(*this, text).add(root);
  std::stable_sort(unknown_.begin(), unknown_.end(),
                   [](const UnknownKey& one, const UnknownKey& other) { return one.line < other.line; });
  for (const Substitution& substitution : substitutions) substitute(substitution);
}

void CaseTree::put(std::string path, CaseNode node, CasePlace place) {
  nodes_.insert_or_assign(path, std::move(node));
  places_.places.insert_or_assign(std::move(path), std::move(place));
}

void CaseTree::substitute(const Substitution& substitution) {
  const std::string table = parts_of(substitution.key).first;
  if (!has(table)) {
    put(table, {.type = "a table"}, {.line = not_of_the_file});
    if (!substitution.option.empty()) places_.given[table] = substitution.option;
  }
  if (!substitution.option.empty()) places_.given[substitution.key] = substitution.option;
  put(substitution.key, node_of(substitution.value), {.line = not_of_the_file, .text = toml_text(substitution.value)});
}

std::optional<double> CaseNode::number() const {
  if (const auto* whole = std::get_if<std::int64_t>(&content)) return static_cast<double>(*whole);
  if (const auto* real = std::get_if<double>(&content)) return *real;
  return std::nullopt;
}

const CaseNode* CaseTree::find(std::string_view path) const {
  const auto at = nodes_.find(path);
  return at == nodes_.end() ? nullptr : &at->second;
}

void CaseTree::move_places_to(Case& made) && {
  made.places = std::move(places_.places);
  made.given = std::move(places_.given);
}

void CaseTree::fail(std::string_view path, const std::string& message) const {
  throw case_error(places_, std::string(path), message);
}

}  // namespace ehd
