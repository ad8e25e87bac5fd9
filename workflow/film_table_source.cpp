// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/film_table_source.hpp"

#include <algorithm>

#include "contact/observables.hpp"
#include "workflow/batch.hpp"
#include "workflow/registry.hpp"

namespace ehd {

namespace {

/// A solve may state more for the Couette film and the offset than it was asked for of the others, most of all beside
/// the bend. Where a film has more than its share of the table's tolerance, the contact is asked for that much more.
constexpr double asked_more = 0.1;

SolvedFilms films_of(const Solution& solution) {
  SolvedFilms films;
  if (solution.fields.P.size() > 0) {  // a solve that a limit ended has none
    const auto peak = observed::pressure_maximum(solution.fields);
    films.peak = peak->value;
    films.peak_X = peak->place.value();
  }
  const SolveRecord& record = solution.record;
  // A solve that missed its tolerance states its error, and the table's error has it.
  if (record.status != StopReason::converged && record.status != StopReason::tolerance_not_met)
    films.why = std::string(to_string(record.status)) + (record.reason.empty() ? "" : ": " + record.reason);
  for (std::size_t k = 0; k < table_film_count && films.why.empty(); ++k) {
    const auto at = solution.observables.find(table_films[k]);
    if (at == solution.observables.end() || !at->second.error) {
      films.why = std::string(to_string(table_films[k])) + " is not known with an error";
      break;
    }
    films.value[k] = at->second.value;
    films.error[k] = *at->second.error;
  }
  return films;
}

/// The largest error of a film, in units of table_error_unit.
double largest_error(const SolvedFilms& films) {
  double largest = 0;
  for (std::size_t k = 0; k < table_film_count; ++k)
    largest = std::max(largest, films.error[k] / table_unit_of_stated(table_films[k], films.value[k]));
  return largest;
}

}  // namespace

FilmSource film_solves(const TableOil& oil, double table_tolerance, unsigned threads, double time_limit_s,
                       const Deadline& deadline) {
  RegisteredSolver solver = default_solver();
  solver.solve = deadline.limiting(solver.solve);
  const auto solved = [=](const std::vector<MoesGroups>& contacts, double tolerance) {
    Request each;
    each.tolerance = tolerance;
    each.time_limit_s = time_limit_s;
    std::vector<Problem> problems;
    for (const MoesGroups& at : contacts) {
      problems.push_back(problem_of(oil, at));
      problems.back().wanted = {table_films.begin(), table_films.end()};
    }
    std::vector<SolvedFilms> films;
    for (const Solution& solution : solve_all(solver, problems, each, threads)) films.push_back(films_of(solution));
    return films;
  };
  return [=](const std::vector<MoesGroups>& contacts) {
    std::vector<SolvedFilms> films = solved(contacts, solve_share * table_tolerance);
    std::vector<MoesGroups> again;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < contacts.size(); ++i)
      if (films[i].why.empty() && largest_error(films[i]) > solve_share * table_tolerance) {
        again.push_back(contacts[i]);
        places.push_back(i);
      }
    if (again.empty()) return films;
    const std::vector<SolvedFilms> better = solved(again, asked_more * solve_share * table_tolerance);
    for (std::size_t i = 0; i < again.size(); ++i)
      if (better[i].why.empty() && largest_error(better[i]) < largest_error(films[places[i]]))
        films[places[i]] = better[i];
    return films;
  };
}

}  // namespace ehd
