// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 7: twins (fast.uniform and reference.uniform) solve the same discrete equations, each with its own code.
#include <fmt/format.h>

#include <string>
#include <utility>

#include "contact/stated_error.hpp"
#include "contact/text.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/solution_memory.hpp"
#include "verification/studies/box.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

double value(const Solution& solution, Quantity quantity) {
  return solved_on_its_grid(solution) ? value_of(observed(solution, quantity)) : nothing;
}

Findings judge_twins(const SolverTwins& twins, MoesGroups moes, int intervals) {
  const Problem problem = problem_at(moes, true, TruncatedAt{usual_cut});
  const Request request{.tolerance = {}, .nodes = intervals};
  const std::string &first = twins.twin->name, &second = twins.solver->name;
  const Solution one = remembered(first).solve(problem, request), two = remembered(second).solve(problem, request);

  Findings found;
  const std::string M = plain(moes.M), L = plain(moes.L), cells = std::to_string(intervals);
  const Tolerance bound = Tolerance::required(1e-8, "what both iterate to, required of the twins");
  const auto says = [&](const std::string& what) {
    return Sentence{
        .id = fmt::format("twins/{}-{}/{}/{}", M, L, cells, what),
        .rung = 7,
        .statement = fmt::format("{} equals {} in {} at ({},{}), {} cells", second, first, what, M, L, cells),
        .solver = first + ", " + second};
  };
  const std::string ends =
      fmt::format("{} {}, {} {}", first, to_string(one.record.status), second, to_string(two.record.status));
  for (const Quantity quantity : {Quantity::film_minimum, Quantity::film_central, Quantity::pressure_exit}) {
    found.claims.push_back(claim_value(says(std::string(to_string(quantity))), value(two, quantity),
                                       value(one, quantity), 0, bound, ends));
  }
  const bool comparable = solved_on_its_grid(one) && solved_on_its_grid(two) &&
                          one.fields.X.size() == two.fields.X.size() && one.fields.X.size() == intervals + 1;
  found.claims.push_back(claim(says("pressure profile"),
                               comparable ? (one.fields.P - two.fields.P).abs().maxCoeff() : nothing, 0, bound, ends));
  found.claims.push_back(claim(says("film profile"),
                               comparable ? ((one.fields.H - two.fields.H) / one.fields.H).abs().maxCoeff() : nothing,
                               0, bound, ends));
  return found;
}

}  // namespace

std::vector<Topic> twin_topics() {
  std::vector<Topic> topics;
  const std::pair<MoesGroups, int> grids[] = {{{5, 5}, 256},    {{5, 5}, 512},    {{20, 10}, 256},  {{20, 10}, 512},
                                              {{20, 10}, 1024}, {{200, 10}, 256}, {{200, 10}, 512}, {{200, 15}, 1024}};
  for (const SolverTwins& twins : solver_twins())
    for (const auto& grid : grids)
      topics.push_back({.name = "twins", .rungs = {7}, .judge = [twins, grid] {
                          return judge_twins(twins, grid.first, grid.second);
                        }});
  return topics;
}

}  // namespace ehd::verification
