// SPDX-License-Identifier: GPL-3.0-or-later
// ehd cases: the benchmark cases, with how to cite each.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cli/output.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/bibliography.hpp"
#include "io/case_citation.hpp"
#include "io/case_reader.hpp"
#include "io/faults.hpp"
#include "io/file_text.hpp"
#include "io/find_case.hpp"
#include "io/near_miss.hpp"
#include "io/tables.hpp"
#include "verification/atlas/atlas.hpp"
#include "workflow/case.hpp"

namespace ehd::cli {

namespace {

struct CasesOptions {
  std::vector<std::string> ids;
  bool bibtex = false, json = false, show = false, atlas = false;
};

const char* const cases_examples = R"(
Examples:
  ehd cases                          id, problem, title and source of every case
  ehd cases own-moes-20-10 --bibtex  an entry for this case and its digits, and its source
  ehd cases own-moes-20-10 --json    groups, laws as formulas, inlet and digits, for another program
  ehd cases own-moes-20-10 --show    the case file
  ehd cases --bibtex > ehd.bib       the sources of all cases and claims, for a bibliography
  ehd cases --atlas                  the points of the atlas (cases/atlas), a case each

The cases are the files *.toml of one folder; the environment variable EHD_CASES names another one.)";

std::string problem_of(const Case& any) {
  if (const auto* bearing = std::get_if<BearingCase>(&any.body))
    return fmt::format("bearing, {} rollers", bearing->geometry.rollers);
  const auto& contact = std::get<ContactCase>(any.body);
  if (contact.dry()) return "dry contact";
  const Groups groups = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet).problem.groups;
  constexpr int digits = 4;
  return fmt::format("M = {}, L = {}", plain(groups.M, digits), plain(groups.L, digits));
}

/// The kinds of a case's expectations: "exact", "computed", …, each once; values without a source yet are "waiting".
std::string kinds_in(const Case& any) {
  std::vector<std::string> kinds;
  for (const auto& expectation : any.expectations) {
    const std::string kind = expectation.waiting ? "waiting" : std::string(to_string(expectation.kind));
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
  }
  return kinds.empty() ? "-" : fmt::format("{}", fmt::join(kinds, ", "));
}

std::string expected_in(const Case& any) {
  std::size_t waiting = 0;
  for (const auto& expectation : any.expectations) waiting += expectation.waiting ? 1 : 0;
  const std::size_t values = any.expectations.size() - waiting;
  if (waiting > 0 && values == 0) return "waiting";
  return std::to_string(values);
}

/// A table; title and source stand below each row, so that it is no wider than a terminal.
std::string listed(const std::vector<Case>& cases) {
  std::vector<std::vector<std::string>> rows{{"id", "version", "problem", "kind", "expects"}};
  for (const auto& any : cases)
    rows.push_back({any.id, std::to_string(any.version), problem_of(any), kinds_in(any), expected_in(any)});
  std::istringstream lines(aligned(rows, rows.front().size()));
  std::string text, line;
  std::getline(lines, line);
  text += line + "\n";
  for (const auto& any : cases) {
    std::getline(lines, line);
    text += line + "\n" + wrapped("    " + any.title, "    ");
    if (any.source != "own") text += fmt::format("    source: {}\n", any.source);
  }
  return text;
}

std::vector<Case> atlas_cases() {
  std::vector<Case> points;
  for (const auto& file : verification::atlas_files(verification::atlas_folder())) points.push_back(read_case(file));
  if (points.empty())
    throw UsageError("--atlas: there are no points in " + verification::atlas_folder().string() +
                     "; required is a folder that ehd atlas has filled");
  return points;
}

constexpr std::string_view own_source = "own";

std::filesystem::path references_file() { return cases_folder() / "references.bib"; }

/// Absent where the folder of the cases has none: EHD_CASES may name any folder.
std::optional<Bibliography> bibliography_of_cases() {
  std::error_code error;
  if (std::filesystem::status(references_file(), error).type() == std::filesystem::file_type::not_found)
    return std::nullopt;
  return read_bibliography(references_file());
}

std::vector<std::string> keys_of(const Bibliography& bibliography) {
  std::vector<std::string> keys{std::string(own_source)};
  for (const auto& [key, entry] : bibliography) keys.push_back(key);
  return keys;
}

