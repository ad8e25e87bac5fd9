// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case_statement.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/case_keys.hpp"
#include "io/case_tree.hpp"

namespace ehd {

namespace {

using Tables = std::vector<const CaseTable*>;
using Needs = std::function<std::vector<std::string>(const CaseTable& table)>;

std::string in_brackets(const CaseTable* table) { return fmt::format("[{}]", table->name); }

/// "[moes], [conditions] and [hertz]"
std::string listed(std::vector<std::string> items) {
  const std::string last = items.back();
  items.pop_back();
  return items.empty() ? last : list(items) + " and " + last;
}

Tables tables_of(TableRole role) {
  Tables tables;
  for (const CaseTable& table : case_tables())
    if (table.role == role) tables.push_back(&table);
  return tables;
}

Tables present_of(TableRole role, const CaseTree& tree) {
  Tables tables = tables_of(role);
  std::erase_if(tables, [&](const CaseTable* table) { return !tree.has(table->name); });
  return tables;
}

/// In the order of the file; what a substitution made comes last.
Tables statements_in(const CaseTree& tree) {
  Tables present = present_of(TableRole::statement, tree);
  const auto place = [&](const CaseTable* table) {
    const int line = tree.line_of(std::string(table->name));
    return std::pair(line == 0, line);
  };
  std::stable_sort(present.begin(), present.end(),
                   [&](const CaseTable* one, const CaseTable* other) { return place(one) < place(other); });
  return present;
}

bool belongs(const CaseTable& companion, const CaseTable& statement) {
  return statement.in_bearing ? companion.in_bearing : companion.in_contact;
}

/// The statements that the other tables of the case may stand beside; all where no statement suits them.
Tables possible_statements(const CaseTree& tree) {
  const Tables companions = present_of(TableRole::companion, tree);
  const Tables all = tables_of(TableRole::statement);
  Tables possible = all;
  std::erase_if(possible, [&](const CaseTable* statement) {
    return !std::ranges::all_of(companions, [&](const CaseTable* table) { return belongs(*table, *statement); });
  });
  return possible.empty() ? all : possible;
}

/// "[bearing] with rollers, ..., [operation] with ..., [material] with ..."; without the tables that are there: the
/// keys that these lack have their own lines.
std::string with_keys(const CaseTree& tree, const CaseTable& statement, const Needs& needs) {
  std::string text = fmt::format("[{}] with {}", statement.name, list(needs(statement)));
  for (const CaseTable* table : tables_of(TableRole::companion))
    if (has_to_stand(tree, *table, statement) && !tree.has(table->name))
      text += fmt::format(", [{}] with {}", table->name, list(needs(*table)));
  return text;
}

std::string line_of_fault(const CaseTree& tree, const std::string& path, const std::string& message) {
  return case_error(tree.places(), path, message).what();
}

CaseStatement without_problem(const CaseTree& tree, const Needs& needs) {
  const Tables possible = possible_statements(tree);
  if (possible.size() == 1)  // its keys are missing, a line each
    return {
        .table = possible.front(),
        .faults = {line_of_fault(tree, "", "the problem is missing; required is " + in_brackets(possible.front()))}};
  std::string alternatives;
  for (const CaseTable* table : possible)
    alternatives += (alternatives.empty() ? "" : "; or ") + with_keys(tree, *table, needs);
  return {
      .faults = {line_of_fault(tree, "", "the problem is missing; required is exactly one of these: " + alternatives)}};
}

/// "exactly one of [moes], [conditions], [hertz] and [bearing]"
std::string one_statement() {
  std::vector<std::string> names;
  for (const CaseTable* table : tables_of(TableRole::statement)) names.push_back(in_brackets(table));
  return "exactly one of " + listed(names);
}

}  // namespace

bool is_lubricated(const CaseTree& tree) { return tree.has("lubricant") || tree.has("domain"); }

bool has_to_stand(const CaseTree& tree, const CaseTable& companion, const CaseTable& statement) {
  if (companion.role != TableRole::companion || !belongs(companion, statement)) return false;
  const bool may_be_dry = statement.in_bearing || (statement.name == "conditions" && !is_lubricated(tree));
  return companion.required || !may_be_dry;  // every companion of a contact is one of a lubricated contact
}

CaseStatement statement_of(const CaseTree& tree, const Needs& needs) {
  const Tables present = statements_in(tree);
  if (present.empty()) return without_problem(tree, needs);
  CaseStatement found{.table = present.front()};
  for (std::size_t i = 1; i < present.size(); ++i)
    found.faults.push_back(line_of_fault(tree, std::string(present[i]->name),
                                         fmt::format("states the problem again, beside {}; allowed is {}",
                                                     in_brackets(present.front()), one_statement())));
  if (present.size() > 1) return found;
  for (const CaseTable* table : present_of(TableRole::companion, tree)) {
    const bool of_bearing = found.table->in_bearing;
    if (!belongs(*table, *found.table))
      found.faults.push_back(
          line_of_fault(tree, std::string(table->name),
                        fmt::format("does not belong to a {} case; allowed is {}, expect",
                                    of_bearing ? "bearing" : "contact", list(names_of_companions(of_bearing)))));
  }
  return found;
}

}  // namespace ehd
