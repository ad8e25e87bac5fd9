// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/work_precision.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "contact/text.hpp"
#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "io/json.hpp"
#include "io/tables.hpp"
#include "verification/studies/profile.hpp"
#include "workflow/batch.hpp"
#include "workflow/contact_run.hpp"

namespace ehd::verification {

namespace {

constexpr const char* truth_solver = "reference";
// The tightest that `reference` reaches on these cases; its second run is what its pressure is compared with. Films
// that are printed as truths state errors of 1e-12 ... 1e-9.
constexpr double truth_tolerance = 1e-10, second_truth_tolerance = 1e-9;
constexpr double truth_time_limit_s = 300;
/// An achieved error is a number where it is this many times the error of the truth, a bound where not.
constexpr double truth_margin = 10;

/// Whose times are divided at equal error.
constexpr std::pair<const char*, const char*> compared[] = {{"reference", "fast"}, {"fast.uniform", "fast"}};

// Closer times are a tie. Calibrated on the same solver under two names, on two cores that were busy four times over:
// of 201 pairs of medians 168 lay within this.
constexpr double tie = 1.25;

constexpr Quantity quantity_of[] = {Quantity::film_minimum, Quantity::film_central};

std::string joined(const char* solver, const char* over) { return std::string(solver) + "/" + over; }

}  // namespace

std::string_view to_string(Judged judged) {
  switch (judged) {
    case Judged::film_minimum: return "film.minimum";
    case Judged::film_central: return "film.central";
    case Judged::pressure: return "pressure";
  }
  return "";
}

Covered covered(const AchievedError& error) {
  if (!error.reported || !error.achieved) return Covered::undecided;
  if (*error.achieved + error.truth <= *error.reported) return Covered::yes;
  if (*error.achieved - error.truth > *error.reported) return Covered::no;
  return Covered::undecided;
}

std::string Setting::text() const { return tolerance ? plain(*tolerance) : "n = " + std::to_string(nodes.value_or(0)); }

const WorkRow* quickest(const std::vector<WorkRow>& rows, const std::string& case_id, const std::string& solver,
                        Judged judged, double level) {
  const WorkRow* best = nullptr;
  for (const WorkRow& row : rows) {
    if (row.case_id != case_id || row.setting.solver != solver || !row.converged() || row.wall_s.empty()) continue;
    if (!row.error(judged).within(level)) continue;
    if (!best || median(row.wall_s) < median(best->wall_s)) best = &row;
  }
  return best;
}

std::vector<Ratio> ratios(const std::vector<WorkRow>& rows, const std::string& case_id, const std::string& solver,
                          const std::string& over, Judged judged, const std::vector<double>& levels) {
  std::vector<Ratio> found;
  for (const double level : levels) {
    const WorkRow* one = quickest(rows, case_id, solver, judged, level);
    const WorkRow* other = quickest(rows, case_id, over, judged, level);
    if (one && other) found.push_back({level, median(one->wall_s) / median(other->wall_s)});
  }
  return found;
}

std::optional<Crossover> crossover(const std::vector<Ratio>& by_level) {
  const Ratio* before = nullptr;  // the last that is no tie
  for (const Ratio& at : by_level) {
    if (at.value < tie && at.value > 1 / tie) continue;
    if (before && (before->value > 1) != (at.value > 1)) return Crossover{before->level, at.level, at.value > 1};
    before = &at;
  }
  return std::nullopt;
}

Coverage coverage(const std::vector<WorkRow>& rows, const std::string& solver, Judged judged) {
  Coverage found{.solver = solver};
  std::vector<double> excess;
  for (const WorkRow& row : rows) {
    const AchievedError& error = row.error(judged);
    if (row.setting.solver != solver || !error.reported) continue;
    const Covered verdict = covered(error);
    if (verdict == Covered::undecided) {
      ++found.undecided;
      continue;
    }
    ++(verdict == Covered::yes ? found.yes : found.no);
    // Where the truth is hardly better than the run, the achieved error may be as large as their sum.
    excess.push_back(*error.reported / std::max(*error.achieved, error.truth));
  }
  if (!excess.empty()) {
    found.median_excess = median(excess);
    found.worst_excess = *std::min_element(excess.begin(), excess.end());
  }
  return found;
}

// -- the run ----------------------------------------------------------------------------------------------------

std::vector<std::string> work_precision_cases(bool quick) {
  if (quick) return {"own-moes-20-10", "own-barus-5-5"};
  return {"own-moes-5-5",
          "own-moes-20-10",
          "own-moes-100-10",
          "own-moes-200-15",
          "own-moes-1000-10",
          "own-moes-1000-20",
          "own-barus-5-5",
          "own-barus-20-5",
          "own-barus-20-10",
          "own-moes-5-5-flooded",
          "own-moes-20-10-flooded",
          "own-moes-200-15-flooded",
          "own-moes-1000-10-flooded",
          "own-barus-3-4-flooded",
          "own-barus-20-10-flooded"};
}

std::vector<Setting> settings_of(const RegisteredSolver& solver, bool quick) {
  const bool dense = solver.description.work_exponent > 2;
  const bool certified = solver.name == truth_solver;
  // Second-order dense solvers beyond 1e-6 would take minutes and gigabytes.
  std::vector<double> tolerances{1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};
  if (certified) tolerances.insert(tolerances.end(), {1e-7, 1e-8, 1e-9});
  std::vector<int> nodes;
  for (int n = dense ? 128 : 64; n <= (dense ? 1024 : 65536); n *= 2) nodes.push_back(n);
  if (quick) {
    tolerances = {1e-2, 1e-3, 1e-4};
    nodes = dense ? std::vector<int>{128, 256} : std::vector<int>{256, 1024, 4096};
    if (certified) tolerances.push_back(1e-6);
  }
  std::vector<Setting> settings;
  for (const double tolerance : tolerances) settings.push_back({.solver = solver.name, .tolerance = tolerance});
  for (const int n : nodes) settings.push_back({.solver = solver.name, .nodes = n});
  return settings;
}

std::vector<double> error_levels(Judged judged) {
  if (judged == Judged::film_minimum) return {1e-2, 1e-3, 1e-4, 1e-5};
  return {1e-2, 1e-3, 1e-4, 1e-5, 1e-6};
}

bool WorkPrecisionResult::anything_judged() const {
  return std::any_of(rows.begin(), rows.end(), [](const WorkRow& row) {
    return row.converged() && row.error(Judged::film_central).achieved.has_value();
  });
}

namespace {

/// A truth with the solution that it stands for.
struct SolvedTruth {
  Truth stated;
  Solution solution;
  std::optional<Profile> pressure;
  std::string solver;
};

const Reading* film(const Solution& solution, std::size_t which) {
  const auto at = solution.observables.find(quantity_of[which]);
  return at == solution.observables.end() || !std::isfinite(at->second.value) ? nullptr : &at->second;
}

/// Larger of the stated film errors; infinite where the solution is no truth. One that did not get as far as it was
/// asked is one too: its error is as honest.
double stated_error(const Solution& solution) {
  double worst = 0;
  const bool ended =
      solution.record.status == StopReason::converged || solution.record.status == StopReason::tolerance_not_met;
  for (std::size_t which = 0; which < 2; ++which) {
    const Reading* reading = film(solution, which);
    if (!ended || !reading || !reading->error) return std::numeric_limits<double>::infinity();
    worst = std::max(worst, *reading->error);
  }
  return worst;
}

/// Two runs of `reference`; the truth is the one that states the smaller errors. The solver states no error of the
/// pressure as a function: it is taken to be what the two runs differ by, but never better than the films.
SolvedTruth solve_truth(const Case& contact_case, bool quick) {
  const RegisteredSolver& solver = *find_solver(truth_solver);
  double tolerances[] = {truth_tolerance, second_truth_tolerance};
  if (quick) tolerances[0] = 1e-9, tolerances[1] = 1e-8;
  ContactRun runs[2];
  for (int i = 0; i < 2; ++i)
    runs[i] = run_contact(contact_case, solver, {.tolerance = tolerances[i], .time_limit_s = truth_time_limit_s});
  const double errors[2] = {stated_error(runs[0].solution), stated_error(runs[1].solution)};
  const int best = errors[1] < errors[0] ? 1 : 0;

  SolvedTruth truth{.stated = {}, .solution = runs[best].solution, .pressure = {}, .solver = solver.name};
  Truth& stated = truth.stated;
  stated.case_id = contact_case.id;
  stated.title = contact_case.title;
  stated.tolerance = tolerances[best];
  const SolveRecord& record = truth.solution.record;
  stated.reason = record.reason;
  stated.wall_s = record.cost.wall_s;
  if (!std::isfinite(errors[best])) {
    stated.reason = "reference ended " + std::string(to_string(record.status)) + ": " + record.reason;
    return truth;
  }
  stated.status = record.status;
  for (std::size_t which = 0; which < 2; ++which) {
    stated.value[which] = film(truth.solution, which)->value;
    stated.error[which] = *film(truth.solution, which)->error;
    for (const Expectation& expectation : contact_case.expectations) {
      if (expectation.waiting || expectation.kind == ExpectationKind::fit || expectation.value == 0) continue;
      if (expectation.quantity != to_string(quantity_of[which])) continue;
      const auto measured = measure(runs[best], expectation);
      if (!measured) continue;
      stated.from_digits[which] = std::abs(measured->value / expectation.value - 1);
      stated.digits_uncertainty[which] = expectation.uncertainty;
      break;
    }
  }
  if (std::isfinite(errors[1 - best])) {
    truth.pressure.emplace(pressure_profile(truth.solution.fields));
    const double apart = relative_l2_error(pressure_profile(runs[1 - best].solution.fields), *truth.pressure);
    stated.error[static_cast<std::size_t>(Judged::pressure)] = std::max(apart, errors[best]);
  } else {
    stated.reason +=
        (stated.reason.empty() ? "" : "; ") + std::string("no second run tells how well the pressure is known");
  }
  return truth;
}

bool same_mesh(const Fields& one, const Fields& other) {
  return one.X.size() == other.X.size() && (one.X == other.X).all();
}

/// What `solution` achieved.
void judge(const Solution& solution, const SolvedTruth& truth, WorkRow& row) {
  for (std::size_t which = 0; which < 2; ++which) {
    if (const Reading* reading = film(solution, which)) row.errors[which].reported = reading->error;
  }
  if (!truth.stated.status) return;
  // No run is the truth of itself, nor of one that ended with the very same unknowns.
  if (row.setting.solver == truth.solver &&
      (row.setting.tolerance == truth.stated.tolerance || same_mesh(solution.fields, truth.solution.fields))) {
    row.reason = "not judged: this run ends on the mesh of the truth";
    return;
  }
  for (std::size_t which = 0; which < 2; ++which) {
    AchievedError& error = row.errors[which];
    error.truth = truth.stated.error[which];
    if (const Reading* reading = film(solution, which))
      error.achieved = std::abs(reading->value / truth.stated.value[which] - 1);
  }
  AchievedError& pressure = row.error(Judged::pressure);
  if (truth.pressure && solution.fields.X.size() >= 2) {
    pressure.truth = truth.stated.error[static_cast<std::size_t>(Judged::pressure)];
    const double apart = relative_l2_error(pressure_profile(solution.fields), *truth.pressure);
    if (std::isfinite(apart)) pressure.achieved = apart;
  }
}

/// What the next row of the list (a tenth of the tolerance, twice the intervals) should take, over this one.
double growth(const RegisteredSolver& solver, const Setting& setting) {
  const double exponent = solver.description.work_exponent;
  return setting.nodes ? std::pow(2.0, exponent) : std::pow(10.0, exponent / solver.description.formal_order);
}

/// The rows of one case, in rounds: every row once, then again those that want repeating, each round in the other
/// direction.
std::vector<WorkRow> rows_of(const Case& contact_case, const SolvedTruth& truth, const WorkPrecisionRequest& request) {
  std::vector<WorkRow> rows;
  std::vector<const RegisteredSolver*> solver_of;
  for (const RegisteredSolver* solver : request.solvers) {
    for (const Setting& setting : settings_of(*solver, request.quick)) {
      rows.push_back({.case_id = contact_case.id, .setting = setting});
      solver_of.push_back(solver);
    }
  }
  std::map<std::string, std::string> given_up;  // why the rest of a solver's tolerances, or grids, is not run
  std::vector<bool> wanted(rows.size(), true);
  const auto visit = [&](std::size_t i, int round) {
    WorkRow& row = rows[i];
    if (!wanted[i]) return;
    const Request asked{
        .tolerance = row.setting.tolerance,
        .nodes = row.setting.nodes,
        .iteration_share = row.setting.nodes ? std::optional(0.5) : std::nullopt,  // no further than a grid is worth
        .time_limit_s = request.time_limit_s};
    const std::string family = row.setting.solver + (row.setting.nodes ? " on grids" : " within tolerances");
    if (round == 0) {
      std::string why;
      if (given_up.contains(family)) why = "not run: " + given_up.at(family);
      if (asked.nodes && solver_of[i]->memory_bytes(*asked.nodes) > available_memory_bytes())
        why = "not run: it would not fit into memory";
      if (!why.empty()) {
        row.reason = why;
        wanted[i] = false;
        return;
      }
    }
    if (request.progress)
      request.progress(contact_case.id + ": " + row.setting.solver + ", " + row.setting.text() +
                       (round > 0 ? ", again" : ""));
    const ContactRun run = run_contact(contact_case, *solver_of[i], asked);
    row.wall_s.push_back(run.solution.record.cost.wall_s);
    if (round == 0) {
      row.status = run.status();
      row.reason = run.solution.record.reason;
      row.cost = run.solution.record.cost;
      if (run.status() != StopReason::diverged) judge(run.solution, truth, row);
      const double next_s = growth(*solver_of[i], row.setting) * row.wall_s.front();
      if (run.status() == StopReason::limit_reached)
        given_up.emplace(family, row.setting.text() + " already reached the time limit");
      else if (next_s > request.time_limit_s)
        given_up.emplace(family, row.setting.text() + " took " + plain(row.wall_s.front(), 2) +
                                     " s, and the next is to be expected at " + plain(next_s, 2) +
                                     " s by the declared order and work");
    }
    wanted[i] = row.converged() && !request.repetition.satisfied_by(row.wall_s);
  };
  for (int round = 0; std::find(wanted.begin(), wanted.end(), true) != wanted.end(); ++round) {
    for (std::size_t i = 0; i < rows.size(); ++i) visit(round % 2 == 0 ? i : rows.size() - 1 - i, round);
  }
  return rows;
}

}  // namespace

std::vector<Case> contacts_named(const std::vector<std::string>& names) {
  std::vector<Case> cases;
  for (const auto& name : names) {
    cases.push_back(read_case(find_case(name)));
    const Case& one = cases.back();
    const auto* contact = std::get_if<ContactCase>(&one.body);
    if (!contact) throw case_error(one, "bearing", "is no contact; allowed are contact cases");
    if (contact->dry())
      throw case_error(one, "conditions", "is a dry contact, which no solver solves; allowed are lubricated contacts");
  }
  return cases;
}

WorkPrecisionResult run_work_precision(const WorkPrecisionRequest& request) {
  const auto begin = std::chrono::steady_clock::now();
  const std::clock_t cpu_begin = std::clock();
  WorkPrecisionResult result;
  for (const RegisteredSolver* solver : request.solvers) result.solvers.push_back(solver->name);
  for (const Case& one : request.cases) {
    if (request.progress) request.progress(one.id + ": the truth");
    const SolvedTruth truth = solve_truth(one, request.quick);
    const auto rows = rows_of(one, truth, request);
    result.truths.push_back(truth.stated);
    result.rows.insert(result.rows.end(), rows.begin(), rows.end());
  }
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (wall_s > 0) result.cpu_share = static_cast<double>(std::clock() - cpu_begin) / CLOCKS_PER_SEC / wall_s;
  return result;
}

// -- output -----------------------------------------------------------------------------------------------------

namespace {

Json setting_json(const Setting& setting) {
  Json json;
  json["solver"] = setting.solver;
  put(json, "tolerance", setting.tolerance);
  if (setting.nodes) json["nodes"] = *setting.nodes;
  return json;
}

Json truth_json(const Truth& truth) {
  Json json{{"case", truth.case_id}, {"solver", truth_solver}, {"tolerance", truth.tolerance}};
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
  json["status"] = row.status ? std::string(to_string(*row.status)) : "not-run";
  if (!row.reason.empty()) json["reason"] = row.reason;
  if (!row.status) return json;
  const auto [fastest, slowest] = std::minmax_element(row.wall_s.begin(), row.wall_s.end());
  Json cost{
      {"wall_s", median(row.wall_s)}, {"fastest_s", *fastest}, {"slowest_s", *slowest}, {"solves", row.wall_s.size()}};
  put(cost, "planning_s", row.cost.planning_s);
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

/// Text in a comma-separated table.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string number(const std::optional<double>& value) {
  constexpr int digits = 10;
  return value && std::isfinite(*value) ? plain(*value, digits) : "";
}

std::string milliseconds(double seconds) { return plain(1e3 * seconds, 3); }

std::string dash(const std::optional<double>& value, int digits) { return value ? plain(*value, digits) : "-"; }

std::string crossover_text(const Crossover& at, const char* solver, const char* over) {
  const char* tight = at.rises ? over : solver;
  const char* loose = at.rises ? solver : over;
  return std::string(loose) + " is ahead down to " + plain(at.looser) + ", " + tight + " from " + plain(at.tighter);
}

double geometric_mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += std::log(value);
  return std::exp(sum / static_cast<double>(values.size()));
}

}  // namespace

