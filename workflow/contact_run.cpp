// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/contact_run.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <variant>

#include "contact/hertz.hpp"
#include "contact/observables.hpp"
#include "contact/quantities.hpp"
#include "contact/text.hpp"
#include "workflow/plausibility.hpp"
#include "workflow/shown_pressure.hpp"

namespace ehd {

namespace {

constexpr std::array pressure_peaks{Quantity::pressure_maximum, Quantity::pressure_spike};

/// The fields of the dry contact, for a profile, over twice the contact's width.
Fields dry_fields() {
  constexpr int intervals = 400;
  Fields fields;
  fields.X = Array::LinSpaced(intervals + 1, -2, 2);
  fields.P = hertz::pressure(fields.X);
  fields.H = hertz::gap(fields.X);
  fields.offset = hertz::dry_offset();
  return fields;
}

Observables dry_observables(const Wanted& wanted) {
  Observables observed;
  for (const Quantity quantity : wanted)
    if (exists_when_dry(quantity)) {
      observed[quantity] = row_of(quantity).when_dry();
      observed[quantity].error = 0;
    }
  return observed;
}

void run_dry(const ContactCase& contact, ContactRun& run) {
  const auto& conditions = std::get<Conditions>(contact.statement);
  run.scales = Scales{.hertz_pressure_Pa = hertz::pressure_Pa(conditions),
                      .half_width_m = hertz::half_width_m(conditions),
                      .reduced_radius_m = conditions.reduced_radius_m};
  run.solution.fields = dry_fields();
  run.solution.observables = dry_observables(wanted_by(run.plan));
  run.peaks = dry_observables({Quantity::pressure_maximum});
  run.solution.record.status = StopReason::converged;
}

/// Drops what nobody wanted. Peaks of the pressure go to run.peaks instead, and their notes are dropped.
void sort_observables(const Wanted& wanted, ContactRun& run) {
  Observables& observed = run.solution.observables;
  if (run.status() == StopReason::diverged) observed.clear();
  for (const Quantity peak : pressure_peaks) {
    if (wanted.contains(peak)) continue;
    if (const auto at = observed.find(peak); at != observed.end()) run.peaks.insert(*at);
    std::erase_if(run.solution.record.notes,
                  [&](const std::string& note) { return note.starts_with(to_string(peak)); });
  }
  keep_wanted(observed, wanted);
}

void run_lubricated(const ContactCase& contact, const RegisteredSolver& solver, const Request& request,
                    ContactRun& run) {
  Nondimensional reading = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet);
  Problem& problem = reading.problem;
  const Wanted wanted = wanted_by(run.plan);
  problem.wanted = wanted;
  problem.wanted.insert(pressure_peaks.begin(), pressure_peaks.end());
  run.groups = problem.groups;
  run.scales = reading.scales;
  run.oil = contact.oil;
  run.notes = contact.oil ? notes_of(*contact.oil, reading.notes) : reading.notes;
  run.solver = solver.name;
  run.solution = solver.solve(problem, request_for(request, wanted));
  sort_observables(wanted, run);
  const auto& notes = run.solution.record.notes;
  run.notes.insert(run.notes.end(), notes.begin(), notes.end());
  if (run.plan.runs(stage::formulas)) {
    run.formulas = film_formulas({.M = problem.groups.M, .L = problem.groups.L}, run.known_G().value_or(usual_G));
    std::erase_if(run.formulas, [&](const FilmFormula& formula) { return !wanted.contains(formula.of); });
  }
}

}  // namespace

std::optional<double> ContactRun::moes_per_hertz_film() const {
  if (!groups) return std::nullopt;
  return moes_film_per_hertz_film(groups->M);
}

std::optional<double> ContactRun::m_per_hertz_film() const { return SI_per_hertz(SIScale::film); }

std::optional<double> ContactRun::SI_per_hertz(SIScale scale) const {
  if (!scales) return std::nullopt;
  switch (scale) {
    case SIScale::none: return std::nullopt;
    case SIScale::film: return scales->film_m_per_hertz_film();
    case SIScale::length: return scales->half_width_m;
    case SIScale::pressure: return scales->hertz_pressure_Pa;
    case SIScale::force: {
      const auto film_m = scales->film_m_per_hertz_film();
      return film_m ? std::optional(scales->hertz_pressure_Pa * *film_m) : std::nullopt;
    }
  }
  return std::nullopt;
}

