// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 8: grid studies of the second-order solvers. Limit and error are estimated from the grids and then compared with
// the high-order reference. The reference's flooded inlet is compared with inlets cut further and further out.
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "contact/stated_error.hpp"
#include "contact/text.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/solution_memory.hpp"
#include "verification/studies/box.hpp"
#include "verification/studies/grid_study.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

struct Study {
  const char* solver;
  std::vector<int> grids;
};
const Study studies[] = {{"reference.uniform", {128, 256, 512, 1024}},
                         {"reference.linear", {128, 256, 512, 1024}},
                         {"fast.uniform", {512, 1024, 2048, 4096, 8192}}};
/// Cells in the inlet zone of the coarsest grid of a study; a coarser one says nothing of the limit.
constexpr double fewest_study_cells = 1.5;
constexpr MoesGroups study_points[] = {{2, 0}, {5, 5}, {20, 5}, {20, 10}, {100, 10}};

Problem problem_of(MoesGroups moes, Inlet inlet) { return problem_at(moes, moes.L > 0, inlet); }

Findings judge_study(const Study& study, MoesGroups moes) {
  const Problem problem = problem_of(moes, TruncatedAt{-4});
  const Solution truth = remembered(certified_solver().name).solve(problem, {.tolerance = 1e-9});
  const RegisteredSolver& solver = remembered(study.solver);
  std::vector<Solution> solutions;
  for (const int cells : study.grids) solutions.push_back(solver.solve(problem, {.tolerance = {}, .nodes = cells}));
  const std::string point = fmt::format("{}-{}", plain(moes.M), plain(moes.L));
  Findings found;
  for (const Quantity film : judged_films) {
    const auto says = [&](const std::string& what, const std::string& statement) {
      return Sentence{.id = fmt::format("grids/{}/{}/{}/{}", solver.name, point, to_string(film), what),
                      .rung = 8,
                      .statement = statement,
                      .solver = solver.name};
    };
    const std::string of = fmt::format(" of {}'s {} at M-L = {}", solver.name, to_string(film), point);
    std::vector<GridValue> values;
    std::string unsolved;
    for (std::size_t i = 0; i < solutions.size(); ++i) {
      const SolveRecord& record = solutions[i].record;
      const Reading* seen = observed(solutions[i], film);
      if (seen && solved_on_its_grid(solutions[i]) && record.grids.back().inlet_cells >= fewest_study_cells) {
        values.push_back({static_cast<double>(study.grids[i]), seen->value});
      } else if (!values.empty()) {
        unsolved = fmt::format("{} cells: {}", plain(study.grids[i]), to_string(record.status));
      }
    }
    const Reading* exact = reading(truth, film);
    if (values.size() < 3 || !unsolved.empty() || !exact) {
      found.claims.push_back(claim(says("covered", "the grid study" + of + " covers its error"), nothing, 0,
                                   Tolerance::required(1, "error over uncertainty"), "not solved; " + unsolved));
      continue;
    }
    constexpr double iterated_to = 1e-9;  // relative, of the films on a given grid
    const GridStudy seen = study_grids(values, solver.description.formal_order, iterated_to);
    const double off = std::abs(values.back().value / exact->value - 1);
    const std::string note = fmt::format("{}{}, uncertainty {}, error {} on {} cells{}", to_string(seen.trend),
                                         seen.observed_order ? ", order " + plain(*seen.observed_order, 3) : "",
                                         plain(seen.uncertainty, 2), plain(off, 2), plain(values.back().cells),
                                         values.size() < study.grids.size() ? ", without under-resolved grids" : "");
    if (!std::isfinite(seen.uncertainty)) {
      // Differences that grow from grid to grid have no limit. These grids were chosen because their study has one.
      found.claims.push_back(claim(says("covered", "the grid study" + of + " covers its error"), nothing, 0,
                                   Tolerance::required(1, "error over uncertainty"), note));
      continue;
    }
    found.claims.push_back(
        claim(says("covered", "the uncertainty that the grid study" + of + " states covers its error"),
              off / seen.uncertainty, exact->error.value() / seen.uncertainty,
              Tolerance::required(1, "error over uncertainty"), note));
    if (seen.extrapolated) {
      const double extrapolated = std::abs(*seen.extrapolated / exact->value - 1);
      found.claims.push_back(
          claim(says("extrapolated",
                     "where the grid study" + of + " is asymptotic, the extrapolated value is nearer to the truth"),
                extrapolated / off, exact->error.value() / off,
                Tolerance::required(1, "its error over that of the finest grid"),
                fmt::format("{}, extrapolated {}", note, plain(extrapolated, 2))));
    }
  }
  return found;
}