Json to_json(const WorkPrecisionResult& result) {
  Json json;
  json["solvers"] = result.solvers;
  put(json, "cpu_share", result.cpu_share);
  json["truths"] = Json::array();
  for (const Truth& truth : result.truths) json["truths"].push_back(truth_json(truth));
  json["rows"] = Json::array();
  for (const WorkRow& row : result.rows) json["rows"].push_back(row_json(row));

  Json equal = Json::array(), crossings = Json::array(), covering = Json::array();
  for (const Judged judged : all_judged) {
    const auto levels = error_levels(judged);
    for (const Truth& truth : result.truths) {
      for (const double level : levels) {
        Json entry{{"quantity", to_string(judged)}, {"case", truth.case_id}, {"level", level}};
        entry["quickest"] = Json::array();
        for (const auto& solver : result.solvers) {
          const WorkRow* best = quickest(result.rows, truth.case_id, solver, judged, level);
          if (!best) continue;
          Json one = setting_json(best->setting);
          one["wall_s"] = median(best->wall_s);
          entry["quickest"].push_back(one);
        }
        for (const auto& [solver, over] : compared) {
          const auto at = ratios(result.rows, truth.case_id, solver, over, judged, {level});
          if (!at.empty()) entry["ratios"][joined(solver, over)] = at.front().value;
        }
        equal.push_back(entry);
      }
      for (const auto& [solver, over] : compared) {
        if (const auto at = crossover(ratios(result.rows, truth.case_id, solver, over, judged, levels)))
          crossings.push_back({{"quantity", to_string(judged)},
                               {"case", truth.case_id},
                               {"ratio", joined(solver, over)},
                               {"looser", at->looser},
                               {"tighter", at->tighter},
                               {"ahead_when_tighter", at->rises ? over : solver}});
      }
    }
    if (judged == Judged::pressure) continue;  // no solver reports its error
    for (const auto& solver : result.solvers) {
      const Coverage found = coverage(result.rows, solver, judged);
      Json entry{{"quantity", to_string(judged)},
                 {"solver", solver},
                 {"covered", found.yes},
                 {"missed", found.no},
                 {"undecided", found.undecided}};
      put(entry, "median_excess", found.median_excess);
      put(entry, "smallest_excess", found.worst_excess);
      covering.push_back(entry);
    }
  }
  json["at_equal_error"] = equal;
  json["crossovers"] = crossings;
  json["coverage"] = covering;
  return json;
}

