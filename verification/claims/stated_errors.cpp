// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 8: the errors that the solvers state of films, of pressure peaks and of P(X), against the certified solver at
// 1e-7. Every solver runs with several tolerances and on several given grids: at contacts where a stated error was once
// too small, in which every one has to hold, and at random contacts, among them inlets cut just before the contact, in
// which 98 of 100 have to. Below 1e-6 the two best solvers judge each other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "contact/profile.hpp"
#include "contact/stated_error.hpp"
#include "contact/text.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/studies/box.hpp"
#include "verification/studies/draw.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

struct StatedRun {
  const char* solver;
  std::optional<double> tolerance;
  std::optional<int> nodes = {};

  [[nodiscard]] std::string how() const {
    return nodes ? fmt::format("{} intervals", *nodes) : fmt::format("tolerance {}", plain(*tolerance));
  }
};
const StatedRun stated_runs[] = {{"fast", 1e-2},
                                 {"fast", 1e-3},
                                 {"fast", 5e-4},
                                 {"fast", 1e-4},
                                 {"fast", 1e-5},
                                 {"fast", {}, 128},
                                 {"fast", {}, 512},
                                 {"fast", {}, 2048},
                                 {"fast.uniform", {}, 256},
                                 {"fast.uniform", {}, 1024},
                                 {"reference.uniform", {}, 128},
                                 {"reference.uniform", {}, 256},
                                 {"reference.linear", 1e-3},
                                 {"reference.linear", {}, 100},
                                 {"reference.linear", {}, 256},
                                 {"reference", 1e-3},
                                 {"reference", {}, 64},
                                 {"reference", {}, 128}};
constexpr double stated_truth_tolerance = 1e-7;
constexpr Quantity judged_quantities[] = {Quantity::film_minimum, Quantity::film_central, Quantity::pressure_maximum,
                                          Quantity::pressure_spike};
/// Moderate to heavy loads with thin and sharp spikes: here a smooth sequence of grids agreed on a wrong H_min. Then
/// cut contacts, where the dome counted as the maximum beside a spike that is higher, and the heights of spikes
/// narrower than the cells agreed by chance. Then a light one with a kink of the film at X = 0, which H_cen did not
/// see. Last, H_cen of two grids that agreed by chance.
const BoxContact once_too_small[] = {{{281.2, 30}, true},
                                     {{1494.27, 17.747}, true},
                                     {{346.248, 27.4164}, true},
                                     {{100, 10}, false},
                                     {{951.2, 28.6305}, true},
                                     {{14.03, 13.42}, true, TruncatedAt{-2.14}},
                                     {{12.72, 9.581}, true, TruncatedAt{-3.82}},
                                     {{23.15, 15.05}, true, TruncatedAt{-3.8}},
                                     {{29.28, 15.81}, true, TruncatedAt{-1.56}},
                                     {{1.986, 16.7}, false},
                                     {{0.8625, 24.82}, false}};
/// Two solvers judge each other at tight tolerances: the first at `tolerances`, the second at its best.
struct TightRuns {
  const char *judged, *judge;
  std::vector<double> tolerances;
  double judge_tolerance;
  std::vector<BoxContact> contacts;
};
const TightRuns tight_runs[] = {
    // The smooth remainder of the kernel from a table of too few cells: up to 60 stated errors.
    {"fast",
     "reference",
     {1e-7, 1e-8, 1e-9},
     1e-10,
     {{{10, 0}, false, TruncatedAt{-4}},
      {{117.938, 0}, false, TruncatedAt{-3.55}},
      {{300, 2}, false, TruncatedAt{-3.5}},
      {{3000, 0}, false, TruncatedAt{-4}},
      {{3000, 2}, false}}},
    // Descents that end at a floor of the fluidity, whose bend counts: up to 3 stated errors.
    {"reference", "fast", {1e-6, 1e-7}, 1e-9, {{{500, 8}, false, TruncatedAt{-3}}}},
    {"reference", "fast", {1e-6, 1e-7}, 2e-8, {{{53.45, 13.89}, false}}}};
constexpr int quick_contacts = 2;  ///< the first ones; each takes some 10 s
constexpr unsigned stated_seed = 20261130;
constexpr int random_contacts_a_law = 10;
constexpr unsigned near_cut_seed = 20261205;
constexpr int near_cut_contacts = 6;

/// How well the stated errors of one solver hold.
struct StatedCount {
  int films = 0;  ///< that the solver reported
  int judged = 0, held = 0, undecided = 0;
  double worst = 0, worst_truth = 0;  ///< error over stated error where that is largest; the truth's own, likewise
  std::string worst_at = {};
  std::vector<double> inflation = {};  ///< stated over true