std::string listed_sources(const std::vector<Case>& cases, const std::optional<Bibliography>& known, bool with_others) {
  std::set<std::string> keys;
  for (const auto& any : cases) keys.insert(bibliography_key(any.source));
  if (!known)
    return "\n" + wrapped(fmt::format("sources: {} has no references.bib, and so no entries of {}",
                                      cases_folder().string(), fmt::join(keys, ", ")),
                          "  ");
  const Bibliography& bibliography = *known;
  std::string text = "\nsources (cite the source of a case and this program; --bibtex prints the entries)\n";
  const auto line = [](const std::string& key, const std::string& citation) {
    return wrapped(fmt::format("  {}: {}", key, citation), "      ");
  };
  for (const auto& key : keys) {
    const auto entry = bibliography.find(key);
    if (entry != bibliography.end())
      text += line(key, entry->second.citation());
    else
      text += line(key, key == own_source ? "not in references.bib"
                                          : "is not in references.bib; " + did_you_mean(key, keys_of(bibliography)) +
                                                "a case of your own may name any source");
  }
  std::string others;
  for (const auto& [key, entry] : bibliography)
    if (with_others && !keys.contains(key)) others += line(key, entry.citation());
  if (!others.empty())
    text += "\nsources of exact solutions, formulas and tables that are no case (docs/literature.md)\n" + others;
  return text;
}

/// The files as they are, one below the other.
std::string shown(const std::vector<Case>& cases) {
  constexpr FileKind kind{.name = "a case file (TOML)", .most_bytes = 1 << 20};
  std::string text;
  for (const Case& any : cases) text += (text.empty() ? "" : "\n") + text_of_file(any.file, kind);
  return text;
}

void require_citable(const std::vector<Case>& cases) {
  for (const Case& any : cases)
    if (!is_benchmark_case(any))
      throw UsageError(
          one_line(fmt::format("--bibtex: {} is not in {}: it is no benchmark case and has no entry; allowed is {}",
                               any.file.string(), cases_folder().string(), allowed_id)));
}

/// Whoever cites a case also has to cite its source. So each source needs an entry.
void require_sources(const std::vector<Case>& cases, const Bibliography& bibliography) {
  Faults faults;
  for (const Case& any : cases) {
    const std::string key = bibliography_key(any.source);
    if (key == own_source || bibliography.contains(key)) continue;
    faults.add(case_error(any, "source",
                          fmt::format("has no entry in {}; {}allowed is \"own\", or \"bibkey, the exact place\"",
                                      references_file().string(), did_you_mean(key, keys_of(bibliography)))));
  }
  faults.refuse();
}

int list(const CasesOptions& options) {
  if (options.bibtex + options.json + options.show > 1)
    throw UsageError("cases: --bibtex, --json and --show exclude each other; allowed is one of them");
  std::vector<std::string> ids = options.ids;
  if (options.json) std::erase(ids, "-");  // --json - as of other commands: standard output is where it goes anyway
  const bool all = ids.empty();
  if (options.atlas && !all) throw UsageError("cases: --atlas and an ID exclude each other; allowed is one of them");
  std::vector<Case> cases;
  Faults faults;
  for (const std::string& id : ids)
    (void)faults.none_in([&] {
      Case one = read_case(find_case(id));
      const bool known = std::any_of(cases.begin(), cases.end(), [&](const Case& other) { return other.id == one.id; });
      if (!known) cases.push_back(std::move(one));
    });
  faults.refuse();
  if (all) cases = options.atlas ? atlas_cases() : all_cases();
  if (options.show) {
    print(shown(cases));
    return success;
  }
  if (options.json) {
    print(json_text(cases_json(cases)));
    return success;
  }
  std::string text = listed(cases);
  if (options.atlas && !options.bibtex) {
    print(text);
    return success;
  }
  const std::optional<Bibliography> bibliography = bibliography_of_cases();
  if (options.bibtex) {
    require_citable(cases);
    const bool of_sources = all && !options.atlas;
    if (bibliography && !of_sources) require_sources(cases, *bibliography);
    print(of_sources ? bibtex_of_sources(bibliography ? *bibliography : read_bibliography(references_file()))
                     : bibtex_of_cases(cases, bibliography.value_or(Bibliography())));
    return success;
  }
  if (const auto points = all ? verification::atlas_files(verification::atlas_folder()).size() : 0; points > 0)
    text += fmt::format("\natlas: {} cases, ehd cases --atlas lists them\n", points);
  print(text + listed_sources(cases, bibliography, all));
  return success;
}

}  // namespace

void describe_cases(Command& command) {
  auto options = std::make_shared<CasesOptions>();
  command.summary("List the benchmark cases and how to cite each");
  command.examples(cases_examples);
  command.list("ID", options->ids, "these cases alone (all of cases/)");
  command.flag("--bibtex", options->bibtex, "print BibTeX entries: of the cases named, or of all sources");
  command.flag("--json", options->json, "print the problems and their digits for another program");
  command.flag("--show", options->show, "print the case files");
  command.flag("--atlas", options->atlas, "the points of the atlas");
  command.runs([options] { return list(*options); });
}

}  // namespace ehd::cli
