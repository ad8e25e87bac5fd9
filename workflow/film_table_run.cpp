// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/film_table_run.hpp"

#include <fmt/format.h>

#include <cmath>

#include "contact/text.hpp"

namespace ehd {

ContactRun run_from_table(const Case& contact_case, const FilmTable& table) {
  const auto& contact = std::get<ContactCase>(contact_case.body);
  const Nondimensional made = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet);
  ContactRun run;
  run.case_id = contact_case.id;
  run.version = contact_case.version;
  run.solver = table_solver;
  run.plan.decide(stage::groups);
  run.plan.decide("films from a table");
  run.plan.decide(stage::solve, "films = \"table\"");
  run.groups = made.problem.groups;
  run.scales = made.scales;
  run.oil = contact.oil;
  run.notes = contact.oil ? notes_of(*contact.oil, made.notes) : made.notes;
  run.solution.record.status = table.status;
  run.solution.record.reason = table.reason;
  if (table.panels.empty()) return run;
  run.notes.push_back(fmt::format("the films are those of a table over M {} to {}, L {} to {}, made of {} solves by {}",
                                  plain(table.range.M_low), plain(table.range.M_high), plain(table.range.L_low),
                                  plain(table.range.L_high), table.solves, table.solver));
  const auto films = films_at(table, {.M = made.problem.groups.M, .L = made.problem.groups.L});
  for (std::size_t k = 0; films && k < table_film_count; ++k) {
    const double value = (*films)[k].value;
    Reading& film = run.solution.observables[table_films[k]] = {.value = value};
    if (std::isfinite((*films)[k].error)) film.error = (*films)[k].error * table_unit_of_stated(table_films[k], value);
  }
  return run;
}

}  // namespace ehd
