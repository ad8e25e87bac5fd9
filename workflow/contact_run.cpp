// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/contact_run.hpp"

#include <cmath>
#include <variant>

#include "contact/hertz.hpp"

namespace ehd {

namespace {

/// The fields of the dry contact, for a profile: twice the contact's width.
Fields dry_fields() {
  constexpr int intervals = 400;
  Fields fields;
  fields.X = Array::LinSpaced(intervals + 1, -2, 2);
  fields.P = hertz::pressure(fields.X);
  fields.H = hertz::gap(fields.X);
  fields.offset = hertz::dry_offset();
  return fields;
}

/// Everything that a dry contact has, in Hertz units: exact.
Observables dry_observables(const Wanted& wanted) {
  const Observables all{{Quantity::film_offset, {.value = hertz::dry_offset(), .error = 0.0}},
                        {Quantity::pressure_maximum, {.value = 1, .place = 0.0, .error = 0.0}},
                        {Quantity::pressure_exit, {.value = 1, .error = 0.0}},
                        {Quantity::approach, {.value = -hertz::dry_offset(), .error = 0.0}}};
  Observables asked;
  for (const auto& [quantity, reading] : all) {
    if (wanted.count(quantity)) asked[quantity] = reading;
  }
  return asked;
}

void run_dry(const ContactCase& contact, ContactRun& run) {
  const auto& conditions = std::get<Conditions>(contact.statement);
  run.scales = Scales{.hertz_pressure_Pa = hertz::pressure_Pa(conditions),
                      .half_width_m = hertz::half_width_m(conditions),
                      .reduced_radius_m = conditions.reduced_radius_m};
  run.solution.fields = dry_fields();
  run.solution.observables = dry_observables(wanted_by(run.plan));
  run.solution.record.status = StopReason::converged;
}

void run_lubricated(const ContactCase& contact, const RegisteredSolver& solver, const Request& request,
                    ContactRun& run) {
  Nondimensional reading = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet);
  Problem& problem = reading.problem;
  problem.wanted = wanted_by(run.plan);
  run.groups = problem.groups;
  run.scales = reading.scales;
  run.notes = reading.notes;
  run.solver = solver.name;
  run.solution = solver.solve(problem, request);
  // What a solver needed for itself beside what was asked for is not reported.
  std::erase_if(run.solution.observables, [&](const auto& entry) { return !problem.wanted.count(entry.first); });
  if (run.status() == StopReason::diverged) run.solution.observables.clear();
  const auto& notes = run.solution.record.notes;
  run.notes.insert(run.notes.end(), notes.begin(), notes.end());
  if (run.plan.runs(stage::formulas)) {
    run.formulas = film_formulas({.M = problem.groups.M, .L = problem.groups.L}, run.known_G().value_or(usual_G));
  }
}

}  // namespace

std::optional<double> ContactRun::moes_per_hertz_film() const {
  if (!groups) return std::nullopt;
  return moes_film_per_hertz_film(groups->M);
}

std::optional<double> ContactRun::m_per_hertz_film() const {
  if (!scales) return std::nullopt;
  return scales->film_m_per_hertz_film();
}

std::optional<double> ContactRun::known_G() const {
  if (!scales || !scales->dowson || !(scales->dowson->G > 0)) return std::nullopt;
  return scales->dowson->G;
}

ContactRun run_contact(const ContactCase& contact, const RegisteredSolver& solver, const Request& request,
                       const Wanted& wanted) {
  ContactRun run;
  run.plan = plan_contact(contact, solver, request, wanted);
  if (run.plan.runs(stage::solve)) {
    run_lubricated(contact, solver, request, run);
  } else {
    run_dry(contact, run);
  }
  return run;
}

ContactRun run_contact(const Case& contact_case, const RegisteredSolver& solver, const Request& request,
                       const Wanted& wanted) {
  ContactRun run = run_contact(std::get<ContactCase>(contact_case.body), solver, request, wanted);
  run.case_id = contact_case.id;
  run.version = contact_case.version;
  return run;
}

std::optional<Measured> measure(const ContactRun& run, const Expectation& expectation) {
  const auto quantity = quantity_from(expectation.quantity);
  if (!quantity) return std::nullopt;
  const auto at = run.solution.observables.find(*quantity);
  if (at == run.solution.observables.end()) return std::nullopt;
  const Reading& reading = at->second;
  const bool film = expectation.quantity.starts_with("film.");
  const bool approach = *quantity == Quantity::approach;

  std::optional<double> unit = 1.0;
  if (expectation.scaling == Scaling::moes) {
    unit = run.moes_per_hertz_film();
  } else if (expectation.scaling == Scaling::kostreva) {
    unit = film ? 2.0 : 1.0;  // h_K = 2H, k = 2 H_0
  } else if (expectation.scaling == Scaling::SI) {
    unit = std::nullopt;
    if (film || approach) unit = run.m_per_hertz_film();
    if (*quantity == Quantity::pressure_exit && run.scales) unit = run.scales->half_width_m;
    if ((*quantity == Quantity::pressure_maximum || *quantity == Quantity::pressure_spike) && run.scales)
      unit = run.scales->hertz_pressure_Pa;
  }
  if (!unit) return std::nullopt;

  Measured measured{.value = reading.value * *unit};
  if (reading.error) {
    const bool absolute = *quantity == Quantity::film_offset || approach;  // see Reading
    const double size = std::abs(reading.value);
    if (!absolute) measured.error = *reading.error;
    if (absolute && size > 0) measured.error = *reading.error / size;
  }
  return measured;
}

}  // namespace ehd
