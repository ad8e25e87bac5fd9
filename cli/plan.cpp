// SPDX-License-Identifier: GPL-3.0-or-later
// ehd plan: the stages of a run, and the skipped ones with the reason. Nothing is solved.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/case_choice.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "io/contact_json.hpp"
#include "io/json.hpp"
#include "io/result_head.hpp"
#include "io/tables.hpp"
#include "workflow/bearing_run.hpp"
#include "workflow/case.hpp"
#include "workflow/contact_plan.hpp"
#include "workflow/registry.hpp"

namespace ehd::cli {

namespace {

struct PlanOptions {
  std::string case_name;
  std::optional<std::string> solver;
  std::vector<std::string> quantities, laws;
  std::optional<std::string> json;
  RequestOptions request;
  CaseChanges changes;
};

const char* const plan_examples = R"(
Examples:
  ehd plan own-moes-20-10                              the stages of a contact
  ehd plan own-isoviscous-10-0 --solver reference      no viscosity law, no FFT
  ehd plan own-moes-20-10 --quantity film.minimum      nothing else is observed
  ehd plan na4908 --law hertz                          a bearing with dry contacts)";

int plan(const PlanOptions& options) {
  const auto& solver = solver_named(options.solver.value_or(default_solver().name));
  const Request request = options.request.request();
  const Wanted wanted = quantities_named(options.quantities);
  const Case any = options.changes.read(options.case_name);
  require_distinct({{"the case", any.file}}, {{"--json", options.json.value_or("")}});
  // A request that solve or bearing would refuse is refused here as well.
  Plan made;
  if (const auto* bearing = std::get_if<BearingCase>(&any.body)) {
    if (options.solver || !options.quantities.empty() || options.request.states_accuracy())
      throw UsageError(
          "plan: --solver, --quantity, --tolerance and --nodes belong to a contact; allowed with a bearing "
          "case is --law");
    const auto named = laws_named(options.laws);
    const auto laws = named.empty() ? default_laws(*bearing) : named;
    require_possible(any, {.laws = laws, .explicitly = !named.empty()});
    made = plan_bearing(*bearing, laws);
  } else {
    if (!options.laws.empty())
      throw UsageError("plan: --law belongs to a bearing; allowed with a contact case is --solver");
    options.request.require_wanted(wanted);
    const auto& contact = std::get<ContactCase>(any.body);
    if (!contact.dry()) require_memory(solver, request);
    made = plan_contact(contact, solver, request, wanted);
  }
  JsonTarget json(options.json);
  Json object = result_head("ehd-plan-1");
  object["case"] = any.id;
  object["version"] = any.version;
  object["plan"] = to_json(made);
  options.changes.put_into(object);
  json.commit(object);
  if (!json.to_standard_output()) print(fmt::format("{}: {}\n{}", any.id, any.title, human_plan(made)));
  return success;
}

}  // namespace

void describe_plan(Command& command) {
  auto options = std::make_shared<PlanOptions>();
  command.summary("Show what would be computed, what is skipped and why");
  command.examples(plan_examples);
  command.text("CASE", options->case_name, "a case file (TOML), the id of a benchmark case, or - for standard input")
      .required();
  command.text("--solver", options->solver, fmt::format("one of {} ({})", solver_names(), default_solver().name))
      .completed_by(solver_names());
  options->request.add_to(command);
  options->changes.add_to(command);
  command.list("--quantity", options->quantities, "only this quantity (repeatable)");
  command.list("--law", options->laws, "a bearing's law (repeatable)")
      .completed_by(bearing::names_of(bearing::Laws::all));
  command.text("--json", options->json, "the plan as JSON into a file, or - for standard output");
  command.runs([options] { return plan(*options); });
}

}  // namespace ehd::cli
