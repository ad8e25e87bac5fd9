// SPDX-License-Identifier: GPL-3.0-or-later
// Rungs 6 and 8: both main solvers at random points of the box M 0.05..5000, L 0..30, both law sets. Rung 6: the solver
// converges, or says why it does not. Rung 8: its error bars hold. Runs of the reference are compared with its own
// solution at a tolerance a thousand times tighter, which has other meshes; runs of fast with the reference.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "contact/text.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/studies/box.hpp"
#include "verification/studies/draw.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

constexpr unsigned bar_seed = 20261121, box_seed = 20261122, fast_seed = 20261123;
/// fast takes milliseconds, so that it solves five points of each law set for each random run. Every tenth of them is
/// compared with the reference.
constexpr int fast_points_a_run = 5, points_a_truth = 10;
/// At most so many draws for each run that is judged. Some runs are so far within their tolerance that no solution is
/// tight enough to judge them.
constexpr int most_draws = 3;
/// The truth can judge a bar where its own bar is at most this part of it.
constexpr double truth_within = 0.1;

struct Run {
  MoesGroups moes;
  bool roelands = false;
  Inlet inlet = Flooded{};
  double tolerance = 0;
};

std::string name_of(const Run& run) {
  const auto* cut = std::get_if<TruncatedAt>(&run.inlet);
  return fmt::format("M = {}, L = {}, {}, {}, tolerance {}", plain(run.moes.M), plain(run.moes.L),
                     law_name(run.roelands), cut ? "inlet " + plain(cut->x) : "flooded", plain(run.tolerance));
}

/// The tolerance is drawn from 1e-3..1e-8 by its logarithm; by Barus' law from 1e-3..1e-5, because the truth has fewer
/// digits there. Half of the runs with M >= 2 are cut at -2.5..-10, all others are flooded.
Run drawn(Draw& draw, bool roelands) {
  Run run;
  run.roelands = roelands;
  run.moes = draw.point();
  run.tolerance = Draw::digits(std::pow(10, -draw.uniform(3, roelands ? 8 : 5)), 2);
  const double cut = Draw::digits(draw.uniform(-10, -2.5), 4), choice = draw.uniform(0, 1);
  if (choice < 0.5 && run.moes.M >= 2) run.inlet = TruncatedAt{cut};
  return run;
}

Problem problem_of(const Run& run) { return problem_at(run.moes, run.roelands, run.inlet); }

/// A truth that is not ten times tighter than the bar decides nothing. The exception: the bar misses the truth by more
/// than the truth's own error. Such a bar is wrong, however small it is.
bool undecided(double difference, double bar, double truth_error) {
  return !(truth_error <= truth_within * bar) && !(difference - truth_error > bar);
}

Findings judge_bars(bool roelands, int runs) {
  const RegisteredSolver& solver = certified_solver();
  int judged = 0, covered = 0, drawn_runs = 0, without_film = 0;
  std::vector<double> ratios;  // reported over true, a film each
  std::string beyond;
  Draw draw(bar_seed);
  while (judged < runs && drawn_runs < most_draws * runs) {
    const Run run = drawn(draw, roelands);
    ++drawn_runs;
    const Problem problem = problem_of(run);
    const Solution asked = solver.solve(problem, {.tolerance = run.tolerance, .time_limit_s = 20});
    if (!observed(asked, Quantity::film_minimum)) {  // a run that did not converge may report a film with its error
      ++without_film;
      continue;
    }
    const Solution truth =
        solver.solve(problem, {.tolerance = std::max(1e-3 * run.tolerance, 1e-11), .time_limit_s = 20});
    bool known = false, inside = true;
    double worst = 0;
    for (const Quantity film : judged_films) {
      const Reading *a = observed(asked, film), *b = observed(truth, film);
      if (!a || !b) continue;
      const double bar = a->error.value(), difference = std::abs(a->value / b->value - 1);
      if (undecided(difference, bar, b->error.value())) continue;
      known = true;
      worst = worse(worst, difference / bar);
      inside = inside && difference <= bar;
      ratios.push_back(bar / std::max(difference, 1e-300));
    }
    if (!known) continue;
    ++judged;
    covered += inside ? 1 : 0;
    if (!inside) beyond += fmt::format("{}{}: {} bars off", beyond.empty() ? "" : "; ", name_of(run), plain(worst, 3));
  }
  std::sort(ratios.begin(), ratios.end());
  const double median = ratios.empty() ? nothing : ratios[ratios.size() / 2];
  const std::string law = law_name(roelands), id = "bars/" + std::string(roelands ? "roelands" : "barus");
  const std::string counts = fmt::format(
      "{} of {} runs covered, {} more drawn without a truth ten times tighter ({} of them without a film); median of "
      "bar over error {}{}",
      covered, judged, drawn_runs - judged, without_film, plain(median, 3),
      beyond.empty() ? "" : "; beyond: " + beyond);
  Findings found;
  const Tolerance promised = Tolerance::required(0.02, "at least 98 runs in 100");
  found.claims.push_back(claim(
      {.id = id + "/covered",
       .rung = 8,
       .statement = fmt::format(
           "the reference's error bars hold the films of a solution a thousand times tighter at {} random runs, {}",
           runs, law),
       .solver = solver.name},
      judged == runs ? 1 - covered / static_cast<double>(judged) : nothing, 0, promised, counts));
  found.claims.push_back(
      claim({.id = id + "/tight",
             .rung = 8,
             .statement = "in the median the reference's error bars are not more than 30 times the error, " + law,
             .solver = solver.name},
            median, 0, Tolerance::required(30, "an error bar that is far too long says little"), counts));
  return found;
}