  /// A stated error is wrong where the film misses the truth by more than it and the truth's own error. It holds where
  /// both are within it, or where the truth is ten times better. Else it is undecided.
  void add(double error, double stated, double truth_error, const std::string& where) {
    const bool wrong = !(error - truth_error <= stated);
    if (!wrong && !(error + truth_error <= stated) && !(error <= stated && truth_error <= stated / 10)) {
      ++undecided;
      return;
    }
    ++judged;
    held += wrong ? 0 : 1;
    inflation.push_back(stated / std::max(error, 1e-300));
    if (const double ratio = error / stated; !std::isnan(worst) && !(ratio <= worst)) {  // a NaN stays the worst
      worst = ratio;
      worst_truth = truth_error / stated;
      worst_at = where;
    }
  }
  [[nodiscard]] std::string text() const {
    std::vector<double> sorted = inflation;
    std::sort(sorted.begin(), sorted.end());
    return fmt::format(
        "{} of {} stated errors hold, {} more where the truth cannot tell; stated over true {} in the median; largest "
        "error {} of the stated one, {}",
        held, judged, undecided, sorted.empty() ? "unknown" : plain(sorted[sorted.size() / 2], 2), plain(worst, 3),
        worst_at);
  }
};
struct SolverCount {
  StatedCount readings;  ///< films and pressure peaks
  StatedCount pressure;  ///< P(X) in L2
};
using StatedCounts = std::map<std::string, SolverCount>;  ///< by solver

void count_run(const BoxContact& contact, const StatedRun& run, const Solution& truth, SolverCount& count) {
  const Solution solution =
      find_solver(run.solver)
          ->solve(contact.problem(), {.tolerance = run.tolerance, .nodes = run.nodes, .time_limit_s = 60});
  const std::string where = fmt::format("{}, {}, {}", contact.name(), contact.flooded() ? "flooded" : "cut", run.how());
  for (const Quantity quantity : judged_quantities) {
    const Reading *seen = observed(solution, quantity), *exact = reading(truth, quantity);
    if (seen && is_film(quantity)) ++count.readings.films;
    if (!seen || !seen->error || !exact || !exact->error) continue;
    // Relative to the number that the solver gives, as its brackets are.
    count.readings.add(std::abs(exact->value / seen->value - 1), *seen->error, error_of(exact),
                       fmt::format("{}, {}", where, to_string(quantity)));
  }
  const auto stated = pressure_error(solution), of_truth = pressure_error(truth);
  if (stated && of_truth)
    count.pressure.add(relative_l2_error(pressure_profile(solution.fields), pressure_profile(truth.fields)), *stated,
                       *of_truth, where);
}

void count_stated_errors(const BoxContact& contact, StatedCounts& counts) {
  const Solution truth = certified_solver().solve(contact.problem(), {.tolerance = stated_truth_tolerance});
  for (const StatedRun& run : stated_runs) count_run(contact, run, truth, counts[run.solver]);
}

Findings judge_tight_errors(const TightRuns& runs, const BoxContact& contact) {
  const Solution truth = find_solver(runs.judge)->solve(contact.problem(), {.tolerance = runs.judge_tolerance});
  SolverCount counts;
  for (const double tolerance : runs.tolerances) count_run(contact, {runs.judged, tolerance}, truth, counts);
  const StatedCount& count = counts.readings;
  return {
      .claims = {claim(
          {.id = fmt::format("stated-errors/tight/{}-{}/{}", plain(contact.moes.M), plain(contact.moes.L), runs.judged),
           .rung = 8,
           .statement =
               fmt::format("every error of a film or a pressure peak that {} states at {}, {}, holds at tolerances "
                           "of {} and less, against {}",
                           runs.judged, contact.name(), contact.flooded() ? "flooded" : "cut",
                           plain(runs.tolerances.front()), runs.judge),
           .solver = runs.judged},
          count.judged > 0 ? count.worst : nothing, count.worst_truth,
          Tolerance::required(1, "error over stated error"), count.text())},
      .skipped = {}};
}

