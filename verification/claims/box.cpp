// SPDX-License-Identifier: GPL-3.0-or-later
// Rungs 6, 7 and 8 over the whole box: M 0.05..1000, L 0..25, both law sets, flooded and cut at X = -4. One claim
// covers all L of an M.
#include "verification/studies/box.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "contact/text.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/solution_memory.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

constexpr double all_L[] = {0, 1, 2.5, 5, 10, 15, 20, 25};
const std::vector<double> all_M{0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};
constexpr double lightest_cut_M = 0.5;   // of a lighter contact, a cut at -4 lies inside the film's own length
constexpr double heaviest_twin_M = 200;  // of a heavier one, 256 uniform cells do not see the inlet zone

/// The contacts of one M, law set and inlet, over all L. The contact at L = 0 stands for them.
using Row = BoxContact;

Problem problem_of(const Row& row, double L) { return problem_at({row.moes.M, L}, row.roelands, row.inlet); }

std::string name_of(const Row& row) {
  return fmt::format("M = {}, {}{}", plain(row.moes.M), law_name(row.roelands),
                     row.flooded() ? ", flooded" : ", cut at -4");
}

std::string id_of(const Row& row) {
  return fmt::format("box/{}{}{}", plain(row.moes.M), row.roelands ? "-roelands" : "-barus",
                     row.flooded() ? "-flooded" : "-cut");
}

Findings judge_row(const Row& row) {
  constexpr double tolerance = 1e-3;
  const std::string &truth = certified_solver().name, &usual = default_solver().name;
  double worst = 0;  // disagreement over the sum of the reported errors
  std::string unsolved, worst_at;
  for (const double L : all_L) {
    const Problem problem = problem_of(row, L);
    const Solution reference = remembered(truth).solve(problem, {.tolerance = tolerance});
    const Solution fast = remembered(usual).solve(problem, {.tolerance = tolerance});
    if (!converged(reference) || !converged(fast)) {
      unsolved += fmt::format(" L = {} ({} {}, {} {})", plain(L), truth, to_string(reference.record.status), usual,
                              to_string(fast.record.status));
      worst = nothing;
      worst_at = "L = " + plain(L);
      continue;
    }
    for (const Quantity film : judged_films) {
      const Reading &a = reference.observables.at(film), &b = fast.observables.at(film);
      const double ratio = std::abs(b.value / a.value - 1) / (a.error.value() + b.error.value());
      if (worst = worse(worst, ratio); worst == ratio) worst_at = fmt::format("{}, L = {}", to_string(film), plain(L));
    }
  }
  Findings found;
  found.claims.push_back(claim_fact({.id = id_of(row) + "/converged",
                                     .rung = 6,
                                     .statement = "both solvers end converged at 1e-3 for L = 0..25 at " + name_of(row),
                                     .solver = truth + ", " + usual},
                                    unsolved.empty(), "the domain that both solvers declare",
                                    unsolved.empty() ? "" : "not at" + unsolved));
  found.claims.push_back(claim(
      {.id = id_of(row) + "/agreement",
       .rung = 8,
       .statement = "the films of both solvers differ by less than the sum of their reported errors at " + name_of(row),
       .solver = truth + ", " + usual},
      worst, 0, Tolerance::required(1, "disagreement over the sum of the reported errors"), worst_at));
  return found;
}

Findings judge_twin_row(const Row& row, const SolverTwins& twins) {
  constexpr int intervals = 256;
  const std::string &first = twins.twin->name, &second = twins.solver->name;
  double worst = 0;
  std::string worst_at;
  for (const double L : all_L) {
    const Problem problem = problem_of(row, L);
    const Request request{.tolerance = {}, .nodes = intervals};
    const Solution one = remembered(first).solve(problem, request), two = remembered(second).solve(problem, request);
    double differ = nothing;
    if (one.fields.X.size() == intervals + 1 && two.fields.X.size() == intervals + 1)
      differ = worse((one.fields.P - two.fields.P).abs().maxCoeff(),
                     ((one.fields.H - two.fields.H) / one.fields.H).abs().maxCoeff());
    if (worst = worse(worst, differ); worst == differ) worst_at = "worst at L = " + plain(L);
  }
  Findings found;
  found.claims.push_back(
      claim({.id = id_of(row) + "/twins",
             .rung = 7,
             .statement = fmt::format("{} equals {} in film and pressure on 256 cells for L = 0..25 at {}", second,
                                      first, name_of(row)),
             .solver = first + ", " + second},
            worst, 0, Tolerance::required(1e-8, "what both iterate to, required of the twins"), worst_at));
  return found;
}

}  // namespace

std::vector<Topic> box_topics() {
  std::vector<Row> rows = contacts_of({.M = all_M, .L = {0}, .lightest_cut_M = lightest_cut_M});
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.moes.M < b.moes.M; });
  std::vector<Topic> topics;
  for (const Row& row : rows) {
    topics.push_back({.name = id_of(row),
                      .rungs = {6, 8},
                      .slow = true,
                      .judge = [row] { return judge_row(row); },
                      .expected_s = 10});
    if (row.flooded() || row.moes.M > heaviest_twin_M) continue;
    for (const SolverTwins& twins : solver_twins())
      topics.push_back({.name = "twins, " + id_of(row), .rungs = {7}, .slow = true, .judge = [row, twins] {
                          return judge_twin_row(row, twins);
                        }});
  }
  return topics;
}

}  // namespace ehd::verification
