// SPDX-License-Identifier: GPL-3.0-or-later
// ehd compare: solvers side by side on each case: time, films, reported and achieved errors.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "contact/text.hpp"
#include "io/contact_json.hpp"
#include "io/json.hpp"
#include "io/tables.hpp"
#include "verification/bench/csv.hpp"
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
};

const char* const compare_examples = R"(
Examples:
  ehd compare own-moes-20-10 own-moes-100-10
  ehd compare own-moes-20-10 --solver fast --solver reference --tolerance 1e-3
  ehd compare own-barus-3-4-flooded --json comparison.json

The achieved error is the difference from the case's own expectation (the one with the smallest uncertainty). A case
without one is compared with the run whose error estimate is smallest. Exit code: 0 every run converged; 1 one did not;
2 bad input or usage.)";

struct Row {
  double tolerance = 0;
  ContactRun run;
  std::optional<double> reported[2] = {};  ///< of each film, relative
  std::optional<double> achieved[2] = {};
};

/// The expectation with the smallest uncertainty. Fits and values that still wait for their source do not count.
const Expectation* truth_of(const Case& contact_case, Quantity quantity) {
  const Expectation* best = nullptr;
  for (const auto& expectation : contact_case.expectations) {
    if (expectation.waiting || expectation.kind == ExpectationKind::fit) continue;
    if (expectation.quantity != to_string(quantity)) continue;
    if (!best || expectation.uncertainty < best->uncertainty) best = &expectation;
  }
  return best;
}

/// Fills in the achieved errors of one film; returns what the film was compared with.
std::string judge_film(const Case& contact_case, std::vector<Row>& rows, std::size_t film) {
  const Quantity quantity = judged_films[film];
  if (const Expectation* truth = truth_of(contact_case, quantity)) {
    for (Row& row : rows) {
      const auto measured = measure(row.run, *truth);
      if (measured && truth->value != 0)
        row.achieved[film] = std::abs(measured->value - truth->value) / std::abs(truth->value);
    }
    return "the case's " + truth->digits + " (relative uncertainty " + plain(truth->uncertainty, 2) + ")";
  }
  const Row* tightest = nullptr;
  for (const Row& row : rows) {
    if (row.run.status() != StopReason::converged || !row.reported[film]) continue;
    if (!tightest || *row.reported[film] < *tightest->reported[film]) tightest = &row;
  }
  if (!tightest) return "nothing: no expectation, and no run converged";
  const double value = verification::reading_of(tightest->run.solution, quantity)->value;
  for (Row& row : rows) {
    const Reading* reading = verification::reading_of(row.run.solution, quantity);
    if (reading && &row != tightest) row.achieved[film] = std::abs(reading->value - value) / std::abs(value);
  }
  return "the tightest run, " + tightest->run.solver + " at " + plain(tightest->tolerance);
}

/// Every solver at every tolerance, with the errors that they report.
std::vector<Row> run_all(const Case& contact_case, const std::vector<const RegisteredSolver*>& solvers,
                         const std::vector<Request>& requests) {
  std::vector<Row> rows;
  Progress progress;
  for (const RegisteredSolver* solver : solvers) {
    for (const Request& request : requests) {
      progress.show(fmt::format("{}: {} at {} ...", contact_case.id, solver->name, plain(*request.tolerance)));
      Row row{.tolerance = *request.tolerance, .run = run_contact(contact_case, *solver, request)};
      for (std::size_t film = 0; film < 2; ++film) {
        if (const Reading* reading = verification::reading_of(row.run.solution, judged_films[film]))
          row.reported[film] = reading->error;
      }
      rows.push_back(std::move(row));
    }
  }
  return rows;
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
      cells.push_back(verification::dash(row.reported[film], 2));
      cells.push_back(verification::dash(row.achieved[film], 2));
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
  Json achieved = Json::object();
  for (std::size_t film = 0; film < 2; ++film)
    put(achieved, std::string(to_string(judged_films[film])), row.achieved[film]);
  entry["achieved_error"] = achieved;
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

int compare(const CompareOptions& options) {
  if (options.cases.empty()) throw UsageError("compare: a CASE is missing; required is at least one");
  std::vector<const RegisteredSolver*> solvers;
  for (const auto& name : options.solvers) solvers.push_back(&solver_named(name));
  if (solvers.empty()) solvers = {&certified_solver(), &default_solver()};
  const std::vector<Request> requests = requests_of(options);
  // Everything that can be refused is refused before the first solve.
  const std::vector<Case> cases = verification::contacts_named(options.cases);
  require_distinct(files_of(cases), {{"--json", options.json.value_or("")}});
  JsonTarget json(options.json);

  Json list = Json::array();
  bool all_converged = true;
  for (const Case& contact_case : cases) {
    std::vector<Row> rows = run_all(contact_case, solvers, requests);
    const std::string against[2] = {judge_film(contact_case, rows, 0), judge_film(contact_case, rows, 1)};
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
  json.commit(list);
  return all_converged ? success : not_met;
}

}  // namespace

void describe_compare(Command& command) {
  auto options = std::make_shared<CompareOptions>();
  command.summary("Solvers side by side: time, error, work");
  command.examples(compare_examples);
  command.list("CASE", options->cases, "case files (TOML), or ids of benchmark cases");
  command.list(
      "--solver", options->solvers,
      fmt::format("one of {} (repeatable; {} and {})", solver_names(), certified_solver().name, default_solver().name));
  command.list("--tolerance", options->tolerances, "relative error of the films (repeatable; 1e-2, 1e-3, 1e-4)");
  options->limits.add_to(command, false);
  command.text("--json", options->json, "the comparison as JSON into a file, or - for standard output");
  command.runs([options] { return compare(*options); });
}

}  // namespace ehd::cli
