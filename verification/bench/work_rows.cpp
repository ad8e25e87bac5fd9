// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/work_rows.hpp"

#include <algorithm>

#include "contact/quantities.hpp"
#include "contact/text.hpp"
#include "verification/bench/timing.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

/// Times within this factor are a tie. Calibrated on one solver under two names, on two cores with a fourfold load: of
/// 201 pairs of medians 168 lay within this factor.
constexpr double tie = 1.25;

}  // namespace

std::vector<ComparedSolvers> compared_solvers() {
  std::vector<ComparedSolvers> pairs;
  for (const RegisteredSolver& solver : solvers())
    if (!solver.is_default && (solver.certified || solver.uses_fft))
      pairs.push_back({solver.name, default_solver().name});
  return pairs;
}

std::string_view to_string(Judged judged) {
  switch (judged) {
    case Judged::film_minimum: return to_string(Quantity::film_minimum);
    case Judged::film_central: return to_string(Quantity::film_central);
    case Judged::pressure: return "pressure";
  }
  return "";
}

std::string AchievedError::words() const {
  if (!achieved) return "-";
  return known() ? plain(*achieved, 2) : "<" + plain(*bound(), 2);
}

Covered covered(const AchievedError& error) {
  if (!error.reported || !error.achieved) return Covered::undecided;
  if (error.within(*error.reported)) return Covered::yes;
  if (error.beyond(*error.reported)) return Covered::no;
  return Covered::undecided;
}

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
    // An achieved error below that of the truth is not known: the error of the truth stands for it.
    excess.push_back(*error.reported / std::max(*error.achieved, error.truth));
  }
  if (!excess.empty()) {
    found.median_excess = median(excess);
    found.worst_excess = *std::min_element(excess.begin(), excess.end());
  }
  return found;
}

}  // namespace ehd::verification
