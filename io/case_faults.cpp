// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "io/case_keys.hpp"
#include "io/case_tree.hpp"
#include "io/read_oil.hpp"

namespace ehd {

namespace {

bool lubricated(const CaseTree& tree) { return tree.has("lubricant") || tree.has("domain"); }
/// The case states its oil by grade, or means to with a mistyped key; that key is named as unknown.
bool means_grade(const CaseTree& tree) {
  return states_grade(tree) ||
         std::ranges::any_of(tree.unknown(), [](const UnknownKey& key) { return is_grade_key(key.meant); });
}
bool states_both_speeds(const CaseTree& tree) {
  return tree.has("operation.inner_speed_rpm") || tree.has("operation.outer_speed_rpm");
}
/// False beside speed_rpm or rotating, which contradict these speeds: the reader says so.
bool states_only_both_speeds(const CaseTree& tree) {
  return states_both_speeds(tree) && !tree.has("operation.speed_rpm") && !tree.has("bearing.rotating");
}

/// A key that only some cases need, where the presence of other keys decides.
struct NeededKey {
  std::string_view path;
  bool (*needed)(const CaseTree& tree);
};
constexpr std::array needed_keys{
    NeededKey{"conditions.speed_sum_m_per_s", [](const CaseTree& tree) { return lubricated(tree); }},
    NeededKey{"conditions.viscosity_Pa_s", [](const CaseTree& tree) { return lubricated(tree) && !means_grade(tree); }},
    NeededKey{"bearing.rotating", [](const CaseTree& tree) { return !states_both_speeds(tree); }},
    NeededKey{"operation.speed_rpm", [](const CaseTree& tree) { return !states_both_speeds(tree); }},
    NeededKey{"operation.inner_speed_rpm", [](const CaseTree& tree) { return states_only_both_speeds(tree); }},
    NeededKey{"operation.outer_speed_rpm", [](const CaseTree& tree) { return states_only_both_speeds(tree); }},
    NeededKey{"lubricant.viscosity_Pa_s",
              [](const CaseTree& tree) { return tree.has("bearing") && !means_grade(tree); }},
    NeededKey{"lubricant.temperature_C", [](const CaseTree& tree) { return means_grade(tree); }},
};

/// Whether the key is needed always, or where other keys of the case ask for it.
bool may_be_needed(const CaseKey& key) {
  return key.need == Need::always ||
         std::ranges::any_of(needed_keys, [&](const NeededKey& needed) { return needed.path.ends_with(key.name); });
}

bool is_needed(const CaseTree& tree, const std::string& path, const CaseKey& key) {
  if (key.need == Need::always) return true;
  const auto* const row = std::find_if(needed_keys.begin(), needed_keys.end(),
                                       [&](const NeededKey& needed) { return needed.path == path; });
  return row != needed_keys.end() && row->needed(tree);
}

/// The tables of the case, and those that it has to have: paths of "moes", "expect.0".
std::vector<std::string> tables_to_check(const CaseTree& tree, const CaseTable& table, const CaseTable* statement) {
  std::vector<std::string> paths;
  if (table.role == TableRole::expectation) {
    for (std::size_t i = 0; statement && i < tree.expectations(); ++i)
      paths.push_back(fmt::format("{}.{}", table.name, i));
    return paths;
  }
  const bool belongs = statement && (statement->in_bearing ? table.in_bearing : table.in_contact);
  const bool there = tree.has(std::string(table.name)) || table.required;
  if (table.role == TableRole::heading || (belongs && there)) paths.emplace_back(table.name);
  return paths;
}

/// Also by a table that is mistyped, which is named as unknown.
bool states_problem(const CaseTree& tree) {
  return std::ranges::any_of(case_tables(), [&](const CaseTable& table) {
    return table.role == TableRole::statement &&
           (tree.has(std::string(table.name)) ||
            std::ranges::any_of(tree.unknown(), [&](const UnknownKey& key) { return key.meant == table.name; }));
  });
}

struct MissingKey {
  std::string path, required;
};

std::vector<MissingKey> missing_keys(const CaseTree& tree, const CaseTable* statement) {
  std::vector<MissingKey> missing;
  const bool in_contact = statement && statement->in_contact;
  for (const CaseTable& table : case_tables()) {
    for (const std::string& path : tables_to_check(tree, table, statement))
      for (const CaseKey& key : table.keys) {
        if (key.need == Need::never || (key.bearing_only && in_contact) || !may_be_needed(key)) continue;
        const std::string name = (path.empty() ? "" : path + ".") + std::string(key.name);
        if (!tree.has(name) && is_needed(tree, name, key)) missing.push_back({name, text_of(key.allowed)});
      }
  }
  // A lubricated contact needs [lubricant] and [domain]; a dry one has neither.
  const bool may_be_dry = statement && statement->name == "conditions";
  if (!in_contact || (may_be_dry && !lubricated(tree))) return missing;
  for (const std::string& table : names_of_companions(false))
    if (!tree.has(table))
      missing.push_back(
          {table, fmt::format("[lubricant] with [domain]{}", may_be_dry ? ", or neither for a dry contact" : "")});
  return missing;
}

}  // namespace

std::string one_statement() {
  std::vector<std::string> names;
  for (const CaseTable& table : case_tables())
    if (table.role == TableRole::statement) names.push_back(fmt::format("[{}]", table.name));
  const std::string last = names.back();
  names.pop_back();
  return fmt::format("exactly one of {} and {}", list(names), last);
}

void refuse_unknown_and_missing(const CaseTree& tree, const CaseTable* statement) {
  std::vector<std::string> lines;
  for (const UnknownKey& key : tree.unknown()) lines.push_back(key.message);
  for (const MissingKey& key : missing_keys(tree, statement)) {
    const auto meant = [&](const UnknownKey& unknown) { return unknown.meant == key.path; };
    if (std::any_of(tree.unknown().begin(), tree.unknown().end(), meant)) continue;
    lines.emplace_back(case_error(tree.places(), key.path, "is missing; required is " + key.required).what());
  }
  if (!states_problem(tree))
    lines.emplace_back(case_error(tree.places(), "", "the problem is missing; required is " + one_statement()).what());
  if (!lines.empty()) throw CaseError(lines);
}

void refuse_unknown(const CaseTree& tree) {
  std::vector<std::string> lines;
  for (const UnknownKey& key : tree.unknown()) lines.push_back(key.message);
  if (!lines.empty()) throw CaseError(lines);
}

}  // namespace ehd