std::optional<double> ContactRun::known_G() const {
  if (!scales || !scales->dowson || !(scales->dowson->G > 0)) return std::nullopt;
  return scales->dowson->G;
}

namespace {

/// Cuts before it are solved: 20 of 20 contacts with M .5 to 5000 and L 0 to 30 at X = -1.01, 15 at -1.003, 10 at
/// -1.001.
constexpr double nearest_cut = -1.01;

void name_near_cut(const ContactCase& contact, SolveRecord& record) {
  const auto* cut = contact.inlet ? std::get_if<TruncatedAt>(&*contact.inlet) : nullptr;
  if (!cut || cut->x <= nearest_cut || record.status != StopReason::limit_reached) return;
  constexpr int digits = 10;
  record.reason += fmt::format(
      "; the inlet is cut at X = {}, too near to the contact: contacts cut at X = {} and before "
      "it are solved",
      plain(cut->x, digits), plain(nearest_cut));
}

}  // namespace

ContactRun run_contact(const ContactCase& contact, const RegisteredSolver& solver, const Request& request,
                       const Wanted& wanted) {
  ContactRun run;
  run.plan = plan_contact(contact, solver, request, wanted);
  if (run.plan.runs(stage::solve)) {
    run_lubricated(contact, solver, request, run);
    name_near_cut(contact, run.solution.record);
  } else {
    run_dry(contact, run);
  }
  for (const Unusual& one : unusual(facts_of(contact, run))) run.notes.push_back(sentence_of(one));
  return run;
}

ContactRun run_contact(const Case& contact_case, const RegisteredSolver& solver, const Request& request,
                       const Wanted& wanted) {
  ContactRun run = run_contact(std::get<ContactCase>(contact_case.body), solver, request, wanted);
  run.case_id = contact_case.id;
  run.version = contact_case.version;
  return run;
}

void require_chosen(const Wanted& chosen, ContactRun& run) {
  if (run.status() != StopReason::converged) return;
  for (const Quantity quantity : chosen) {
    if (run.solution.observables.contains(quantity)) continue;
    const std::string name(to_string(quantity));
    if (!run.groups) {
      run.notes.push_back(name + " does not exist in a dry contact");
    } else if (quantity == Quantity::pressure_spike && pressure_known(run) && !vague_spike(run)) {
      run.notes.push_back(
          fmt::format("{}: the pressure has no peak behind its maximum on {} intervals (more intervals "
                      "may show a low one)",
                      name, run.solution.record.cost.nodes));
    } else if (is_pressure_peak(quantity)) {
      run.solution.record.status = StopReason::tolerance_not_met;
      run.solution.record.reason = name + " is not known well enough";
    }
  }
}

namespace {

/// The factor from Hertz units to a scaling.
std::optional<double> unit_in(Scaling scaling, const ContactRun& run, const QuantityRow& row) {
  switch (scaling) {
    case Scaling::hertz: return 1.0;
    case Scaling::moes: return run.moes_per_hertz_film();
    case Scaling::kostreva: return row.kostreva_factor;
    case Scaling::SI: return run.SI_per_hertz(row.SI);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Measured> measure(const ContactRun& run, const Expectation& expectation) {
  const auto quantity = quantity_from(expectation.quantity);
  if (!quantity) return std::nullopt;
  const auto at = run.solution.observables.find(*quantity);
  if (at == run.solution.observables.end()) return std::nullopt;
  const Reading& reading = at->second;
  const auto unit = unit_in(expectation.scaling, run, row_of(*quantity));
  if (!unit) return std::nullopt;

  Measured measured{.value = reading.value * *unit};
  if (!reading.error) return measured;
  const double size = std::abs(reading.value);
  if (!has_absolute_error(*quantity)) {
    measured.error = *reading.error;
  } else if (size > 0) {
    measured.error = *reading.error / size;
  }
  return measured;
}

}  // namespace ehd