/// How solves at random points of the box ended, and those that broke a rule: a converged solve keeps its tolerance and
/// has a finite film, and every other one gives a reason.
struct RandomEnds {
  int solves = 0, converged = 0, physical = 0, physical_converged = 0;
  double slowest_s = 0;
  std::string slowest_at, dishonest, unsolved;

  void add(const Run& run, const Problem& problem, const Solution& solution) {
    const bool ended = ehd::verification::converged(solution);
    const bool of_oil = hertz_pressure_Pa(problem.groups) <= highest_pressure_Pa;
    ++solves;
    converged += ended ? 1 : 0;
    physical += of_oil ? 1 : 0;
    physical_converged += of_oil && ended ? 1 : 0;
    const double bar = worse(solution.record.film_minimum.total(), solution.record.film_central.total());
    if (ended && !(bar <= run.tolerance && solution.fields.H.size() > 0 && solution.fields.H.allFinite()))
      dishonest += fmt::format(" {}: converged with error {};", name_of(run), plain(bar, 2));
    if (!ended && solution.record.reason.empty())
      dishonest += fmt::format(" {}: {} without a reason;", name_of(run), to_string(solution.record.status));
    if (!ended)
      unsolved += fmt::format("{}{}: {}{}", unsolved.empty() ? "" : "; ", name_of(run),
                              to_string(solution.record.status), of_oil ? "" : " (above 4 GPa)");
    if (solution.record.cost.wall_s > slowest_s) {
      slowest_s = solution.record.cost.wall_s;
      slowest_at = name_of(run);
    }
  }
  /// Two claims: enough points up to 4 GPa converged, and no solve broke a rule.
  void judge(Findings& found, Sentence converges, const Tolerance& missed, Sentence honest) const {
    const double share = physical > 0 ? 1 - physical_converged / static_cast<double>(physical) : nothing;
    found.claims.push_back(claim(std::move(converges), share, 0, missed, text()));
    found.claims.push_back(
        claim_fact(std::move(honest), dishonest.empty(), "of every solve", dishonest.empty() ? text() : dishonest));
  }
  [[nodiscard]] std::string text() const {
    return fmt::format("{} of {} converged, {} of {} up to 4 GPa; slowest {} s at {}{}", converged, solves,
                       physical_converged, physical, plain(slowest_s, 2), slowest_at,
                       unsolved.empty() ? "" : "; not: " + unsolved);
  }
};

/// Both laws at every point drawn.
Run next_run(Draw& draw, MoesGroups& point, int i, double tolerance) {
  if (i % 2 == 0) point = draw.point();
  Run run;
  run.roelands = i % 2 == 1;
  run.moes = point;
  run.tolerance = tolerance;
  return run;
}

