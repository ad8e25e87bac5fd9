// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "contact/text.hpp"
#include "io/case_faults.hpp"
#include "io/case_keys.hpp"
#include "io/case_text.hpp"
#include "io/case_tree.hpp"
#include "io/case_values.hpp"
#include "io/expectations.hpp"
#include "io/read_bearing.hpp"
#include "io/read_contact.hpp"

namespace ehd {

namespace {

void read_heading(const CaseTree& tree, Case& made) {
  made.id = text(tree, "id");
  // A case on standard input has no file whose name its id could differ from.
  if (made.file == standard_input && !is_id(made.id))
    tree.fail("id", fmt::format("is no id; allowed is {}", allowed_in_id));
  const std::string stem = made.file == standard_input ? made.id : id_of_file(made.file);
  if (made.id != stem) tree.fail("id", fmt::format("differs from the file's name; allowed is \"{}\"", stem));
  made.version = integer(tree, "version");
  made.title = text(tree, "title");
  made.source = text(tree, "source");
}

void read(const CaseTree& tree, Case& made) {
  const CaseTable& statement = statement_without_faults(tree);
  read_heading(tree, made);
  if (statement.in_bearing)
    made.body = read_bearing(tree);
  else
    made.body = read_contact(tree, std::string(statement.name));
  made.expectations = std::visit([&](const auto& body) { return read_expectations(tree, body); }, made.body);
}

/// `text` as checked_case_text leaves it.
Case case_of(const std::string& text, const std::filesystem::path& file,
             const std::vector<Substitution>& substitutions = {}) {
  CaseTree tree(text, file, substitutions);
  Case made;
  made.file = tree.places().file;
  try {
    read(tree, made);
  } catch (const CaseError& refusal) {
    throw with_wrong_values(tree, refusal);
  }
  std::move(tree).move_places_to(made);
  return made;
}

}  // namespace

Case read_case(const std::filesystem::path& file) { return case_of(read_case_text(file), file); }

Case read_case(std::string text, const std::filesystem::path& file) {
  return case_of(checked_case_text(std::move(text), file), file);
}

Case read_case(std::string text, const std::filesystem::path& file, const std::vector<Substitution>& substitutions) {
  return case_of(checked_case_text(std::move(text), file), file, substitutions);
}

Case read_case_in_memory(std::string text) {
  const std::string checked = checked_case_text(std::move(text), nameless_case, TomlFile::case_in_memory);
  constexpr std::size_t longest_name = 60;  // in the message
  if (checked.find_first_of("=\n") == std::string::npos)
    throw CaseError(fmt::format("{} = {}: is a name; allowed is the text of a case file (TOML)", nameless_case,
                                shortened(one_line(checked), longest_name)));
  return case_of(checked, {});
}

ContactCase read_moes_contact(const MoesGroups& groups, const std::string& lubricant) {
  const std::string name = "lubricant";
  const std::string text = checked_case_text(fmt::format("[{}]\n{}", name, lubricant), name);
  const CaseTree body(text, name);
  for (const CaseTable& table : case_tables())
    if (!table.name.empty() && table.name != name && body.has(table.name))
      body.fail(table.name, "does not belong here; allowed are keys of [lubricant]");
  const std::vector<Substitution> stated{
      {"moes.M", groups.M}, {"moes.L", groups.L}, {"domain.inlet", std::string("flooded")}};
  const CaseTree tree(text, name, stated);
  refuse_unknown(tree);
  return read_contact(tree, "moes");
}

}  // namespace ehd
