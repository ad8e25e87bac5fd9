// SPDX-License-Identifier: GPL-3.0-or-later
// ehd compare: solvers side by side on each case: time, films, reported and achieved errors.
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
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "contact/text.hpp"
#include "io/contact_json.hpp"
#include "io/json.hpp"
#include "io/tables.hpp"
#include "verification/bench/csv.hpp"
#include "verification/bench/film_truth.hpp"
#include "verification/bench/work_precision.hpp"
#include "workflow/case.hpp"
#include "workflow/contact_run.hpp"
#include "workflow/registry.hpp"

namespace ehd::cli {

namespace {

struct CompareOptions {
  std::vector<std::string> cases, solvers, tolerances;
  std::optional<std::string> json;
  RequestOptions limits;
  CaseChanges changes;
};

const char* const compare_examples = R"(
Examples:
  ehd compare own-moes-20-10 own-moes-100-10
  ehd compare own-moes-20-10 --solver fast --solver reference --tolerance 1e-3
  ehd compare own-barus-3-4-flooded --json comparison.json

The achieved error is the difference from one truth for both films: the case's own digits where it has some of both,
else the solution that states the smallest error among these runs and one more run of the certified solver, which is
asked for a hundredth of the tightest tolerance. No run is judged by itself. Where the truth is not ten times more
accurate than an error, a bound is printed (<).

Exit code: 0 every run converged; 1 one did not; 2 bad input or usage.)";

using Row = verification::JudgedRun;

/// The further run is asked for this part of the tightest tolerance, and for no less than `reference` reaches anywhere.
constexpr double truth_over_tightest = 1e-2, tightest_truth = 1e-10;

/// Every solver at every tolerance, with the errors that they report.
std::vector<Row> run_all(const Case& contact_case, const std::vector<const RegisteredSolver*>& solvers,
                         const std::vector<Request>& requests) {
  std::vector<Row> rows;
  Progress progress;
  for (const RegisteredSolver* solver : solvers) {
    for (const Request& request : requests) {
      progress.show(
          fmt::format("{}: {} at {} ...", contact_case.id, solver->name, plain(request.tolerance.tightest())));
      Row row{.tolerance = request.tolerance.tightest(), .run = run_contact(contact_case, *solver, request)};
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

std::vector<std::vector<std::string>> table_of(const std::vector<Row>& rows) {
  std::vector<std::vector<std::string>> table{{"solver", "tolerance", "status", "H_min", "reported", "achieved",
                                               "H_cen", "reported", "achieved", "time [ms]", "work units",
                                               "intervals"}};
  for (const Row& row : rows) {
    std::vector<std::string> cells{row.run.solver, plain(row.tolerance), std::string(to_string(row.run.status()))};
    for (std::size_t film = 0; film < 2; ++film) {
      const Reading* reading = verification::reading_of(row.run.solution, judged_films[film]);
      cells.push_back(reading ? with_error(reading->value, reading->error) : "-");
      cells.push_back(verification::dash(row.films[film].reported, 2));
      cells.push_back(row.films[film].words());
    }
    const Cost& cost = row.run.solution.record.cost;
    cells.push_back(plain(1e3 * cost.wall_s, 3));
    cells.push_back(cost.nodes > 0 ? plain(cost.work_units, 3) : "-");
    cells.push_back(cost.nodes > 0 ? std::to_string(cost.nodes) : "-");
    table.push_back(cells);
  }
  return table;
}

Json json_of(const Row& row) {
  Json entry = to_json(row.run);
  put(entry, "tolerance", row.tolerance);
  Json known = Json::object(), below = Json::object();
  for (std::size_t film = 0; film < 2; ++film) {
    put(known, std::string(to_string(judged_films[film])), row.films[film].known());
    put(below, std::string(to_string(judged_films[film])), row.films[film].bound());
  }
  entry["achieved_error"] = known;
  if (!below.empty()) entry["achieved_error_below"] = below;
  return entry;
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
std::vector<Case> contacts_of(const CompareOptions& options) {
  std::vector<Case> cases;
  for (const auto& name : options.cases) {
    cases.push_back(options.changes.read(name));
    verification::require_lubricated(cases.back());
  }
  return cases;
}

int compare(const CompareOptions& options) {
  if (options.cases.empty()) throw UsageError("compare: a CASE is missing; required is at least one");
  std::vector<const RegisteredSolver*> solvers;
  for (const auto& name : options.solvers) solvers.push_back(&solver_named(name));
  if (solvers.empty()) solvers = {&certified_solver(), &default_solver()};
  const std::vector<Request> requests = requests_of(options);
  // Everything that can be refused is refused before the first solve.
  const std::vector<Case> cases = contacts_of(options);
  require_distinct(files_of(cases), {{"--json", options.json.value_or("")}});
  JsonTarget json(options.json);

  Json list = Json::array();
  bool all_converged = true;
  for (const Case& contact_case : cases) {
    std::vector<Row> rows = run_all(contact_case, solvers, requests);
    const auto truth = verification::film_truth(contact_case, rows, [&] { return one_more(contact_case, requests); });
    for (Row& row : rows)
      if (truth) verification::judge(row, *truth);
    const std::string none = "nothing: the case has no digits of both films, and no run has films with errors";
    const std::string against[2] = {truth ? truth->words[0] : none, truth ? truth->words[1] : none};
    Json runs = Json::array();
    for (const Row& row : rows) {
      all_converged = all_converged && converged(row);
      if (!converged(row)) complain(failure_of(contact_case, row));
      runs.push_back(json_of(row));
    }
    list.push_back({{"case", contact_case.id},
                    {"version", contact_case.version},
                    {"truth", {{"film.minimum", against[0]}, {"film.central", against[1]}}},
                    {"runs", runs}});
    if (json.to_standard_output()) continue;
    constexpr std::size_t names = 3;
    print(fmt::format("{}: {}\n{}  achieved: H_min against {}\n            H_cen against {}\n\n", contact_case.id,
                      contact_case.title, aligned(table_of(rows), names, "  "), against[0], against[1]));
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
  command.list(
      "--solver", options->solvers,
      fmt::format("one of {} (repeatable; {} and {})", solver_names(), certified_solver().name, default_solver().name));
  command.list("--tolerance", options->tolerances, "relative error of the films (repeatable; 1e-2, 1e-3, 1e-4)");
  options->limits.add_to(command, false);
  options->changes.add_to(command);
  command.text("--json", options->json, "the comparison as JSON into a file, or - for standard output");
  command.runs([options] { return compare(*options); });
}

}  // namespace ehd::cli
