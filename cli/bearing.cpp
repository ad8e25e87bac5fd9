// SPDX-License-Identifier: GPL-3.0-or-later
// ehd bearing: the load distribution of one or more bearing cases.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/case_choice.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/picture_file.hpp"
#include "cli/pictures.hpp"
#include "cli/progress.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "io/bearing_csv.hpp"
#include "io/bearing_json.hpp"
#include "io/bearing_table.hpp"
#include "io/contact_json.hpp"
#include "io/faults.hpp"
#include "io/json.hpp"
#include "io/output_file.hpp"
#include "io/tables.hpp"
#include "verification/studies/error_budget.hpp"
#include "verification/studies/paper_statements.hpp"
#include "workflow/bearing_run.hpp"
#include "workflow/case.hpp"
#include "workflow/registry.hpp"

namespace ehd::cli {

namespace {

using namespace verification;

struct BearingOptions {
  std::vector<std::string> cases, laws;
  std::optional<std::string> json, plot, csv;
  std::string solver = default_solver().name, form = "plane";
  bool details = false;
  std::optional<std::string> cage_positions, time_limit_total;
  std::vector<std::string> frequencies;
  bool dynamic = false;
  RequestOptions limits;
  CaseChanges changes;
};

const char* const bearing_examples = R"(
Examples:
  ehd bearing na4908                                   dry and EHD laws side by side
  ehd bearing na4908 na4908-2.5um na4908-10um          three clearances; judges the paper's statements
  ehd bearing harris-209 --law hertz --law iso         dry laws only
  ehd bearing na4908 --cage-positions 24               and the displacement while the cage turns by one pitch
  ehd bearing na4908 --set bearing.clearance_m=5e-6    with another clearance
  ehd bearing na4908 --details                         and the lines of ehd-linear, error budgets, costs
  ehd bearing na4908 --dynamic --frequency 100         and stiffness and damping in motion at 100 Hz
  ehd bearing na4908 --law ehd-linear --json -         one result as JSON on standard output
  ehd bearing na4908 na4908-10um --plot loads.svg --csv loads.csv
                                                       contact forces and displacements over the azimuth

Laws, f the force of a contact and delta its approach:
)";

constexpr const char* bearing_exit_codes = "\nExit code: 0 all laws balanced; 1 one did not; 2 bad input or usage.";

std::string bearing_help() {
  std::string text = bearing_examples;
  for (const bearing::LawRow& row : bearing::law_rows())
    text += fmt::format("  {:<10}  {}\n", row.name, row.description);
  return text + bearing_exit_codes;
}

/// Throws UsageError.
bearing::Form form_named(const std::string& name) {
  for (const bearing::Form form : {bearing::Form::plane, bearing::Form::radial})
    if (name == to_string(form)) return form;
  throw unknown_word_error("--form", name, "plane, radial");
}

/// 0 without the option. Throws UsageError.
int positions_asked(const std::optional<std::string>& text) {
  if (!text) return 0;
  return parse_integer("--cage-positions", *text, {.low = 2, .high = 10000});
}

/// --dynamic, or any --frequency. Throws UsageError.
std::vector<double> frequencies_asked(const BearingOptions& options) {
  constexpr Interval range{.low = 0, .high = 1e9};
  std::vector<double> frequencies_Hz;
  for (const std::string& text : options.frequencies)
    frequencies_Hz.push_back(parse_number("--frequency", text, range));
  if (!frequencies_Hz.empty() && !options.dynamic)
    throw option_error("--frequency", options.frequencies.front(), "belongs to --dynamic; allowed is both");
  if (options.dynamic && frequencies_Hz.empty()) frequencies_Hz = {0};
  return frequencies_Hz;
}

/// The cases and their results.
struct Computed {
  std::vector<Case> cases;
  std::vector<std::vector<BearingResult>> results;
};

/// Of the paper's bearing alone. Another bearing is judged where it is asked for, by `ehd statements`.
std::string statements_of(const Computed& computed, ContactMemory& memory, bearing::Form form) {
  if (!std::all_of(computed.cases.begin(), computed.cases.end(), is_of_the_paper)) return "";
  if (computed.cases.size() < 3 || !differ_only_in_clearance(computed.cases)) return "";
  std::string text;
  for (const bearing::Law law : film_laws()) {
    std::vector<ClearanceComparison> clearances;
    for (std::size_t k = 0; k < computed.cases.size(); ++k) {
      const BearingResult *dry = nullptr, *film = nullptr;
      for (const BearingResult& result : computed.results[k]) {
        if (result.law == bearing::Law::hertz) dry = &result;
        if (result.law == law) film = &result;
      }
      if (!dry || !film) break;
      clearances.push_back({std::get<BearingCase>(computed.cases[k].body).geometry.clearance_m, *dry, *film});
    }
    const auto statements = judge_paper_statements(clearances);
    if (statements.empty()) continue;
    text += fmt::format("\nThe paper's statements, hertz against {} with the datum of the cases\n{}", to_string(law),
                        human_statements(statements));
    text += fmt::format(
        "\nThe same for other data (dry/{} at psi = 0)\n{}", to_string(law),
        human_data(compare_data(computed.cases, law, memory, form), scan_datum(computed.cases, law, memory, form)));
  }
  return wrapped_lines(text);
}

/// The cases that were named. Throws UsageError, CaseError.
std::vector<Case> read_bearings(const std::vector<std::string>& names, const CaseChanges& changes) {
  std::vector<Case> cases;
  Faults faults;
  for (const std::string& name : names)
    (void)faults.none_in([&] {
      cases.push_back(changes.read(name));
      if (!std::holds_alternative<BearingCase>(cases.back().body))
        throw case_error(cases.back(), "", "this is a contact; allowed is a bearing case (ehd solve solves this one)");
    });
  faults.refuse();
  return cases;
}

/// The options, and the request of each bearing.
struct Asked {
  std::vector<bearing::Law> laws;  ///< empty: the defaults of each case
  bearing::Form form;
  int cage_positions;
  bool details;
  std::vector<double> frequencies_Hz;