std::string work_precision_csv(const WorkPrecisionResult& result) {
  std::string csv =
      "case,solver,tolerance,nodes_asked,status,reason,wall_s,fastest_s,slowest_s,solves,planning_s,"
      "work_units,convolutions,newton_iterations,krylov_iterations,nodes,levels";
  for (const Judged judged : all_judged) {
    const std::string name(to_string(judged));
    if (judged != Judged::pressure) csv += "," + name + "_reported";
    csv += "," + name + "_achieved," + name + "_truth_error";
  }
  csv += "\n";
  for (const WorkRow& row : result.rows) {
    std::vector<std::string> cells{row.case_id,
                                   row.setting.solver,
                                   number(row.setting.tolerance),
                                   row.setting.nodes ? std::to_string(*row.setting.nodes) : "",
                                   row.status ? std::string(to_string(*row.status)) : "not-run",
                                   quoted(row.reason)};
    if (row.status) {
      const auto [fastest, slowest] = std::minmax_element(row.wall_s.begin(), row.wall_s.end());
      const bool grid = row.cost.nodes > 0;
      for (const double s : {median(row.wall_s), *fastest, *slowest}) cells.push_back(number(s));
      cells.push_back(std::to_string(row.wall_s.size()));
      cells.push_back(number(row.cost.planning_s));
      cells.push_back(grid ? number(row.cost.work_units) : "");
      for (const long count : {row.cost.convolutions, row.cost.newton_iterations, row.cost.krylov_iterations})
        cells.push_back(std::to_string(count));
      for (const int count : {row.cost.nodes, row.cost.levels}) cells.push_back(grid ? std::to_string(count) : "");
    } else {
      cells.resize(cells.size() + 11);
    }
    for (const Judged judged : all_judged) {
      const AchievedError& error = row.error(judged);
      if (judged != Judged::pressure) cells.push_back(number(error.reported));
      cells.push_back(number(error.achieved));
      cells.push_back(error.achieved ? number(error.truth) : "");
    }
    for (std::size_t c = 0; c < cells.size(); ++c) csv += (c > 0 ? "," : "") + cells[c];
    csv += "\n";
  }
  return csv;
}

