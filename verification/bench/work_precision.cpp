// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <utility>

#include "contact/profile.hpp"
#include "contact/text.hpp"
#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "verification/bench/cost_scaling.hpp"
#include "workflow/contact_run.hpp"

namespace ehd::verification {

namespace {

/// The tightest tolerance that the certified solver reaches on these cases, and that of its second run, with which its
/// pressure is compared. The films printed as truths state errors of 1e-12 ... 1e-9.
constexpr double truth_tolerance = 1e-10, second_truth_tolerance = 1e-9;
constexpr double quick_truth_tolerance = 1e-9, quick_second_truth_tolerance = 1e-8;
constexpr double truth_time_limit_s = 300;

}  // namespace

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
  // Second-order dense solvers beyond 1e-6 would take minutes and gigabytes.
  std::vector<double> tolerances{1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};
  if (solver.certified) tolerances.insert(tolerances.end(), {1e-7, 1e-8, 1e-9});
  std::vector<int> nodes;
  for (int n = solver.dense() ? 128 : 64; n <= (solver.dense() ? 1024 : 65536); n *= 2) nodes.push_back(n);
  if (quick) {
    tolerances = {1e-2, 1e-3, 1e-4};
    nodes = solver.dense() ? std::vector<int>{128, 256} : std::vector<int>{256, 1024, 4096};
    if (solver.certified) tolerances.push_back(1e-6);
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

/// A truth with its solution.
struct SolvedTruth {
  Truth stated;
  Solution solution = {};
  std::optional<Profile> pressure = {};
};

/// The difference of the truth from the first value that the case itself expects of a film, where there is one.
void compare_with_digits(const Case& contact_case, const ContactRun& run, std::size_t which, Truth& stated) {
  for (const Expectation& expectation : contact_case.expectations) {
    if (expectation.waiting || expectation.kind == ExpectationKind::fit || expectation.value == 0) continue;
    if (expectation.quantity != to_string(judged_films[which])) continue;
    const auto measured = measure(run, expectation);
    if (!measured) continue;
    stated.from_digits[which] = std::abs(measured->value / expectation.value - 1);
    stated.digits_uncertainty[which] = expectation.uncertainty;
    return;
  }
}

/// Two runs of the certified solver; the truth is the run that states the smaller errors. The solver states no error of
/// the pressure as a function. This error is taken as the difference of the two runs, or the film error if larger.
SolvedTruth solve_truth(const Case& contact_case, bool quick) {
  const RegisteredSolver& solver = certified_solver();
  double tolerances[] = {truth_tolerance, second_truth_tolerance};
  if (quick) tolerances[0] = quick_truth_tolerance, tolerances[1] = quick_second_truth_tolerance;
  ContactRun runs[2];
  for (int i = 0; i < 2; ++i)
    runs[i] = run_contact(contact_case, solver, {.tolerance = tolerances[i], .time_limit_s = truth_time_limit_s});
  const double errors[2] = {stated_error(runs[0].solution), stated_error(runs[1].solution)};
  const int best = errors[1] < errors[0] ? 1 : 0;

  SolvedTruth truth{.stated = {.case_id = contact_case.id, .solver = solver.name, .tolerance = tolerances[best]},
                    .solution = runs[best].solution};
  Truth& stated = truth.stated;
  const SolveRecord& record = truth.solution.record;
  stated.reason = record.reason;
  stated.wall_s = record.cost.wall_s;
  if (!std::isfinite(errors[best])) {
    stated.reason = fmt::format("{} ended {}: {}", solver.name, to_string(record.status), record.reason);
    return truth;
  }
  stated.status = record.status;
  for (std::size_t which = 0; which < 2; ++which) {
    stated.value[which] = reading_of(truth.solution, judged_films[which])->value;
    stated.error[which] = *reading_of(truth.solution, judged_films[which])->error;
    compare_with_digits(contact_case, runs[best], which, stated);
  }
  if (std::isfinite(errors[1 - best])) {
    truth.pressure.emplace(pressure_profile(truth.solution.fields));
    const double apart = relative_l2_error(pressure_profile(runs[1 - best].solution.fields), *truth.pressure);
    stated.error[static_cast<std::size_t>(Judged::pressure)] = std::max(apart, errors[best]);
  } else {
    stated.reason += stated.reason.empty() ? "" : "; ";
    stated.reason += "no second run tells how well the pressure is known";
  }
  return truth;
}

bool same_mesh(const Fields& one, const Fields& other) {
  return one.X.size() == other.X.size() && (one.X == other.X).all();
}

/// Fills the errors of a row: reported and achieved.
void judge(const Solution& solution, const SolvedTruth& truth, WorkRow& row) {
  for (std::size_t which = 0; which < 2; ++which) {
    if (const Reading* reading = reading_of(solution, judged_films[which])) row.errors[which].reported = reading->error;
  }
  if (!truth.stated.status) return;
  // A run that is the truth, or that ended with the same unknowns, cannot be judged by it.
  if (row.setting.solver == truth.stated.solver &&
      (row.setting.tolerance == truth.stated.tolerance || same_mesh(solution.fields, truth.solution.fields))) {
    row.reason = "not judged: this run ends on the mesh of the truth";
    return;
  }
  for (std::size_t which = 0; which < 2; ++which) {
    AchievedError& error = row.errors[which];
    error.truth = truth.stated.error[which];
    if (const Reading* reading = reading_of(solution, judged_films[which]))
      error.achieved = std::abs(reading->value / truth.stated.value[which] - 1);
  }
  AchievedError& pressure = row.error(Judged::pressure);
  if (truth.pressure && solution.fields.X.size() >= 2) {
    pressure.truth = truth.stated.error[static_cast<std::size_t>(Judged::pressure)];
    const double apart = relative_l2_error(pressure_profile(solution.fields), *truth.pressure);
    if (std::isfinite(apart)) pressure.achieved = apart;
  }
}

/// Expected time of the next setting of a series (a tenth of the tolerance, twice the intervals) over this one's.
double growth(const RegisteredSolver& solver, const Setting& setting) {
  const double exponent = solver.description.work_exponent;
  return setting.nodes ? std::pow(2.0, exponent) : std::pow(10.0, exponent / solver.description.formal_order);
}

/// The rows of one case, in rounds: first every row, then those whose time needs repetition.
class Rounds {
 public:
  Rounds(const Case& contact_case, const SolvedTruth& truth, const WorkPrecisionRequest& request)
      : case_(contact_case), truth_(truth), request_(request) {
    for (const RegisteredSolver* solver : request.solvers) {
      for (const Setting& setting : settings_of(*solver, request.quick)) {
        rows_.push_back({.case_id = contact_case.id, .setting = setting});
        solver_of_.push_back(solver);
      }
    }
    wanted_.assign(rows_.size(), true);
  }

  /// Each round goes in the other direction, so that a machine that slows down does so for all rows.
  std::vector<WorkRow> run() {
    for (int round = 0; std::find(wanted_.begin(), wanted_.end(), true) != wanted_.end(); ++round) {
      for (std::size_t i = 0; i < rows_.size(); ++i) visit(round % 2 == 0 ? i : rows_.size() - 1 - i, round);
    }
    return std::move(rows_);
  }

 private:
  void visit(std::size_t i, int round) {
    if (!wanted_[i]) return;
    WorkRow& row = rows_[i];
    const bool first = round == 0;
    if (first) row.reason = why_not_run(i);
    if (first && !row.reason.empty()) {
      wanted_[i] = false;
      return;
    }
    if (request_.progress)
      request_.progress(
          fmt::format("{}: {}, {}{}", case_.id, row.setting.solver, row.setting.text(), first ? "" : ", again"));
    const ContactRun run = run_contact(case_, *solver_of_[i], row.setting.request(request_.time_limit_s));
    row.wall_s.push_back(run.solution.record.cost.wall_s);
    if (first) keep(run, i);
    wanted_[i] = row.converged() && !request_.repetition.satisfied_by(row.wall_s);
  }

  /// The tolerances of a solver are a series, and so are its grids. Once a run of a series takes too long, the rest is
  /// not run.
  [[nodiscard]] static std::string series(const Setting& setting) {
    return setting.solver + (setting.nodes ? " on grids" : " within tolerances");
  }

  [[nodiscard]] std::string why_not_run(std::size_t i) const {
    const Setting& setting = rows_[i].setting;
    if (setting.nodes && solver_of_[i]->memory_bytes(*setting.nodes) > available_memory_bytes())
      return "not run: it would not fit into memory";
    const auto at = given_up_.find(series(setting));
    return at == given_up_.end() ? "" : "not run: " + at->second;
  }

  void keep(const ContactRun& run, std::size_t i) {
    WorkRow& row = rows_[i];
    row.status = run.status();
    row.reason = run.solution.record.reason;
    row.cost = run.solution.record.cost;
    if (run.status() != StopReason::diverged) judge(run.solution, truth_, row);
    const double took_s = row.wall_s.front(), next_s = growth(*solver_of_[i], row.setting) * took_s;
    if (run.status() == StopReason::limit_reached)
      given_up_.emplace(series(row.setting), row.setting.text() + " already reached the time limit");
    else if (next_s > request_.time_limit_s)
      given_up_.emplace(
          series(row.setting),
          fmt::format("{} took {} s, and the next is to be expected at {} s by the declared order and work",
                      row.setting.text(), plain(took_s, 2), plain(next_s, 2)));
  }

  const Case& case_;
  const SolvedTruth& truth_;
  const WorkPrecisionRequest& request_;
  std::vector<WorkRow> rows_;
  std::vector<const RegisteredSolver*> solver_of_;
  std::vector<bool> wanted_;
  std::map<std::string, std::string> given_up_;  // by series: why the rest is not run
};

}  // namespace

void require_lubricated(const Case& one) {
  const auto* contact = std::get_if<ContactCase>(&one.body);
  if (!contact) throw case_error(one, "bearing", "is no contact; allowed are contact cases");
  if (contact->dry())
    throw case_error(one, "conditions", "is a dry contact, which no solver solves; allowed are lubricated contacts");
}

std::vector<Case> contacts_named(const std::vector<std::string>& names) {
  std::vector<Case> cases;
  for (const auto& name : names) {
    cases.push_back(read_case(find_case(name)));
    require_lubricated(cases.back());
  }
  return cases;
}

WorkPrecisionResult run_work_precision(const WorkPrecisionRequest& request) {
  const Stopwatch watch;
  const std::clock_t cpu_begin = std::clock();
  WorkPrecisionResult result;
  for (const RegisteredSolver* solver : request.solvers) result.solvers.push_back(solver->name);
  std::vector<double> c_s;
  for (const Case& one : request.cases) {
    c_s.push_back(c_now());
    if (request.progress) request.progress(one.id + ": the truth");
    const SolvedTruth truth = solve_truth(one, request.quick);
    const auto rows = Rounds(one, truth, request).run();
    result.truths.push_back(truth.stated);
    result.rows.insert(result.rows.end(), rows.begin(), rows.end());
  }
  if (!c_s.empty()) result.c_s = median(c_s);
  const double wall_s = watch.seconds();
  if (wall_s > 0) result.cpu_share = static_cast<double>(std::clock() - cpu_begin) / CLOCKS_PER_SEC / wall_s;
  return result;
}

}  // namespace ehd::verification
