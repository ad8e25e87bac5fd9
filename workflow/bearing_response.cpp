// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_response.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "contact/hertz.hpp"
#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "workflow/registry.hpp"

namespace ehd {

namespace {

using bearing::Kappa;

/// With the datum l: 1/kappa_l = 1/kappa + `datum`, datum = ln(l/b)/pi; so d kappa_l = (kappa_l/kappa)^2 d kappa.
Kappa slow_kappa(const SlowStiffness& slow, double datum) {
  const double stiffness = 1 / (1 / slow.kappa_0 + datum), softer = stiffness / slow.kappa_0;
  const double damping = slow.kappa_1 * softer * softer;
  return {.stiffness = stiffness,
          .damping = damping,
          .stiffness_error = slow.error_0 * std::abs(slow.kappa_0) * softer * softer,
          .damping_error = (slow.error_1 + 2 * slow.error_0 * std::abs(1 - softer)) * std::abs(damping)};
}

Kappa kappa_of(const Stiffness& at, double datum) {
  const std::complex<double> kappa = 1.0 / (1.0 / at.kappa + datum);
  const double error = at.error * std::norm(kappa) / std::abs(at.kappa);
  return {.stiffness = kappa.real(),
          .damping = kappa.imag() / at.Omega,
          .stiffness_error = error,
          .damping_error = error / at.Omega};
}

bool known(const Stiffness& at) { return at.status != StopReason::diverged && std::isfinite(at.error); }

}  // namespace

ContactResponder bearing_responder() { return certified_solver().respond; }

ResponseRequest bearing_response_request() {
  ResponseRequest request;
  request.tolerance = 1e-6;
  return request;
}

bearing::ResponseResult respond_bearing_contact(const bearing::RacewayContact& contact, const Lubricant& lubricant,
                                                double load_N_per_m, const std::vector<double>& omegas,
                                                ResponseRequest request, const ContactResponder& respond) {
  const double force_N = load_N_per_m * contact.length_m;
  Nondimensional reading;
  try {
    reading = nondimensionalise(contact.at(force_N), lubricant, Flooded{});
  } catch (const StatementError& error) {
    return bearing::SolveFailure{.why = error.what()};
  }
  for (const double omega : omegas) request.frequencies.push_back(bearing::Omega_of(contact, force_N, omega));
  const Response response = respond(reading.problem, request);
  const Groups& groups = reading.problem.groups;
  const auto failed = [&](const std::string& why) {
    return bearing::SolveFailure{.why = fmt::format("M = {}, L = {}: {}", plain(groups.M, 4), plain(groups.L, 4), why),
                                 .limit = response.status == StopReason::limit_reached};
  };
  if (!response.slow || !std::isfinite(response.slow->error_0 + response.slow->error_1))
    return failed(fmt::format("{} ({})", to_string(response.status), response.reason));
  const double datum = std::log(contact.length_m / hertz::half_width_m(contact.at(force_N))) / std::numbers::pi;
  bearing::SolvedResponse solved{.slow = slow_kappa(*response.slow, datum)};
  for (const Stiffness& at : response.frequencies) {
    if (!known(at)) return failed(fmt::format("no kappa at Omega = {}: {}", plain(at.Omega, 4), response.reason));
    solved.at.push_back(kappa_of(at, datum));
  }
  return solved;
}

}  // namespace ehd