/// At a cut X_a the pressure is 4 lambda/(3 |X_a|^3) too small, and the load before it is missing. So films come to
/// that of the flooded contact like |X_a|^-2, and like higher powers from further terms of the gap's series. The
/// extrapolation removes three powers.
Findings judge_flooded(MoesGroups moes) {
  constexpr double tolerance = 1e-10;
  constexpr double cuts[] = {160, 320, 640, 1280};
  const RegisteredSolver& solver = remembered(certified_solver().name);
  std::vector<double> central;
  std::string ended;
  double error = 0;
  const auto central_film = [&](const Inlet& inlet, double cut) {
    const Solution solution = solver.solve(problem_of(moes, inlet), {.tolerance = tolerance});
    const Reading* seen = reading(solution, Quantity::film_central);
    if (!seen) {
      ended += fmt::format("; cut {} {}", plain(cut), to_string(solution.record.status));
      return nothing;
    }
    error = worse(error, seen->error.value());
    return seen->value;
  };
  const double truth = central_film(Flooded{}, 0);
  for (const double cut : cuts) central.push_back(central_film(TruncatedAt{-cut}, cut));
  std::string note = "below the flooded film by";
  for (const double film : central) note += " " + plain(1 - film / truth, 3);
  for (const double factor : {4.0, 8.0, 16.0}) {
    for (std::size_t i = central.size() - 1; i > 0; --i) central[i] += (central[i] - central[i - 1]) / (factor - 1);
    central.erase(central.begin());
  }
  const std::string point = fmt::format("{}-{}", plain(moes.M), plain(moes.L));
  return {{claim_value({.id = "flooded/" + point,
                        .rung = 8,
                        .statement = fmt::format("cut at -160 ... -1280 and extrapolated to infinity, the reference's "
                                                 "central film at M-L = {} is its flooded one",
                                                 point),
                        .solver = solver.name},
                       central.back(), truth, 2 * error,
                       Tolerance::required(1e-9, "flooded inlets to 1e-9 of the central film"), note + ended)},
          {}};
}

/// Behind a narrow spike the pressure falls within a cell. With the density of the node in the wedge, not that of
/// fast/carried_density.hpp, H_min errs by 2e-5 there.
Findings judge_steep_fall(MoesGroups moes) {
  constexpr int intervals = 1024;
  constexpr double truth_tolerance = 1e-7, required = 5e-6;
  const Problem problem = problem_of(moes, Flooded{});
  const Solution truth = remembered(certified_solver().name).solve(problem, {.tolerance = truth_tolerance}),
                 given = remembered("fast").solve(problem, {.tolerance = {}, .nodes = intervals});
  const Reading *known = reading(truth, Quantity::film_minimum), *seen = reading(given, Quantity::film_minimum);
  const double value = known ? known->value : nothing, error = known ? known->error.value() : nothing;
  const std::string point = fmt::format("{}-{}", plain(moes.M), plain(moes.L));
  return {{claim_value({.id = "grids/steep-fall/" + point,
                        .rung = 8,
                        .statement = fmt::format("on {} intervals fast has H_min of compressible oil behind the narrow "
                                                 "spike at M-L = {}",
                                                 intervals, point),
                        .solver = "fast"},
                       seen ? seen->value : nothing, value, error,
                       Tolerance::required(required, "H_min to 5e-6 on 1024 intervals"), "")},
          {}};
}

}  // namespace

std::vector<Topic> grid_topics() {
  std::vector<Topic> topics;
  for (const Study& study : studies) {
    for (const MoesGroups& moes : study_points)
      topics.push_back({.name = "grid studies", .rungs = {8}, .slow = true, .judge = [&study, moes] {
                          return judge_study(study, moes);
                        }});
  }
  for (const MoesGroups& moes : {MoesGroups{2, 2.5}, MoesGroups{20, 10}, MoesGroups{200, 5}})
    topics.push_back({.name = "flooded inlet", .rungs = {8}, .judge = [moes] { return judge_flooded(moes); }});
  for (const MoesGroups& moes : {MoesGroups{200, 20}, MoesGroups{2000, 20}})
    topics.push_back({.name = "steep fall", .rungs = {8}, .judge = [moes] { return judge_steep_fall(moes); }});
  return topics;
}

}  // namespace ehd::verification