namespace {

std::string truths_table(const WorkPrecisionResult& result) {
  std::vector<std::vector<std::string>> table{{"case", "status", "asked", "H_min", "H_cen", "pressure L2 to",
                                               "H_min from digits", "H_cen from digits", "time [s]"}};
  for (const Truth& truth : result.truths) {
    if (!truth.status) {
      table.push_back(
          {truth.case_id, "no truth", plain(truth.tolerance), "-", "-", "-", "-", "-", plain(truth.wall_s, 3)});
      continue;
    }
    const double pressure = truth.error[static_cast<std::size_t>(Judged::pressure)];
    table.push_back({truth.case_id, std::string(to_string(*truth.status)), plain(truth.tolerance),
                     with_error(truth.value[0], truth.error[0]), with_error(truth.value[1], truth.error[1]),
                     pressure > 0 ? plain(pressure, 2) : "-", dash(truth.from_digits[0], 2),
                     dash(truth.from_digits[1], 2), plain(truth.wall_s, 3)});
  }
  return "The truths: " + std::string(truth_solver) + ", with the errors that it states\n" + aligned(table, 2, "  ");
}

std::string rows_table(const WorkPrecisionResult& result) {
  std::vector<std::vector<std::string>> table{{"case", "solver", "asked", "status", "time [ms]", "solves", "work units",
                                               "intervals", "H_min reported", "achieved", "H_cen reported", "achieved",
                                               "P achieved"}};
  for (const WorkRow& row : result.rows) {
    std::vector<std::string> cells{row.case_id, row.setting.solver, row.setting.text(),
                                   row.status ? std::string(to_string(*row.status)) : "not run"};
    cells.push_back(row.wall_s.empty() ? "-" : milliseconds(median(row.wall_s)));
    cells.push_back(std::to_string(row.wall_s.size()));
    cells.push_back(row.cost.nodes > 0 ? plain(row.cost.work_units, 3) : "-");
    cells.push_back(row.cost.nodes > 0 ? std::to_string(row.cost.nodes) : "-");
    for (const Judged judged : all_judged) {
      const AchievedError& error = row.error(judged);
      if (judged != Judged::pressure) cells.push_back(dash(error.reported, 2));
      // Below ten times the truth's error only a bound is known.
      cells.push_back(!error.achieved                                ? "-"
                      : *error.achieved < truth_margin * error.truth ? "<" + plain(*error.achieved + error.truth, 2)
                                                                     : plain(*error.achieved, 2));
    }
    table.push_back(cells);
  }
  constexpr double undisturbed = 0.9, percent = 100;
  return "Every run: time is the median of cold solves; this process had " + plain(percent * result.cpu_share, 3) +
         " % of a core" + (result.cpu_share < undisturbed ? ", so that times are too long: measure again" : "") + "\n" +
         aligned(table, 4, "  ");
}

std::string equal_error_table(const WorkPrecisionResult& result, Judged judged) {
  const auto levels = error_levels(judged);
  std::vector<std::string> header{"case", "error"};
  header.insert(header.end(), result.solvers.begin(), result.solvers.end());
  for (const auto& [solver, over] : compared) header.push_back(joined(solver, over));
  std::vector<std::vector<std::string>> table{header};
  std::string crossings;
  std::map<std::string, std::map<double, std::vector<double>, std::greater<>>> by_level;
  for (const Truth& truth : result.truths) {
    for (const double level : levels) {
      std::vector<std::string> cells{truth.case_id, plain(level)};
      for (const auto& solver : result.solvers) {
        const WorkRow* best = quickest(result.rows, truth.case_id, solver, judged, level);
        cells.push_back(best ? milliseconds(median(best->wall_s)) + " (" + best->setting.text() + ")" : "-");
      }
      for (const auto& [solver, over] : compared) {
        const auto at = ratios(result.rows, truth.case_id, solver, over, judged, {level});
        cells.push_back(at.empty() ? "-" : plain(at.front().value, 3));
        if (!at.empty()) by_level[joined(solver, over)][level].push_back(at.front().value);
      }
      table.push_back(cells);
    }
    for (const auto& [solver, over] : compared) {
      if (const auto at = crossover(ratios(result.rows, truth.case_id, solver, over, judged, levels)))
        crossings += "  " + truth.case_id + ": " + crossover_text(*at, solver, over) + "\n";
    }
  }
  std::string text = "Best time [ms] at an achieved error in " + std::string(to_string(judged)) +
                     " of at most (and what was asked for)\n" + aligned(table, 1, "  ");
  std::vector<std::vector<std::string>> means{{"ratio", "error", "cases", "geometric mean", "smallest", "largest"}};
  for (const auto& [name, levels_of] : by_level) {
    for (const auto& [level, values] : levels_of) {
      const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
      means.push_back({name, plain(level), std::to_string(values.size()), plain(geometric_mean(values), 3),
                       plain(*smallest, 3), plain(*largest, 3)});
    }
  }
  if (means.size() > 1) text += "\n" + aligned(means, 1, "  ");
  return text + (crossings.empty() ? "" : "\n  crossovers\n" + crossings);
}

std::string coverage_table(const WorkPrecisionResult& result) {
  std::vector<std::vector<std::string>> table{
      {"solver", "quantity", "covered", "missed", "undecided", "reported/achieved, median", "smallest"}};
  for (const auto& solver : result.solvers) {
    for (const Judged judged : {Judged::film_minimum, Judged::film_central}) {
      const Coverage found = coverage(result.rows, solver, judged);
      table.push_back({solver, std::string(to_string(judged)), std::to_string(found.yes), std::to_string(found.no),
                       std::to_string(found.undecided), dash(found.median_excess, 3), dash(found.worst_excess, 3)});
    }
  }
  return "Errors reported against achieved, of every run that reports one\n" + aligned(table, 2, "  ");
}

/// Neighbouring rows of one solver with the same end are one line.
std::string failures_list(const WorkPrecisionResult& result) {
  std::vector<std::pair<std::string, std::string>> lines;  // what, and how it ended
  std::string last;
  for (const WorkRow& row : result.rows) {
    if (row.converged() && row.reason.empty()) continue;
    const std::string who = row.case_id + ", " + row.setting.solver;
    std::string how = row.status ? std::string(to_string(*row.status)) : "";
    if (!row.reason.empty()) how += (how.empty() ? "" : "; ") + row.reason;
    if (lines.empty() || last != who + how) lines.emplace_back(who, how);
    lines.back().first += ", " + row.setting.text();
    last = who + how;
  }
  for (const Truth& truth : result.truths) {
    if (!truth.reason.empty()) lines.emplace_back(truth.case_id + ", the truth", truth.reason);
  }
  if (lines.empty()) return "";
  std::string text = "What did not converge, was not run or not judged, and why\n";
  for (const auto& [what, how] : lines) text += "  " + what + ": " + how + "\n";
  return text + "\n";
}

std::string missed_list(const WorkPrecisionResult& result) {
  std::vector<std::vector<std::string>> table;
  for (const WorkRow& row : result.rows) {
    for (const Judged judged : all_judged) {
      const AchievedError& error = row.error(judged);
      if (covered(error) != Covered::no) continue;
      table.push_back({row.case_id, row.setting.solver, row.setting.text(), std::string(to_string(judged)),
                       "reported " + plain(*error.reported, 3), "achieved " + plain(*error.achieved, 3)});
    }
  }
  constexpr std::size_t columns = 6;
  return table.empty() ? "" : "\n  missed\n" + aligned(table, columns, "  ");
}

}  // namespace

std::string human_table(const WorkPrecisionResult& result) {
  std::string text = truths_table(result) + "\n" + rows_table(result) + "\n" + failures_list(result);
  for (const Judged judged : {Judged::film_central, Judged::film_minimum, Judged::pressure})
    text += equal_error_table(result, judged) + "\n";
  return text + coverage_table(result) + missed_list(result) + "\n";
}

}  // namespace ehd::verification
