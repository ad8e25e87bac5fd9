// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 8: the truncation that the FFT solvers state of a flooded contact. Their grids begin at X_a = -reach l, with an
// asymptotic tail beyond (fast/inlet_tail.hpp); what the tail leaves out moves the films. So the same contact is solved
// with the reach of the solver and with 16, 32 and 64: no two of the films may differ by more than the solver states.
// All of them are solved on the mapped grids of `fast`, which are extrapolated: differences of 1e-10 are seen.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "contact/text.hpp"
#include "fast/mapped_climb.hpp"
#include "fast/mapped_judgement.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/studies/box.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

/// Light loads, whose inlet reaches farthest, beside heavier ones. The largest truncations that were found are those at
/// (1.5, 0): 2.4e-6, 2e-7 and 5.8e-9 with a reach of 4, 8 and 16.
const BoxContact far_contacts[] = {{{0.2, 5}, false}, {{1.5, 0}, false}, {{5, 5}, true}, {{20, 10}, true}};
constexpr double far_reaches[] = {16, 32, 64};
/// The finer one decides. The change from the coarser one is the uncertainty.
constexpr int coarser_grid = 2048, finer_grid = 4096;

/// A request, by which a solver chooses its reach.
struct ReachRequest {
  const char* solver;
  double tolerance;
};
constexpr ReachRequest reach_requests[] = {{"fast", 1e-3}, {"fast.uniform", 1e-3}, {"fast.uniform", 1e-5}};

using BothFilms = std::array<double, judged_films.size()>;

BothFilms films_with_reach(const Problem& problem, double reach, int intervals) {
  const Request request{.tolerance = {}, .nodes = intervals};
  fast::Workspace workspace;
  fast::Run run = fast::begin_run(problem, request, workspace, {.reach = reach, .truncation = 0});
  const fast::MappedClimb climb =
      fast::climb_mapped(run, request, fast::recipes[0], nullptr, fast::care_for(request, problem.groups));
  BothFilms films{nothing, nothing};
  if (!climb.complete) return films;
  Solution solution;
  fast::judge(climb, problem, solution);
  for (std::size_t k = 0; k < films.size(); ++k) films[k] = value_of(observed(solution, judged_films[k]));
  return films;
}

/// The largest relative difference of any two of a film's values.
double film_spread(const std::vector<BothFilms>& all, std::size_t film) {
  double widest = 0;
  for (const BothFilms& one : all) {
    for (const BothFilms& other : all) widest = worse(widest, std::abs(one[film] / other[film] - 1));
  }
  return widest;
}

Findings judge_truncation(const BoxContact& contact) {
  const Problem problem = contact.problem();
  const auto at_all_reaches = [&](int intervals) {
    std::vector<BothFilms> all;
    for (const double reach : far_reaches) all.push_back(films_with_reach(problem, reach, intervals));
    return all;
  };
  const std::vector<BothFilms> on_coarse = at_all_reaches(coarser_grid), on_fine = at_all_reaches(finer_grid);
  Findings found;
  for (const ReachRequest& asked : reach_requests) {
    const RegisteredSolver& solver = *find_solver(asked.solver);
    const Solution solution = solver.solve(problem, {.tolerance = asked.tolerance});
    const bool solved = solution.fields.X.size() > 0;
    const double reach = solved ? -solution.fields.X[0] / fast::expected_lengths(problem.groups).scale : nothing;
    const auto with_own = [&](std::vector<BothFilms> all, int intervals) {
      all.push_back(solved ? films_with_reach(problem, reach, intervals) : BothFilms{nothing, nothing});
      return all;
    };
    const std::vector<BothFilms> before = with_own(on_coarse, coarser_grid), all = with_own(on_fine, finer_grid);
    for (std::size_t k = 0; k < judged_films.size(); ++k) {
      const ErrorBudget& budget = k == 0 ? solution.record.film_minimum : solution.record.film_central;
      const std::string film(to_string(judged_films[k]));
      const double widest = film_spread(all, k);
      found.claims.push_back(
          claim({.id = fmt::format("truncation/{}-{}/{}/{}/{}", plain(contact.moes.M), plain(contact.moes.L),
                                   solver.name, plain(asked.tolerance), film),
                 .rung = 8,
                 .statement = fmt::format("the truncation that {} at {} states of {} covers its moves between a reach "
                                          "of {}, 16, 32 and 64, at {}, flooded",
                                          solver.name, plain(asked.tolerance), film, plain(reach, 3), contact.name()),
                 .solver = solver.name},
                widest, std::abs(widest - film_spread(before, k)),
                Tolerance::required(budget.truncation, "the truncation that the solver states"),
                fmt::format("from 16 to 32 {}, from 32 to 64 {}", plain(std::abs(all[0][k] / all[1][k] - 1), 2),
                            plain(std::abs(all[1][k] / all[2][k] - 1), 2))));
    }
  }
  return found;
}

}  // namespace

std::vector<Topic> truncation_topics() {
  std::vector<Topic> topics;
  for (const BoxContact& contact : far_contacts)
    topics.push_back({.name = "truncation", .rungs = {8}, .judge = [&contact] { return judge_truncation(contact); }});
  return topics;
}

}  // namespace ehd::verification