  explicit Asked(const BearingOptions& options)
      : laws(laws_named(options.laws)),
        form(form_named(options.form)),
        cage_positions(positions_asked(options.cage_positions)),
        details(options.details),
        frequencies_Hz(frequencies_asked(options)) {}

  [[nodiscard]] BearingRequest of(const Case& one) const {
    return {.laws = laws.empty() ? default_laws(std::get<BearingCase>(one.body)) : laws,
            .explicitly = !laws.empty(),
            .films = true,
            .form = form,
            .cage_positions = cage_positions,
            .frequencies_Hz = frequencies_Hz};
  }
};

/// JSON and complaints of all results, for output at the end. The text of a case is printed when the case is finished.
struct Account {
  Json list = Json::array();
  std::string text;                     ///< of the last case
  std::vector<std::string> complaints;  ///< lines for standard error
  bool all_balanced = true;
};

/// Adds one case to the account. A result without a budget gets a note that says so.
void add_case(Account& account, const Case& one, std::vector<BearingResult>& results, const Asked& asked,
              ContactMemory& memory) {
  std::string budgets;
  const bool by_ehd = std::any_of(results.begin(), results.end(),
                                  [](const BearingResult& result) { return result.law == bearing::Law::ehd; });
  for (BearingResult& result : results) {
    const auto budget = budget_of(one, results, result.law, memory);
    if (budget.empty())
      if (const auto why = why_no_budget(one, results, result.law, memory))
        result.notes.emplace_back(note::NoBudget{*why});
    if (result.fit && !full_relation_in(results)) result.notes.emplace_back(note::LineAlone{.ehd_failed = by_ehd});
    if (!result.errors) result.errors = numerical_errors(budget);  // of a line without ehd beside it
    account.list.push_back(to_json(result, full_relation_in(results)));
    if (!budget.empty()) {
      account.list.back()["error_budget"] = to_json(budget);
      budgets += fmt::format("\n  error budget of {}: what may move its balance\n{}", to_string(result.law),
                             human_budget(budget));
    }
    if (result.status == StopReason::converged) continue;
    account.all_balanced = false;
    account.complaints.push_back(
        fmt::format("ehd: {}: {}: {}: {}", one.id, to_string(result.law), to_string(result.status), result.why));
  }
  account.text = human_table(one, results, {.details = asked.details}) + (asked.details ? budgets : "");
  if (!std::get<BearingCase>(one.body).lubricant && asked.laws.empty())
    account.text += "\n  ehd-linear and ehd are skipped: the case has no lubricant\n";
}

int bearing(const BearingOptions& options) {
  const Asked asked(options);
  const RegisteredSolver& solver = solver_named(options.solver);
  Computed computed{.cases = read_bearings(options.cases, options.changes), .results = {}};
  for (const Case& one : computed.cases) require_possible(one, asked.of(one));
  require_distinct(files_of(computed.cases), {{"--json", options.json.value_or("")},
                                              {"--plot", options.plot.value_or("")},
                                              {"--csv", options.csv.value_or("")}});
  JsonTarget json(options.json);
  std::optional<OutputFile> csv = opened(options.csv);
  PictureFile plot(options.plot);

  const Request limits = options.limits.request();
  Request request = bearing_contact_request();
  request.max_iterations = limits.max_iterations;
  request.time_limit_s = limits.time_limit_s;
  const Deadline deadline = deadline_in(options.time_limit_total);
  const ContactSolver solve = deadline.limiting(solver.solve);
  Progress progress;
  long solved = 0;
  const auto show = [&](const std::string& what) {  // how many contacts a bearing needs is not known beforehand
    const std::size_t done = computed.results.size();
    const std::size_t all = computed.cases.size();
    progress.step(done, all, done < all ? fmt::format("{}: {}", computed.cases[done].id, what) : what);
  };
  ContactMemory memory(
      [&](const Problem& problem, const Request& with) {
        show(fmt::format("contact {} ...", ++solved));
        return solve(problem, with);
      },
      request);

  ResponseRequest response_request = bearing_response_request();
  response_request.max_iterations = limits.max_iterations;
  response_request.time_limit_s = limits.time_limit_s;
  long responses = 0;
  memory.respond_by(
      [&](const Problem& problem, const ResponseRequest& with) {
        show(fmt::format("response {} ...", ++responses));
        return deadline.limiting(bearing_responder())(problem, with);
      },
      response_request);

  Account account;
  for (const Case& one : computed.cases) {
    computed.results.push_back(run_bearing(one, asked.of(one), memory));
    add_case(account, one, computed.results.back(), asked, memory);
    if (json.to_standard_output()) continue;
    progress.show("");
    print((computed.results.size() > 1 ? "\n" : "") + account.text);
  }
  const std::string statements = json.to_standard_output() ? "" : statements_of(computed, memory, asked.form);
  progress.show("");
  if (csv) {
    if (const auto rows = bearing_csv(computed.cases, computed.results))
      csv->append(*rows);
    else
      account.complaints.push_back("ehd: bearing: nothing balanced, and no CSV is written");
  }
  if (plot) {
    if (const auto svg = bearing_picture(computed.cases, computed.results))
      plot.write(*svg);
    else
      account.complaints.push_back("ehd: bearing: nothing balanced, and no plot is written");
  }
  for (Json& result : account.list) options.changes.put_into(result);
  json.commit(account.list.size() == 1 ? account.list.front() : account.list, {address_of(csv), plot.file()});
  print(statements);
  for (const std::string& complaint : account.complaints) complain(complaint);
  return account.all_balanced ? success : not_met;
}

}  // namespace

