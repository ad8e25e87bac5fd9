// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/response_run.hpp"

#include <cmath>
#include <numbers>
#include <variant>

#include "contact/hertz.hpp"

namespace ehd {

namespace {

using std::numbers::pi;

std::optional<ResponseScales> response_scales_of(const ContactCase& contact) {
  const auto* si = std::get_if<Conditions>(&contact.statement);
  if (!si || !si->speed_sum_m_per_s) return std::nullopt;
  const double b = hertz::half_width_m(*si);
  return ResponseScales{.omega_per_Omega = *si->speed_sum_m_per_s / 2 / b,
                        .reduced_modulus_Pa = si->reduced_modulus_Pa,
                        .half_width_m = b};
}

}  // namespace

std::optional<double> ResponseRun::frequency_Hz(double Omega) const {
  if (!scales) return std::nullopt;
  return Omega * scales->omega_per_Omega / (2 * pi);
}

std::optional<DynamicStiffness> ResponseRun::dynamic_stiffness(const Stiffness& at) const {
  if (!scales || at.status == StopReason::diverged) return std::nullopt;
  const double E = scales->reduced_modulus_Pa;
  const double datum = datum_m ? 4 / (pi * E) * std::log(*datum_m / scales->half_width_m) : 0;
  const std::complex<double> stiffness = 1.0 / (4.0 / (E * at.kappa) + datum);
  DynamicStiffness found{.stiffness_N_per_m2 = stiffness.real()};
  if (at.Omega > 0) found.damping_N_s_per_m2 = stiffness.imag() / (at.Omega * scales->omega_per_Omega);
  return found;
}

ResponseRun run_response(const Case& contact_case, const ResponseQuestion& question) {
  const auto& contact = std::get<ContactCase>(contact_case.body);
  if (contact.dry())
    throw case_error(contact_case, "lubricant",
                     "is missing: a dry contact has no film that could respond; allowed is a contact with a film");
  ResponseRun run{.case_id = contact_case.id, .version = contact_case.version};
  run.scales = response_scales_of(contact);
  run.datum_m = question.datum_m;
  if (!run.scales && (question.datum_m || !question.frequencies_Hz.empty()))
    throw case_error(contact_case, "",
                     "states no speed in m/s; --frequency and --x0-m need a contact in SI, allowed is --omega");
  const Nondimensional reading = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet);
  run.groups = reading.problem.groups;
  const RegisteredSolver& solver = question.solver ? *question.solver : default_solver();
  run.solver = solver.name;
  ResponseRequest request = question.request;
  for (const double f : question.frequencies_Hz)
    request.frequencies.push_back(2 * pi * f / run.scales->omega_per_Omega);
  run.response = solver.respond(reading.problem, request);
  run.notes = reading.notes;
  if (contact.oil) run.notes = notes_of(*contact.oil, run.notes);
  run.notes.insert(run.notes.end(), run.response.notes.begin(), run.response.notes.end());
  return run;
}

}  // namespace ehd
