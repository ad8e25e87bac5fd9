// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/film_table_source.hpp"

#include "contact/observables.hpp"
#include "workflow/batch.hpp"
#include "workflow/registry.hpp"

namespace ehd {

FilmSource film_solves(const TableOil& oil, double table_tolerance, unsigned threads, double time_limit_s,
                       const Deadline& deadline) {
  RegisteredSolver solver = default_solver();
  solver.solve = deadline.limiting(solver.solve);
  Request each;
  each.tolerance = solve_share * table_tolerance;
  each.time_limit_s = time_limit_s;
  return [oil, solver, each, threads](const std::vector<MoesGroups>& contacts) {
    std::vector<Problem> problems;
    for (const MoesGroups& at : contacts) {
      problems.push_back(problem_of(oil, at));
      problems.back().wanted = {table_films.begin(), table_films.end()};
    }
    std::vector<SolvedFilms> films;
    for (const Solution& solution : solve_all(solver, problems, each, threads)) {
      SolvedFilms& one = films.emplace_back();
      const SolveRecord& record = solution.record;
      if (solution.fields.P.size() > 0) {  // a solve that a limit ended has none
        const auto peak = observed::pressure_maximum(solution.fields);
        one.peak = peak->value;
        one.peak_X = peak->place.value();
      }
      // A solve that missed its tolerance states its error, and the table's error has it.
      if (record.status != StopReason::converged && record.status != StopReason::tolerance_not_met)
        one.why = std::string(to_string(record.status)) + (record.reason.empty() ? "" : ": " + record.reason);
      for (std::size_t k = 0; k < table_film_count && one.why.empty(); ++k) {
        const auto at = solution.observables.find(table_films[k]);
        if (at == solution.observables.end() || !at->second.error) {
          one.why = std::string(to_string(table_films[k])) + " is not known with an error";
          break;
        }
        one.value[k] = at->second.value;
        one.error[k] = *at->second.error;
      }
    }
    return films;
  };
}

}  // namespace ehd
