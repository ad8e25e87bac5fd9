// SPDX-License-Identifier: GPL-3.0-or-later
// ehd compare: solvers side by side on each case: time, films, reported and achieved errors.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/case_choice.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "contact/text.hpp"
#include "io/contact_json.hpp"
#include "io/duration.hpp"
#include "io/faults.hpp"
#include "io/json.hpp"
#include "io/result_head.hpp"
#include "io/tables.hpp"
#include "verification/bench/csv.hpp"
#include "verification/bench/film_truth.hpp"
#include "verification/bench/work_precision.hpp"
#include "verification/judge/external.hpp"
#include "workflow/case.hpp"
#include "workflow/contact_run.hpp"
#include "workflow/registry.hpp"

namespace ehd::cli {

namespace {

struct CompareOptions {
  std::vector<std::string> cases, solvers, tolerances, externals;
  std::optional<std::string> json;
  RequestOptions limits;
  CaseChanges changes;
};

const char* const compare_examples = R"(
Examples:
  ehd compare own-moes-20-10 own-moes-100-10
  ehd compare own-moes-20-10 --solver fast --solver reference --tolerance 1e-3
  ehd compare own-barus-3-4-flooded --json comparison.json
  ehd compare own-barus-5-5 --external mine='python3 mine.py {case} {out} {tolerance}'

stated: the error that a solver gives. achieved: the difference from the truth; < where the truth is known less than ten
times better than that. ! where either is above the tolerance asked for. The truth is the digits of the case, if it has
some of both films. Otherwise reference runs once more, a hundred times tighter, and the run that states the smallest
error is the truth. No run is judged by itself.

--external runs another program by the shell, for each case and tolerance. {case} is a JSON file with the groups, the
laws as formulas and the inlet. The program writes a submission (docs/judge.md) into {out}. Its time includes its start;
the time of an empty call is printed too. An external run is never the truth. Films far off the case's digits that fit a
usual mistake get a hint on standard error.

Exit code: 0 every run converged; 1 one did not; 2 bad input or usage.)";

using Row = verification::JudgedRun;

/// The further run is asked for this part of the tightest tolerance, and for no less than `reference` reaches anywhere.
constexpr double truth_over_tightest = 1e-2, tightest_truth = 1e-10;

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Every solver at every tolerance, with the errors that they report.
std::vector<Row> run_all(const Case& contact_case, const std::vector<const RegisteredSolver*>& solvers,
                         const std::vector<Request>& requests) {
  std::vector<Row> rows;
  std::vector<PlannedRun> planned;
  for (const RegisteredSolver* solver : solvers)
    planned.insert(planned.end(), requests.size(), {.solver = solver->name, .quick = !solver->dense()});
  Progress progress;
  for (const RegisteredSolver* solver : solvers) {
    for (const Request& request : requests) {
      progress.step(rows.size(), planned.size(),
                    fmt::format("{}: {} at {} ...", contact_case.id, solver->name, plain(request.tolerance.tightest())),
                    time_left_s(planned));
      const auto begin = std::chrono::steady_clock::now();
      Row row{.tolerance = request.tolerance.tightest(), .run = run_contact(contact_case, *solver, request)};
      planned[rows.size()].took_s = seconds_since(begin);
      for (std::size_t film = 0; film < 2; ++film) {
        if (const Reading* reading = verification::reading_of(row.run.solution, judged_films[film]))
          row.films[film].reported = reading->error;
      }
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

/// A run of the certified solver that is tighter than all of `requests`.
Row one_more(const Case& contact_case, const std::vector<Request>& requests) {
  Request request = requests.front();
  double tightest = request.tolerance.tightest();
  for (const Request& other : requests) tightest = std::min(tightest, other.tolerance.tightest());
  request.tolerance = std::max(truth_over_tightest * tightest, std::min(tightest_truth, tightest));
  Progress progress;
  progress.show(fmt::format("{}: the truth, {} at {} ...", contact_case.id, certified_solver().name,
                            plain(request.tolerance.tightest())));
  Row row;
  row.tolerance = request.tolerance.tightest();
  row.run = run_contact(contact_case, certified_solver(), request);
  return row;
}

bool converged(const Row& row) { return row.run.status() == StopReason::converged; }

std::string failure_of(const Case& contact_case, const Row& row) {
  const std::string& reason = row.run.solution.record.reason;
  return fmt::format("ehd: {}: {} at {}: {}{}", contact_case.id, row.run.solver, plain(row.tolerance),
                     to_string(row.run.status()), reason.empty() ? "" : ": " + reason);
}

/// The reason of an external run says how its command ended, which none of our words for a solve does.
std::string failure_of(const Case& contact_case, const judging::ExternalRun& external) {
  const Row& row = external.judged;
  return fmt::format("ehd: {}: {} at {}: {}", contact_case.id, row.run.solver, plain(row.tolerance),
                     row.run.solution.record.reason);
}

std::string hint_of(const Case& contact_case, const judging::ExternalRun& external, const std::string& hint) {
  return fmt::format("ehd: {}: {} at {}: {}", contact_case.id, external.judged.run.solver,
                     plain(external.judged.tolerance), hint);
}

bool states_more(const Row& row, std::size_t film) {
  const std::optional<double>& stated = row.films[film].reported;
  return stated && *stated > row.tolerance;
}

bool misses(const Row& row) {
  for (std::size_t film = 0; film < 2; ++film)
    if (states_more(row, film) || row.films[film].beyond(row.tolerance)) return true;
  return false;
}

/// Behind an error that is above the tolerance asked for.
constexpr const char* missed = "!";

std::vector<std::vector<std::string>> table_of(const std::vector<Row>& rows) {
  std::vector<std::vector<std::string>> table{
      {"solver", "asked", "H_min", "stated", "achieved", "H_cen", "stated", "achieved", "ms", "work"}};
  for (const Row& row : rows) {
    std::vector<std::string> cells{row.run.solver + (converged(row) ? "" : "*"), plain(row.tolerance)};
    for (std::size_t film = 0; film < 2; ++film) {
      const Reading* reading = verification::reading_of(row.run.solution, judged_films[film]);
      const verification::AchievedError& error = row.films[film];
      cells.push_back(reading ? with_error(reading->value, reading->error) : "-");
      cells.push_back(verification::dash(error.reported, 2) + (states_more(row, film) ? missed : ""));
      cells.push_back(error.words() + (error.beyond(row.tolerance) ? missed : ""));
    }
    const Cost& cost = row.run.solution.record.cost;
    cells.push_back(milliseconds(cost.wall_s));
    cells.push_back(cost.nodes > 0 ? plain(cost.work_units, 3) : "-");
    table.push_back(cells);
  }
  return table;
}

Json json_of(const Row& row) {
  Json entry = to_json(row.run);
  put(entry, "tolerance", row.tolerance);
  Json known = Json::object(), below = Json::object(), within = Json::object();
  for (std::size_t film = 0; film < 2; ++film) {
    const std::string name(to_string(judged_films[film]));
    put(known, name, row.films[film].known());
    put(below, name, row.films[film].bound());
    const bool met = row.films[film].within(row.tolerance);
    if (met || row.films[film].beyond(row.tolerance)) within[name] = met;
  }
  entry["achieved_error"] = known;
  entry["within_tolerance"] = within;
  if (!below.empty()) entry["achieved_error_below"] = below;
  return entry;
}

/// The external solvers, at the same tolerances and with the same time limit.
std::vector<judging::ExternalRun> run_externals(const Case& contact_case,
                                                const std::vector<judging::ExternalSolver>& externals,
                                                const std::vector<Request>& requests) {
  std::vector<judging::ExternalRun> runs;
  std::vector<PlannedRun> planned;
  for (const judging::ExternalSolver& solver : externals)
    planned.insert(planned.end(), requests.size(), {.solver = solver.name});
  Progress progress;
  for (const judging::ExternalSolver& solver : externals) {
    for (const Request& request : requests) {
      const double tolerance = request.tolerance.tightest();
      progress.step(runs.size(), planned.size(),
                    fmt::format("{}: {} at {} ...", contact_case.id, solver.name, plain(tolerance)),
                    time_left_s(planned));
      const auto begin = std::chrono::steady_clock::now();
      runs.push_back(judging::run_external(solver, contact_case, tolerance, request.time_limit_s));
      planned[runs.size() - 1].took_s = seconds_since(begin);
    }
  }
  return runs;
}

Json json_of(const judging::ExternalRun& external, std::optional<double> idle_s) {
  Json entry = json_of(external.judged);
  Json ended{{"ended", external.end.words}};
  if (external.end.exit_code) ended["exit_code"] = *external.end.exit_code;
  if (!external.end.last_line.empty()) ended["last_line"] = external.end.last_line;
  put(ended, "wall_s", external.end.wall_s);
  put(ended, "idle_s", idle_s);
  if (!external.hints.empty()) ended["hints"] = external.hints;
  entry["external"] = ended;
  return entry;
}

/// Throws UsageError.
std::vector<judging::ExternalSolver> externals_of(const CompareOptions& options) {
  std::vector<judging::ExternalSolver> externals;
  for (const std::string& text : options.externals) {
    try {
      judging::ExternalSolver made = judging::external_from(text);
      const bool taken = find_solver(made.name) ||
                         std::ranges::any_of(externals, [&](const auto& other) { return other.name == made.name; });
      if (taken) throw std::invalid_argument("has the name of another solver in this table; allowed is a new name");
      externals.push_back(std::move(made));
    } catch (const std::invalid_argument& fault) {
      throw option_error("--external", text, fault.what());
    }
  }
  return externals;
}

/// Throws UsageError.
std::vector<Request> requests_of(const CompareOptions& options) {
  std::vector<Request> requests;
  for (const auto& tolerance :
       options.tolerances.empty() ? std::vector<std::string>{"1e-2", "1e-3", "1e-4"} : options.tolerances) {
    RequestOptions one = options.limits;
    one.tolerance = tolerance;
    requests.push_back(one.request());
  }
  return requests;
}

/// Throws UsageError, CaseError.
std::vector<Case> contact_cases_of(const CompareOptions& options) {
  std::vector<Case> cases;
  Faults faults;
  for (const auto& name : options.cases)
    (void)faults.none_in([&] {
      cases.push_back(options.changes.read(name));
      verification::require_lubricated(cases.back());
    });
  faults.refuse();
  return cases;
}

int compare(const CompareOptions& options) {
  if (options.cases.empty()) throw UsageError("compare: a CASE is missing; required is at least one");
  std::vector<const RegisteredSolver*> solvers;
  for (const auto& name : options.solvers) solvers.push_back(&solver_named(name));
  if (solvers.empty()) solvers = {&certified_solver(), &default_solver()};
  const std::vector<Request> requests = requests_of(options);
  const std::vector<judging::ExternalSolver> externals = externals_of(options);
  const std::optional<double> idle_s = externals.empty() ? std::nullopt : judging::idle_call_s();
  // Everything that can be refused is refused before the first solve.
  const std::vector<Case> cases = contact_cases_of(options);
  require_distinct(files_of(cases), {{"--json", options.json.value_or("")}});
  JsonTarget json(options.json);

  Json list = Json::array();
  bool all_converged = true;
  for (const Case& contact_case : cases) {
    std::vector<Row> rows = run_all(contact_case, solvers, requests);
    const auto truth = verification::film_truth(contact_case, rows, [&] { return one_more(contact_case, requests); });
    std::vector<judging::ExternalRun> outside = run_externals(contact_case, externals, requests);
    for (Row& row : rows)
      if (truth) verification::judge(row, *truth);
    for (judging::ExternalRun& external : outside)
      if (truth) verification::judge(external.judged, *truth);
    const std::string none = "nothing: the case has no digits of both films, and no run has films with errors";
    const std::string against[2] = {truth ? truth->words[0] : none, truth ? truth->words[1] : none};
    Json runs = Json::array();
    for (const Row& row : rows) {
      all_converged = all_converged && converged(row);
      if (!converged(row)) complain(failure_of(contact_case, row));
      runs.push_back(json_of(row));
    }
    for (const judging::ExternalRun& external : outside) {
      all_converged = all_converged && converged(external.judged);
      if (!converged(external.judged)) complain(failure_of(contact_case, external));
      for (const std::string& hint : external.hints) complain(hint_of(contact_case, external, hint));
      runs.push_back(json_of(external, idle_s));
      rows.push_back(external.judged);
    }
    Json comparison = result_head("ehd-compare-1");
    comparison.update({{"case", contact_case.id},
                       {"version", contact_case.version},
                       {"truth", {{"film.minimum", against[0]}, {"film.central", against[1]}}},
                       {"runs", runs}});
    list.push_back(comparison);
    if (json.to_standard_output()) continue;
    constexpr std::size_t names = 2;  // solver and tolerance
    std::string legend = std::ranges::all_of(rows, converged) ? "" : "  * not converged\n";
    if (std::ranges::any_of(rows, misses)) legend += fmt::format("  {} above the tolerance asked for\n", missed);
    print(fmt::format("{}: {}\n{}{}  achieved: H_min against {}\n            H_cen against {}\n\n", contact_case.id,
                      contact_case.title, aligned_in_parts(table_of(rows), names, "  "), legend, against[0],
                      against[1]));
    if (idle_s) print(fmt::format("  an idle call of the shell takes {} ms\n\n", milliseconds(*idle_s, 2)));
  }
  for (Json& compared : list) options.changes.put_into(compared);
  json.commit(list);
  return all_converged ? success : not_met;
}

}  // namespace

void describe_compare(Command& command) {
  auto options = std::make_shared<CompareOptions>();
  command.summary("Solvers side by side: time, error, work");
  command.examples(compare_examples);
  command.list("CASE", options->cases, "case files (TOML), ids of benchmark cases, or - for standard input");
  command
      .list("--solver", options->solvers,
            fmt::format("one of {} (repeatable; {} and {})", solver_names(), certified_solver().name,
                        default_solver().name))
      .completed_by(solver_names());
  command.list("--tolerance", options->tolerances, "relative error of the films (repeatable; 1e-2, 1e-3, 1e-4)");
  command
      .list("--external", options->externals, "another program (repeatable): NAME='command {case} {out} {tolerance}'")
      .called("NAME=COMMAND");
  options->limits.add_to(command, false);
  options->changes.add_to(command);
  command.text("--json", options->json, "the comparison as JSON into a file, or - for standard output");
  command.runs([options] { return compare(*options); });
}

}  // namespace ehd::cli
