// SPDX-License-Identifier: GPL-3.0-or-later
// The files of the work-precision benchmark: JSON and CSV.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "verification/bench/csv.hpp"
#include "verification/bench/work_precision.hpp"

namespace ehd::verification {

namespace {

Json setting_json(const Setting& setting) {
  Json json;
  json["solver"] = setting.solver;
  put(json, "tolerance", setting.tolerance);
  if (setting.nodes) json["nodes"] = *setting.nodes;
  return json;
}

Json truth_json(const Truth& truth) {
  Json json{{"case", truth.case_id}, {"solver", truth.solver}, {"tolerance", truth.tolerance}};
  if (truth.status) json["status"] = to_string(*truth.status);
  if (!truth.reason.empty()) json["reason"] = truth.reason;
  put(json, "wall_s", truth.wall_s);
  if (!truth.status) return json;
  for (const Judged judged : all_judged) {
    const auto at = static_cast<std::size_t>(judged);
    Json entry = Json::object();
    if (judged != Judged::pressure) put(entry, "value", truth.value[at]);
    if (truth.error[at] > 0) put(entry, "error", truth.error[at]);
    if (judged != Judged::pressure && truth.from_digits[at]) {
      put(entry, "from_digits", truth.from_digits[at]);
      put(entry, "digits_uncertainty", truth.digits_uncertainty[at]);
    }
    json[std::string(to_string(judged))] = entry;
  }
  return json;
}

Json row_json(const WorkRow& row) {
  Json json{{"case", row.case_id}};
  json.update(setting_json(row.setting));
  json["status"] = status_cell(row.status);
  if (!row.reason.empty()) json["reason"] = row.reason;
  if (!row.status) return json;
  const auto [fastest, slowest] = std::minmax_element(row.wall_s.begin(), row.wall_s.end());
  Json cost{
      {"wall_s", median(row.wall_s)}, {"fastest_s", *fastest}, {"slowest_s", *slowest}, {"solves", row.wall_s.size()}};
  put(cost, "planning_s", row.cost.planning_s);
  put(cost, "total_s", median(row.wall_s) + row.cost.planning_s);
  if (row.cost.nodes > 0) {
    put(cost, "work_units", row.cost.work_units);
    cost["nodes"] = row.cost.nodes;
    cost["levels"] = row.cost.levels;
  }
  cost["convolutions"] = row.cost.convolutions;
  cost["newton_iterations"] = row.cost.newton_iterations;
  cost["krylov_iterations"] = row.cost.krylov_iterations;
  for (const auto& [stage, seconds] : row.cost.stage_s) put(cost["stage_s"], stage, seconds);
  json["cost"] = cost;
  for (const Judged judged : all_judged) {
    const AchievedError& error = row.error(judged);
    Json entry = Json::object();
    put(entry, "reported", error.reported);
    put(entry, "achieved", error.achieved);
    if (covered(error) != Covered::undecided) entry["covered"] = covered(error) == Covered::yes;
    if (error.achieved) {
      put(entry, "truth_error", error.truth);
      entry["bound_only"] = *error.achieved < truth_margin * error.truth;
    }
    if (!entry.empty()) json[std::string(to_string(judged))] = entry;
  }
  return json;
}

/// At each error level: the quickest setting of each solver, and the ratios of times.
Json at_equal_error(const WorkPrecisionResult& result, Judged judged, const std::string& case_id) {
  Json list = Json::array();
  for (const double level : error_levels(judged)) {
    Json entry{{"quantity", to_string(judged)}, {"case", case_id}, {"level", level}};
    entry["quickest"] = Json::array();
    for (const auto& solver : result.solvers) {
      const WorkRow* best = quickest(result.rows, case_id, solver, judged, level);
      if (!best) continue;
      Json one = setting_json(best->setting);
      one["wall_s"] = median(best->wall_s);
      entry["quickest"].push_back(one);
    }
    for (const ComparedSolvers& pair : compared_solvers()) {
      const auto at = ratios(result.rows, case_id, pair.solver, pair.over, judged, {level});
      if (!at.empty()) entry["ratios"][pair.name()] = at.front().value;
    }
    list.push_back(entry);
  }
  return list;
}

Json crossovers(const WorkPrecisionResult& result, Judged judged, const std::string& case_id) {
  Json list = Json::array();
  for (const ComparedSolvers& pair : compared_solvers()) {
    const auto by_level = ratios(result.rows, case_id, pair.solver, pair.over, judged, error_levels(judged));
    if (const auto at = crossover(by_level))
      list.push_back({{"quantity", to_string(judged)},
                      {"case", case_id},
                      {"ratio", pair.name()},
                      {"looser", at->looser},
                      {"tighter", at->tighter},
                      {"ahead_when_tighter", at->rises ? pair.over : pair.solver}});
  }
  return list;
}

Json coverage_json(const WorkPrecisionResult& result, Judged judged) {
  Json list = Json::array();
  for (const auto& solver : result.solvers) {
    const Coverage found = coverage(result.rows, solver, judged);
    Json entry{{"quantity", to_string(judged)},
               {"solver", solver},
               {"covered", found.yes},
               {"missed", found.no},
               {"undecided", found.undecided}};
    put(entry, "median_excess", found.median_excess);
    put(entry, "smallest_excess", found.worst_excess);
    list.push_back(entry);
  }
  return list;
}

}  // namespace

Json to_json(const WorkPrecisionResult& result) {
  Json json;
  json["solvers"] = result.solvers;
  put(json, "cpu_share", result.cpu_share);
  if (result.c_s > 0) put(json, "c_s", result.c_s);
  for (const char* list : {"truths", "rows", "at_equal_error", "crossovers", "coverage"}) json[list] = Json::array();
  for (const Truth& truth : result.truths) json["truths"].push_back(truth_json(truth));
  for (const WorkRow& row : result.rows) json["rows"].push_back(row_json(row));
  const auto append = [&](const char* list, const Json& more) {
    for (const Json& entry : more) json[list].push_back(entry);
  };
  for (const Judged judged : all_judged) {
    for (const Truth& truth : result.truths) append("at_equal_error", at_equal_error(result, judged, truth.case_id));
    for (const Truth& truth : result.truths) append("crossovers", crossovers(result, judged, truth.case_id));
    if (judged == Judged::pressure) continue;  // no solver reports its error
    append("coverage", coverage_json(result, judged));
  }
  return json;
}

namespace {

std::vector<std::string> csv_cells(const WorkRow& row) {
  std::vector<std::string> cells{row.case_id,
                                 row.setting.solver,
                                 csv_number(row.setting.tolerance),
                                 row.setting.nodes ? std::to_string(*row.setting.nodes) : "",
                                 status_cell(row.status),
                                 row.reason};
  if (row.status) {
    const auto [fastest, slowest] = std::minmax_element(row.wall_s.begin(), row.wall_s.end());
    const bool grid = row.cost.nodes > 0;
    for (const double s : {median(row.wall_s), *fastest, *slowest}) cells.push_back(csv_number(s));
    cells.push_back(std::to_string(row.wall_s.size()));
    cells.push_back(csv_number(row.cost.planning_s));
    cells.push_back(grid ? csv_number(row.cost.work_units) : "");
    for (const long count : {row.cost.convolutions, row.cost.newton_iterations, row.cost.krylov_iterations})
      cells.push_back(std::to_string(count));
    for (const int count : {row.cost.nodes, row.cost.levels}) cells.push_back(grid ? std::to_string(count) : "");
  } else {
    cells.resize(cells.size() + 11);
  }
  for (const Judged judged : all_judged) {
    const AchievedError& error = row.error(judged);
    if (judged != Judged::pressure) cells.push_back(csv_number(error.reported));
    cells.push_back(csv_number(error.achieved));
    cells.push_back(error.achieved ? csv_number(error.truth) : "");
  }
  return cells;
}

}  // namespace

std::string work_precision_csv(const WorkPrecisionResult& result) {
  std::string csv =
      "case,solver,tolerance,nodes_asked,status,reason,wall_s,fastest_s,slowest_s,solves,planning_s,"
      "work_units,convolutions,newton_iterations,krylov_iterations,nodes,levels";
  for (const Judged judged : all_judged) {
    const std::string name(to_string(judged));
    if (judged != Judged::pressure) csv += "," + name + "_reported";
    csv += fmt::format(",{}_achieved,{}_truth_error", name, name);
  }
  csv += "\n";
  for (const WorkRow& row : result.rows) csv += csv_line(csv_cells(row));
  return csv;
}

}  // namespace ehd::verification
