// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/response_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <variant>

#include "contact/hertz.hpp"
#include "contact/text.hpp"

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

double ResponseRun::datum_compliance() const { return datum_m ? std::log(*datum_m / scales->half_width_m) / pi : 0; }

/// E'/4 is the unit of kappa, and b/u_m that of time.
DynamicStiffness ResponseRun::in_SI(const Kappa& kappa) const {
  const double stiffness = scales->reduced_modulus_Pa / 4, damping = stiffness / scales->omega_per_Omega;
  return {.stiffness_N_per_m2 = stiffness * kappa.stiffness,
          .damping_N_s_per_m2 = damping * kappa.damping,
          .stiffness_error = stiffness * kappa.stiffness_error,
          .damping_error = damping * kappa.damping_error};
}

std::optional<DynamicStiffness> ResponseRun::dynamic_stiffness(const Stiffness& at) const {
  if (!scales || at.status == StopReason::diverged || !std::isfinite(at.error)) return std::nullopt;
  if (at.Omega == 0) return at_rest();
  return in_SI(in_series(at, datum_compliance()));
}

std::optional<DynamicStiffness> ResponseRun::at_rest() const {
  if (!scales || !response.slow || !std::isfinite(response.slow->error_0)) return std::nullopt;
  return in_SI(in_series(*response.slow, datum_compliance()));
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
  run.hertz = reading.scales;
  run.oil = contact.oil;
  const RegisteredSolver& solver = question.solver ? *question.solver : default_solver();
  run.solver = solver.name;
  ResponseRequest request = question.request;
  for (const double f : question.frequencies_Hz)
    request.frequencies.push_back(2 * pi * f / run.scales->omega_per_Omega);
  run.response = solver.respond(reading.problem, request);
  run.notes = reading.notes;
  if (contact.oil) run.notes = notes_of(*contact.oil, run.notes);
  run.notes.insert(run.notes.end(), run.response.notes.begin(), run.response.notes.end());
  if (run.datum_m && *run.datum_m < run.scales->half_width_m)
    run.notes.push_back(fmt::format(
        "x_0 = {} m lies inside the contact, whose half width is {} m: with this datum stiffness and damping in SI may "
        "be negative, and say nothing about the film",
        plain(*run.datum_m), plain(run.scales->half_width_m, 3)));
  return run;
}

}  // namespace ehd
