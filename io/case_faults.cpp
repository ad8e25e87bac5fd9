// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "io/case_keys.hpp"
#include "io/case_statement.hpp"
#include "io/case_tree.hpp"
#include "io/case_values.hpp"
#include "io/read_oil.hpp"

namespace ehd {

namespace {

/// Also by a table of bearings alone, where [bearing] itself is missing.
bool of_bearing(const CaseTree& tree) {
  return std::ranges::any_of(case_tables(), [&](const CaseTable& table) {
    return table.in_bearing && !table.in_contact && tree.has(table.name);
  });
}
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
  std::string_view table, key;
  bool (*needed)(const CaseTree& tree);
};
constexpr std::array needed_keys{
    NeededKey{"conditions", "speed_sum_m_per_s", [](const CaseTree& tree) { return is_lubricated(tree); }},
    NeededKey{"conditions", "viscosity_Pa_s",
              [](const CaseTree& tree) { return is_lubricated(tree) && !means_grade(tree); }},
    NeededKey{"bearing", "rotating", [](const CaseTree& tree) { return !states_both_speeds(tree); }},
    NeededKey{"operation", "speed_rpm", [](const CaseTree& tree) { return !states_both_speeds(tree); }},
    NeededKey{"operation", "inner_speed_rpm", [](const CaseTree& tree) { return states_only_both_speeds(tree); }},
    NeededKey{"operation", "outer_speed_rpm", [](const CaseTree& tree) { return states_only_both_speeds(tree); }},
    NeededKey{"lubricant", "viscosity_Pa_s",
              [](const CaseTree& tree) { return of_bearing(tree) && !means_grade(tree); }},
    NeededKey{"lubricant", "temperature_C", [](const CaseTree& tree) { return means_grade(tree); }},
};

std::string name_in(const std::string& path, const CaseKey& key) {
  return std::string(path).append(path.empty() ? "" : ".").append(key.name);
}

bool is_needed(const CaseTree& tree, const CaseTable& table, const CaseKey& key) {
  if (key.need == Need::always) return true;
  const auto* const row = std::find_if(needed_keys.begin(), needed_keys.end(), [&](const NeededKey& needed) {
    return needed.table == table.name && needed.key == key.name;
  });
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
  if (table.role == TableRole::statement) {
    if (&table == statement) paths.emplace_back(table.name);
    return paths;
  }
  const bool there = tree.has(table.name);
  const bool belongs = !statement || (statement->in_bearing ? table.in_bearing : table.in_contact);
  const bool needed = statement && has_to_stand(tree, table, *statement);
  if (table.role == TableRole::heading || (belongs && (there || needed))) paths.emplace_back(table.name);
  return paths;
}

/// The keys of a table that such a case has to have.
std::vector<const CaseKey*> needed_in(const CaseTree& tree, const CaseTable& table, bool in_contact) {
  std::vector<const CaseKey*> needed;
  for (const CaseKey& key : table.keys) {
    if (key.need == Need::never || (key.bearing_only && in_contact)) continue;
    if (is_needed(tree, table, key)) needed.push_back(&key);
  }
  return needed;
}

struct MissingKey {
  std::string path, required;
};

/// What the message about a missing key asks for. In place of eta_0 a case may state the oil's grade. If the case has a
/// key of the grade already, such as temperature_C, the message asks for the grade first.
std::string required_of(const CaseTree& tree, const CaseKey& key) {
  const std::string allowed = text_of(key.allowed);
  if (key.name != "viscosity_Pa_s") return allowed;
  if (tree.has("lubricant.viscosity_Pa_s")) return allowed + "; that in [lubricant] belongs here, in a contact";
  const std::string beside = key_beside_grade(tree);
  if (beside.empty()) return allowed + "; or the oil's grade, iso_vg with temperature_C in [lubricant]";
  return fmt::format("iso_vg in [lubricant], to which {} belongs; or {}, without {}", beside, allowed, beside);
}

std::vector<MissingKey> missing_keys(const CaseTree& tree, const CaseTable* statement) {
  std::vector<MissingKey> missing;
  const bool in_contact = statement && statement->in_contact;
  const bool may_be_dry = statement && statement->name == "conditions";
  for (const CaseTable& table : case_tables()) {
    if (in_contact && has_to_stand(tree, table, *statement) && !tree.has(table.name))
      missing.push_back({std::string(table.name), fmt::format("[lubricant] with [domain]{}",
                                                              may_be_dry ? ", or neither for a dry contact" : "")});
    for (const std::string& path : tables_to_check(tree, table, statement))
      for (const CaseKey* key : needed_in(tree, table, in_contact))
        if (const std::string name = name_in(path, *key); !tree.has(name))
          missing.push_back({name, required_of(tree, *key)});
  }
  return missing;
}

}  // namespace

const CaseTable& statement_without_faults(const CaseTree& tree) {
  const CaseStatement statement = statement_of(tree, [&](const CaseTable& table) {
    std::vector<std::string> names;
    for (const CaseKey* key : needed_in(tree, table, table.in_contact)) names.emplace_back(key->name);
    return names;
  });
  std::vector<std::string> lines;
  for (const UnknownKey& key : tree.unknown()) lines.push_back(key.message);
  lines.insert(lines.end(), statement.faults.begin(), statement.faults.end());
  for (const MissingKey& key : missing_keys(tree, statement.table)) {
    const auto meant = [&](const UnknownKey& unknown) { return unknown.meant == key.path; };
    if (std::any_of(tree.unknown().begin(), tree.unknown().end(), meant)) continue;
    lines.emplace_back(case_error(tree.places(), key.path, "is missing; required is " + key.required).what());
  }
  if (!lines.empty()) throw CaseError(lines);
  return *statement.table;  // null comes with a fault
}

CaseError with_wrong_values(const CaseTree& tree, const CaseError& refusal) {
  std::vector<std::string> lines{refusal.what()};
  lines.insert(lines.end(), refusal.more().begin(), refusal.more().end());
  for (const CaseTable& table : case_tables())
    for (const CaseKey& key : table.keys) {
      const std::string path = name_in(std::string(table.name), key);
      // A dry contact at rest has the speed 0.
      if (!tree.has(path) || (path == "conditions.speed_sum_m_per_s" && !is_lubricated(tree))) continue;
      try {
        check_value(tree, path);
      } catch (const CaseError& wrong) {
        if (std::ranges::find(lines, wrong.what()) == lines.end()) lines.emplace_back(wrong.what());
      }
    }
  return CaseError(lines);
}

void refuse_unknown(const CaseTree& tree) {
  std::vector<std::string> lines;
  for (const UnknownKey& key : tree.unknown()) lines.push_back(key.message);
  if (!lines.empty()) throw CaseError(lines);
}

}  // namespace ehd