Findings judge_box(int runs) {
  constexpr double tolerance = 1e-5;
  const RegisteredSolver& solver = certified_solver();
  RandomEnds ends;
  Draw draw(box_seed);
  MoesGroups point;
  for (int i = 0; i < 2 * runs; ++i) {
    const Run run = next_run(draw, point, i, tolerance);
    const Problem problem = problem_of(run);
    ends.add(run, problem, solver.solve(problem, {.tolerance = tolerance, .time_limit_s = 60}));
  }
  Findings found;
  ends.judge(
      found,
      {.id = "random-box/converged",
       .rung = 6,
       .statement = fmt::format(
           "the reference converges to 1e-5 at {} random flooded points of both law sets where p_H is up to 4 GPa",
           2 * runs),
       .solver = solver.name},
      Tolerance::required(0.03, "at least 97 points in 100"),
      {.id = "random-box/honest",
       .rung = 6,
       .statement = "every one of these points ends converged within its error, or says why not",
       .solver = solver.name});
  return found;
}

Findings judge_fast(double tolerance, int runs) {
  const RegisteredSolver &fast = default_solver(), &reference = certified_solver();
  const int points = 2 * fast_points_a_run * runs;
  RandomEnds ends;
  int judged = 0, covered = 0, without_truth = 0;
  double worst = 0;
  std::string beyond;
  Draw draw(fast_seed);
  MoesGroups point;
  for (int i = 0; i < points; ++i) {
    const Run run = next_run(draw, point, i, tolerance);
    const Problem problem = problem_of(run);
    const Solution solution = fast.solve(problem, {.tolerance = tolerance, .time_limit_s = 60});
    ends.add(run, problem, solution);
    // Both laws in turn: 0, 11, 20, 31, …
    if (i % points_a_truth != (i / points_a_truth) % 2) continue;
    const Solution truth =
        reference.solve(problem, {.tolerance = std::max(1e-2 * tolerance, 1e-9), .time_limit_s = 20});
    bool known = false, inside = true;
    for (const Quantity film : judged_films) {
      const Reading *a = observed(solution, film), *b = observed(truth, film);
      if (!a || !b || !a->error) continue;
      const double difference = std::abs(a->value / b->value - 1);
      if (undecided(difference, *a->error, b->error.value())) continue;
      known = true;
      const double ratio = difference / *a->error;
      if (ratio > 1) beyond += fmt::format(" {}, {}: {} bars off;", name_of(run), to_string(film), plain(ratio, 3));
      inside = inside && ratio <= 1;
      worst = worse(worst, ratio);
    }
    judged += known ? 1 : 0;
    covered += known && inside ? 1 : 0;
    without_truth += known ? 0 : 1;
  }
  const std::string at = plain(tolerance), id = "random-fast/" + at;
  Findings found;
  ends.judge(
      found,
      {.id = id + "/converged",
       .rung = 6,
       .statement = fmt::format(
           "fast converges to {} at {} random flooded points of both law sets where p_H is up to 4 GPa", at, points),
       .solver = fast.name},
      Tolerance::required(0.01, "at least 99 points in 100"),
      {.id = id + "/honest",
       .rung = 6,
       .statement = "fast ends every one of these points converged within its error, or says why not (" + at + ")",
       .solver = fast.name});
  found.claims.push_back(
      claim({.id = id + "/covered",
             .rung = 8,
             .statement = "fast's error bars at " + at + " hold the reference's films at every tenth of these points",
             .solver = fast.name + ", " + reference.name},
            judged > 0 ? 1 - covered / static_cast<double>(judged) : nothing, 0,
            Tolerance::required(0.03, "at least 97 points in 100"),
            fmt::format("{} of {} points, {} more without a truth ten times tighter; at most {} bars off{}", covered,
                        judged, without_truth, plain(worst, 2), beyond.empty() ? "" : "; beyond:" + beyond)));
  return found;
}

}  // namespace

std::vector<Topic> random_topics(int runs) {
  std::vector<Topic> topics;
  for (const bool roelands : {false, true})
    topics.push_back({.name = "honest bars, " + law_name(roelands),
                      .rungs = {8},
                      .slow = true,
                      .judge = [=] { return judge_bars(roelands, runs); },
                      .expected_s = 100});
  topics.push_back(
      {.name = "random box", .rungs = {6}, .slow = true, .judge = [=] { return judge_box(runs); }, .expected_s = 80});
  for (const double tolerance : {1e-3, 1e-5})
    topics.push_back({.name = "random box at " + plain(tolerance),
                      .rungs = {6, 8},
                      .slow = true,
                      .judge = [=] { return judge_fast(tolerance, runs); },
                      .expected_s = 20});
  return topics;
}

}  // namespace ehd::verification
