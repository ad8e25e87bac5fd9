// SPDX-License-Identifier: GPL-3.0-or-later
// ehd statements: the paper's statements under the choices that the paper leaves open.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "io/json.hpp"
#include "io/result_head.hpp"
#include "io/tables.hpp"
#include "verification/studies/paper_statements.hpp"
#include "verification/studies/statement_study.hpp"
#include "workflow/case.hpp"
#include "workflow/registry.hpp"

namespace ehd::cli {

namespace {

using namespace verification;

struct StatementsOptions {
  std::vector<std::string> cases{"na4908", "na4908-2.5um", "na4908-10um"};
  std::optional<std::string> json;
};

std::string statements_examples() {
  return fmt::format(R"(
Examples:
  ehd statements                        the paper's bearing at its three clearances
  ehd statements --json study.json

One choice that the paper leaves open is changed at a time:
{}Then two are changed at once, of which one is a short x_0. Every row is judged as the paper's
statements (a) to (d) read. x_0 is scanned where a row leaves it open.)",
                     wrapped(fmt::format("  {}", fmt::join(open_choices, ", ")), "  "));
}

int statements(const StatementsOptions& options) {
  std::vector<Case> cases;
  for (const std::string& name : options.cases) {
    cases.push_back(read_case(find_case(name)));
    const auto* body = std::get_if<BearingCase>(&cases.back().body);
    if (!body || !body->lubricant)
      throw case_error(cases.back(), "", "has no film; allowed is a bearing case with a lubricant");
  }
  if (cases.size() < 3 || !differ_only_in_clearance(cases))
    throw UsageError(
        "CASE: the statements are about one bearing at three or more clearances; allowed are cases that "
        "differ in clearance alone");
  require_distinct(files_of(cases), {{"--json", options.json.value_or("")}});
  JsonTarget json(options.json);
  Progress progress;
  ContactMemory memory(
      [](const Problem& problem, const Request& request) { return default_solver().solve(problem, request); });
  const auto rows = study_statements(
      cases, memory, [&progress](std::size_t done, std::size_t all) { progress.step(done, all, "choices judged"); });
  progress.show("");
  Json result = result_head("ehd-statements-1");
  result.update(to_json(rows));
  result["contact_solves"] = memory.solves();
  result["contacts_from_memory"] = memory.recalls();
  json.commit(result);
  if (!json.to_standard_output())
    print(fmt::format("{}\n  {} contacts solved, {} taken from memory\n", human_study(rows), memory.solves(),
                      memory.recalls()));
  int missing = 0;
  for (const StudyRow& row : rows) {
    if (!row.statements.empty()) continue;
    ++missing;
    complain(fmt::format("ehd: statements: {} {}, {}: {}", row.factor, row.value, to_string(row.law), row.why));
  }
  return missing == 0 ? success : not_met;
}

}  // namespace

void describe_statements(Command& command) {
  auto options = std::make_shared<StatementsOptions>();
  command.summary("Which choices that the paper leaves open change its statements");
  command.examples(statements_examples());
  command.list("CASE", options->cases, "one bearing at three or more clearances (na4908, na4908-2.5um, na4908-10um)");
  command.text("--json", options->json, "the study as JSON into a file, or - for standard output");
  command.runs([options] { return statements(*options); });
}

}  // namespace ehd::cli
