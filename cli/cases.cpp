// SPDX-License-Identifier: GPL-3.0-or-later
// ehd cases: the benchmark cases, with how to cite each.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "cli/output.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/bibliography.hpp"
#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "io/tables.hpp"
#include "verification/atlas/atlas.hpp"
#include "workflow/case.hpp"

namespace ehd::cli {

namespace {

const char* const cases_examples = R"(
Examples:
  ehd cases                          id, problem, title and source of every case
  ehd cases --bibtex > ehd.bib       the sources of all cases and claims, for a bibliography
  ehd cases --atlas                  the points of the atlas (cases/atlas), a case each

The cases are the files *.toml of one folder; the environment variable EHD_CASES names another one.)";

std::string problem_of(const Case& any) {
  if (const auto* bearing = std::get_if<BearingCase>(&any.body))
    return "bearing, " + std::to_string(bearing->geometry.rollers) + " rollers";
  const auto& contact = std::get<ContactCase>(any.body);
  if (contact.dry()) return "dry contact";
  const Groups groups = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet).problem.groups;
  constexpr int digits = 4;
  return "M = " + plain(groups.M, digits) + ", L = " + plain(groups.L, digits);
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

std::vector<std::vector<std::string>> rows_of(const std::vector<Case>& cases) {
  std::vector<std::vector<std::string>> rows{{"id", "version", "problem", "expects", "kind", "source", "title"}};
  for (const auto& any : cases)
    rows.push_back(
        {any.id, std::to_string(any.version), problem_of(any), expected_in(any), kinds_in(any), any.source, any.title});
  return rows;
}

int list_atlas() {
  std::vector<Case> points;
  for (const auto& file : verification::atlas_files(verification::atlas_folder())) points.push_back(read_case(file));
  if (points.empty())
    throw UsageError("--atlas: there are no points in " + verification::atlas_folder().string() +
                     "; required is a folder that ehd atlas has filled");
  const auto rows = rows_of(points);
  print(aligned(rows, rows.front().size()));
  return success;
}

int list(bool bibtex) {
  const auto cases = all_cases();
  const auto bibliography = read_bibliography(cases_folder() / "references.bib");
  std::set<std::string> keys;
  for (const auto& any : cases) keys.insert(bibliography_key(any.source));

  if (bibtex) {  // all of references.bib: claims cite sources without a case
    std::string text;
    for (const auto& [key, entry] : bibliography) text += (text.empty() ? "" : "\n") + entry.text;
    print(text);
    return success;
  }

  const auto rows = rows_of(cases);
  std::string text = aligned(rows, rows.front().size());
  if (const auto points = verification::atlas_files(verification::atlas_folder()).size(); points > 0)
    text += "\natlas: " + std::to_string(points) + " cases, ehd cases --atlas lists them\n";
  text += "\nsources (cite the source of a case and this program; --bibtex prints the entries)\n";
  std::vector<std::vector<std::string>> sources;
  for (const auto& key : keys) {
    const auto entry = bibliography.find(key);
    sources.push_back({key, entry == bibliography.end() ? "not in references.bib" : entry->second.citation()});
  }
  text += aligned(sources, 2, "  ");
  sources.clear();
  for (const auto& [key, entry] : bibliography)
    if (!keys.contains(key)) sources.push_back({key, entry.citation()});
  if (!sources.empty())
    text += "\nsources of exact solutions, formulas and tables that are no case (cases/README.md)\n" +
            aligned(sources, 2, "  ");
  print(text);
  return success;
}

}  // namespace

void describe_cases(Command& command) {
  struct CasesOptions {
    bool bibtex = false, atlas = false;
  };
  auto options = std::make_shared<CasesOptions>();
  command.summary("List the benchmark cases and how to cite each");
  command.examples(cases_examples);
  const Option bibtex = command.flag("--bibtex", options->bibtex, "print the BibTeX entries of all sources");
  command.flag("--atlas", options->atlas, "list the points of the atlas").excluding(bibtex);
  command.runs([options] { return options->atlas ? list_atlas() : list(options->bibtex); });
}

}  // namespace ehd::cli