void describe_bearing(Command& command) {
  auto options = std::make_shared<BearingOptions>();
  command.summary("Load distribution of a roller bearing, dry and with films");
  command.examples(bearing_help());
  command.list("CASE", options->cases, "case files (TOML), ids of benchmark cases, or - for standard input").required();
  command
      .list("--law", options->laws,
            fmt::format("contact law (repeatable): {} ({}; {} alone without a lubricant)",
                        bearing::names_of(bearing::Laws::all), bearing::names_of(bearing::Laws::by_default),
                        bearing::names_of(bearing::Laws::by_default_dry)))
      .completed_by(bearing::names_of(bearing::Laws::all));
  command.text("--solver", options->solver, "solver of the EHD contacts, one of " + solver_names())
      .showing_default()
      .completed_by(solver_names());
  command
      .text("--form", options->form,
            "plane: the ring moves along and across the load; radial: along it only, as in the paper")
      .showing_default();
  command.text("--cage-positions", options->cage_positions,
               "also balance at this many positions of the cage over one pitch");
  command.flag("--details", options->details,
               "also K and dF of ehd-linear, error budgets, the 2 x 2 stiffness, how the laws were made, costs");
  command.flag("--dynamic", options->dynamic, "also stiffness and damping of the balanced bearing in small motion");
  command.list("--frequency", options->frequencies, "of that motion, in Hz (repeatable; 0)");
  options->limits.add_to(command, false);
  options->changes.add_to(command);
  add_time_limit_total(command, options->time_limit_total);
  command.text("--json", options->json, "the results as JSON into a file, or - for standard output");
  command.text("--plot", options->plot,
               "loads round the bearing, forces and displacements over the azimuth as a figure: FILE.svg or FILE.png");
  command.text("--csv", options->csv, "forces, displacements and films as CSV, one row per roller (and frequency)");
  command.runs([options] { return bearing(*options); });
}

}  // namespace ehd::cli