Findings judge_contact_once_too_small(const BoxContact& contact) {
  StatedCounts counts;
  count_stated_errors(contact, counts);
  Findings found;
  for (const RegisteredSolver& solver : solvers()) {
    const StatedCount& count = counts[solver.name].readings;
    const Sentence says{
        .id = fmt::format("stated-errors/{}-{}/{}", plain(contact.moes.M), plain(contact.moes.L), solver.name),
        .rung = 8,
        .statement = fmt::format(
            "every error of a film or a pressure peak that {} states at {}, {}, holds, for several tolerances "
            "and grids",
            solver.name, contact.name(), contact.flooded() ? "flooded" : "cut"),
        .solver = solver.name};
    if (count.films == 0)
      found.skipped.push_back({says, "no film is reported: its grids are too coarse for this contact"});
    else
      found.claims.push_back(claim(says, count.judged > 0 ? count.worst : nothing, count.worst_truth,
                                   Tolerance::required(1, "error over stated error"), count.text()));
  }
  return found;
}

/// The share of stated errors that hold, of each solver. `ids`: "stated-errors/random/barus"; `hold`: "10 random
/// contacts hold, Barus".
Findings judge_share(StatedCounts counts, const std::string& ids, const std::string& hold) {
  Findings found;
  const auto judge = [&](const RegisteredSolver& solver, const char* folder, const char* errors,
                         const StatedCount& count) {
    found.claims.push_back(
        claim({.id = fmt::format("{}/{}{}", ids, folder, solver.name),
               .rung = 8,
               .statement = fmt::format("the errors of {} that {} states at {}", errors, solver.name, hold),
               .solver = solver.name},
              count.judged > 0 ? 1 - count.held / static_cast<double>(count.judged) : nothing, 0,
              Tolerance::required(0.02, "at least 98 in 100"), count.text()));
  };
  for (const RegisteredSolver& solver : solvers()) {
    const SolverCount& count = counts[solver.name];
    judge(solver, "", "films and pressure peaks", count.readings);
    judge(solver, "pressure-field/", "P(X), in L2,", count.pressure);
  }
  return found;
}

/// M 0.05 ... 5000, L 0 ... 30; half of the contacts cut at -2.5 ... -10.
Findings judge_random_stated_errors(bool roelands) {
  StatedCounts counts;
  Draw draw(stated_seed);
  for (int i = 0; i < random_contacts_a_law; ++i) {
    BoxContact contact{.moes = draw.point(), .roelands = roelands};
    const double cut = draw.uniform(-10, -2.5), choice = draw.uniform(0, 1);
    if (choice < 0.5) contact.inlet = TruncatedAt{cut};
    count_stated_errors(contact, counts);
  }
  return judge_share(counts, roelands ? "stated-errors/random/roelands" : "stated-errors/random/barus",
                     fmt::format("{} random contacts hold, {}", random_contacts_a_law, law_name(roelands)));
}

/// Cuts nearer than those: X = -1 - d, d from 1.5 down to 0.01 on a logarithmic scale. M 0.3 ... 50, where a cut takes
/// most of the inlet zone; heavier contacts take 5 s each and more.
Findings judge_near_cuts() {
  StatedCounts counts;
  Draw draw(near_cut_seed);
  for (int i = 0; i < near_cut_contacts; ++i) {
    const double M = draw.logarithmic(0.3, 50), L = draw.uniform(0, 30);
    BoxContact contact{.moes = {M, L}, .roelands = i % 2 == 0};
    contact.inlet = TruncatedAt{-1 - draw.logarithmic(0.01, 1.5)};
    count_stated_errors(contact, counts);
  }
  return judge_share(counts, "stated-errors/near-cuts",
                     fmt::format("{} random contacts cut at X = -2.5 to -1.01 hold", near_cut_contacts));
}

}  // namespace

std::vector<Topic> stated_error_topics() {
  std::vector<Topic> topics;
  for (const BoxContact& contact : once_too_small)
    topics.push_back({.name = "stated errors",
                      .rungs = {8},
                      .slow = &contact - once_too_small >= quick_contacts,
                      .judge = [&contact] { return judge_contact_once_too_small(contact); },
                      .expected_s = 8});
  for (const TightRuns& runs : tight_runs)
    for (const BoxContact& contact : runs.contacts)
      topics.push_back({.name = fmt::format("stated errors, tight, {}", runs.judged),
                        .rungs = {8},
                        .slow = runs.judge == std::string("fast"),
                        .judge = [&runs, &contact] { return judge_tight_errors(runs, contact); },
                        .expected_s = 1});
  for (const bool roelands : {false, true})
    topics.push_back({.name = "stated errors, random, " + law_name(roelands),
                      .rungs = {8},
                      .slow = true,
                      .judge = [roelands] { return judge_random_stated_errors(roelands); },
                      .expected_s = 80});
  topics.push_back(
      {.name = "stated errors, near cuts", .rungs = {8}, .slow = true, .judge = judge_near_cuts, .expected_s = 6});
  return topics;
}

}  // namespace ehd::verification
