// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sweep_row.hpp"

#include <fmt/format.h>

#include <fstream>
#include <new>
#include <nlohmann/json.hpp>

#include "io/bearing_json.hpp"
#include "io/contact_json.hpp"
#include "io/content_hash.hpp"
#include "io/program_text.hpp"
#include "io/provenance.hpp"
#include "workflow/bearing_run.hpp"
#include "workflow/contact_memory.hpp"
#include "workflow/contact_run.hpp"
#include "workflow/film_table_run.hpp"
#include "workflow/registry.hpp"

namespace ehd {

namespace {

constexpr const char* out_of_memory = "memory is exhausted";

/// Two builds of a commit with changes on top, or of a tree without git, are told apart by the program's own bytes.
std::string program_identity() {
  const Json json = provenance();
  std::string identity =
      json.contains("commit") ? json["commit"].get<std::string>() : json["version"].get<std::string>();
  if (json.contains("commit") && !json["dirty"].get<bool>()) return identity;
  std::ifstream program("/proc/self/exe", std::ios::binary);
  return identity + " " + content_hash(program);
}

/// Times out of a result, at any depth.
void strip_times(Json& json) {
  if (json.is_object())
    for (const char* time : {"wall_s", "planning_s", "total_s", "stage_s"}) json.erase(time);
  if (json.is_structured())
    for (auto& inner : json) strip_times(inner);
}

/// The results of a bearing, one a law. The row has a memory of its own, so that the counts are this row's; solutions
/// are shared behind it.
long add_bearing_results(Json& results, const Sweep& sweep, const SweepRequest& request, const Case& row_case,
                         const std::shared_ptr<ContactCache>& cache) {
  Request limits = bearing_contact_request();
  limits.max_iterations = request.max_iterations;
  limits.time_limit_s = request.time_limit_s;
  ContactMemory memory(cache, limits);
  const std::vector<BearingResult> balances = run_bearing(row_case, sweep.request_of(row_case), memory);
  for (const BearingResult& result : balances) results.push_back(to_json(result, full_relation_in(balances)));
  return memory.solves();
}

long add_contact_result(Json& results, const Sweep& sweep, const SweepRequest& request, const Case& row_case) {
  Request limits;
  limits.tolerance = sweep.tolerance;
  limits.max_iterations = request.max_iterations;
  limits.time_limit_s = request.time_limit_s;
  RegisteredSolver solver = *find_solver(sweep.solver);
  solver.solve = request.deadline.limiting(solver.solve);
  const ContactRun run = run_contact(row_case, solver, limits);
  results.push_back(to_json(run));
  return run.plan.runs(stage::solve) ? 1 : 0;
}

Json not_computed(const Sweep& sweep, const Case& row_case, const std::string& why) {
  Json results = Json::array();
  if (!sweep.bearing) {
    const RegisteredSolver& solver = *find_solver(sweep.solver);
    ContactRun run;
    run.case_id = row_case.id;
    run.version = row_case.version;
    run.solver = sweep.table ? table_solver : solver.name;
    run.plan = plan_contact(std::get<ContactCase>(row_case.body), solver, {}, want_everything());
    run.solution.record.status = StopReason::limit_reached;
    run.solution.record.reason = why;
    results.push_back(to_json(run));
    return results;
  }
  const BearingRequest asked = sweep.request_of(row_case);
  for (const bearing::Law law : asked.laws) {
    BearingResult result;
    result.case_id = row_case.id;
    result.version = row_case.version;
    result.law = law;
    result.form = asked.form;
    result.status = StopReason::limit_reached;
    result.why = why;
    result.plan = plan_bearing(std::get<BearingCase>(row_case.body), {law}, asked.form, asked.cage_positions);
    results.push_back(to_json(result));
  }
  return results;
}

/// The row's object in rows.json but its number.
std::string kept_text(const Sweep& sweep, std::size_t row, const std::string& hash, Json results) {
  Json json = Json::object();
  json["keys"] = Json::object();
  for (const Substitution& one : sweep.values_of(row)) json["keys"][one.key] = to_json(one.value);
  json["hash"] = hash;
  strip_times(results);
  json["results"] = std::move(results);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string row_hash(const Sweep& sweep, const SweepRequest& request, std::size_t row) {
  static const std::string program = program_identity();
  const double tolerance = sweep.bearing ? bearing_contact_request().tolerance.tightest() : sweep.tolerance;
  std::string content = fmt::format("{}\n{}\n{}\n{}\n{}\n", sweep_schema, program, sweep.solver, request.max_iterations,
                                    shortest(tolerance));
  for (const bearing::Law law : sweep.laws) content += std::string(to_string(law)) + " ";
  content += "\n" + sweep.case_id + "\n";
  if (sweep.table) {
    const FilmRange& range = sweep.table->range;
    content += fmt::format("table {} {} {} {}\n", shortest(range.M_low), shortest(range.M_high), shortest(range.L_low),
                           shortest(range.L_high));
  }
  for (const Substitution& one : sweep.values_of(row))
    content += fmt::format("{} = {}\n", one.key, toml_text(one.value));
  return content_hash(content + sweep.case_text);
}

ComputedRow compute_row(const Sweep& sweep, const SweepRequest& request, std::size_t row, const std::string& hash,
                        const std::shared_ptr<ContactCache>& cache, const FilmTable* table) {
  const Case row_case = sweep.case_of(row);
  ComputedRow computed;
  try {
    Json results = Json::array();
    if (table) {
      results.push_back(to_json(run_from_table(row_case, *table)));
      computed.needed = 1;
    } else {
      computed.needed = sweep.bearing ? add_bearing_results(results, sweep, request, row_case, cache)
                                      : add_contact_result(results, sweep, request, row_case);
    }
    computed.text = kept_text(sweep, row, hash, std::move(results));
  } catch (const std::bad_alloc&) {
    return row_not_computed(sweep, row, hash, out_of_memory);
  }
  return computed;
}

ComputedRow row_not_computed(const Sweep& sweep, std::size_t row, const std::string& hash, const std::string& why) {
  return {.text = kept_text(sweep, row, hash, not_computed(sweep, sweep.case_of(row), why))};
}

bool lacked_time_or_memory(const std::string& kept) {
  // Inside a text of the row the quotation marks would be escaped.
  static const std::string status = "\"status\":\"" + std::string(to_string(StopReason::limit_reached)) + "\"";
  const auto says = [&](const char* why) { return kept.find(why) != std::string::npos; };
  return kept.find(status) != std::string::npos && (says(Deadline::out_of_time) || says(Deadline::not_run) ||
                                                    says(out_of_memory) || says(limit_ended_film_curves));
}

bool converged(const Json& result) { return result["status"] == to_string(StopReason::converged); }

std::string reason_of(const Json& result) {
  for (const char* key : {"why", "reason"})
    if (result.contains(key)) return result[key].get<std::string>();
  if (converged(result) || !result.contains("notes") || result["notes"].empty()) return "";
  return result["notes"].back().get<std::string>();
}

std::optional<std::string> failure_of(const Json& row) {
  for (const Json& result : row["results"]) {
    if (converged(result)) continue;
    const std::string law = result.contains("law") ? result["law"].get<std::string>() + ": " : "";
    const std::string why = reason_of(result);
    return fmt::format("row {}: {}{}{}", row["row"].dump(), law, result["status"].get<std::string>(),
                       why.empty() ? "" : ": " + why);
  }
  return std::nullopt;
}

}  // namespace ehd
