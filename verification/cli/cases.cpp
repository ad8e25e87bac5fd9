// SPDX-License-Identifier: GPL-3.0-or-later
// ehd cases: the benchmark cases, with how to cite each.
#include <memory>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "contact/scaling.hpp"
#include "verification/atlas.hpp"
#include "verification/bibliography.hpp"
#include "verification/case.hpp"
#include "verification/cli/commands.hpp"
#include "verification/cli/common.hpp"
#include "verification/text.hpp"

namespace ehd::cli {

namespace {

using verification::Case;
using verification::plain;

const char* examples = R"(
Examples:
  ehd cases                          id, problem, title and source of every case
  ehd cases --bibtex > ehd.bib       the sources of all cases, for a bibliography
  ehd cases --atlas                  the points of the atlas (cases/atlas), a case each

The cases are the files *.toml of one folder; the environment variable EHD_CASES names another one.)";

std::string problem_of(const Case& any) {
  if (const auto* bearing = std::get_if<verification::BearingCase>(&any.body))
    return "bearing, " + std::to_string(bearing->geometry.rollers) + " rollers";
  const auto& contact = std::get<verification::ContactCase>(any.body);
  if (contact.dry()) return "dry contact";
  const Groups groups = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet).problem.groups;
  constexpr int digits = 4;
  return "M = " + plain(groups.M, digits) + ", L = " + plain(groups.L, digits);
}

std::string expected_in(const Case& any) {
  std::size_t waiting = 0;
  for (const auto& expectation : any.expectations) waiting += expectation.waiting ? 1 : 0;
  const std::size_t values = any.expectations.size() - waiting;
  if (waiting > 0 && values == 0) return "waiting";
  return std::to_string(values);
}

std::vector<std::vector<std::string>> rows_of(const std::vector<Case>& cases) {
  std::vector<std::vector<std::string>> rows{{"id", "version", "problem", "expects", "source", "title"}};
  for (const auto& any : cases)
    rows.push_back({any.id, std::to_string(any.version), problem_of(any), expected_in(any), any.source, any.title});
  return rows;
}

int list_atlas() {
  std::vector<Case> points;
  for (const auto& file : verification::atlas_files(verification::atlas_folder()))
    points.push_back(verification::read_case(file));
  if (points.empty())
    throw UsageError("--atlas: there are no points in " + verification::atlas_folder().string() +
                     "; required is a folder that ehd atlas has filled");
  const auto rows = rows_of(points);
  print(verification::aligned(rows, rows.front().size()));
  return success;
}

int list(bool bibtex) {
  const auto cases = verification::all_cases();
  const auto bibliography = verification::read_bibliography(verification::cases_folder() / "references.bib");
  std::set<std::string> keys;
  for (const auto& any : cases) keys.insert(verification::bibliography_key(any.source));

  if (bibtex) {
    std::string text;
    for (const auto& key : keys) {
      if (const auto entry = bibliography.find(key); entry != bibliography.end())
        text += (text.empty() ? "" : "\n") + entry->second.text;
    }
    print(text);
    return success;
  }

  const auto rows = rows_of(cases);
  std::string text = verification::aligned(rows, rows.front().size());
  if (const auto points = verification::atlas_files(verification::atlas_folder()).size(); points > 0)
    text += "\natlas: " + std::to_string(points) + " cases, ehd cases --atlas lists them\n";
  text += "\nsources (cite the source of a case and this program; --bibtex prints the entries)\n";
  std::vector<std::vector<std::string>> sources;
  for (const auto& key : keys) {
    const auto entry = bibliography.find(key);
    sources.push_back({key, entry == bibliography.end() ? "not in references.bib" : entry->second.citation()});
  }
  print(text + verification::aligned(sources, 2, "  "));
  return success;
}

}  // namespace

void add_cases(CLI::App& app, int& exit_code) {
  struct CasesOptions {
    bool bibtex = false, atlas = false;
  };
  auto options = std::make_shared<CasesOptions>();
  CLI::App* command = app.add_subcommand("cases", "List the benchmark cases and how to cite each");
  command->footer(examples);
  auto* bibtex = command->add_flag("--bibtex", options->bibtex, "print the BibTeX entries of the cases' sources");
  command->add_flag("--atlas", options->atlas, "list the points of the atlas")->excludes(bibtex);
  command->callback([options, &exit_code] {
    run_guarded(exit_code, [&] { return options->atlas ? list_atlas() : list(options->bibtex); });
  });
}

}  // namespace ehd::cli
