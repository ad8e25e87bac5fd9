// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "contact/hertz.hpp"
#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "workflow/registry.hpp"

namespace ehd {

namespace {

/// Errors that a curve takes from the default solver; a bearing states about as much, and 2 % of its damping is allowed
/// (bearing_dynamics.cpp). That solver is asked for half, because finer grids follow only where a number misses what
/// was asked for. If a lag is not known well enough then, the solver is asked again, at these parts of the tolerance.
/// At a frequency two asks may end on the same grid, and the certified solver takes a hundred times as long.
constexpr double accepted = 1e-2, first_asked = 5e-3;
constexpr std::array asked_parts{1.0, 0.25, 0.02};
/// Where the certified solver is needed, the contact is heavy, and a looser tolerance saves it half of its time at
/// most.
constexpr double certified_tolerance = 1e-6;
/// The least compliance of a contact with the datum l: rollers are longer than exp(pi) = 23 half widths.
constexpr double least_compliance = 1;

/// kappa at a frequency that no grid resolves. The certified solver resolves no higher ones.
bool is_beyond_grids(const Stiffness& at) {
  return at.status == StopReason::tolerance_not_met && !std::isfinite(at.error);
}

/// Errors count in the compliance with the datum l, and in the lag as the curve measures it.
bool accepted_of(const Response& response, double M) {
  const auto known = [M](double chi, double chi_error, double lag, double lag_error) {
    return std::abs(chi) * chi_error <= accepted * std::max(std::abs(chi), least_compliance) &&
           std::abs(lag) * lag_error <= accepted * std::hypot(lag, bearing::lag_scale(M));
  };
  const auto& slow = response.slow;
  return slow && known(1 / slow->kappa_0, slow->error_0, slow->lag, slow->lag_error) &&
         std::ranges::all_of(response.frequencies, [&](const Stiffness& at) {
           return is_beyond_grids(at) || (at.status != StopReason::diverged &&
                                          known(1 / std::abs(at.kappa), at.error, at.lag(), at.lag_error));
         });
}

bool known(const Stiffness& at) { return at.status != StopReason::diverged && std::isfinite(at.error); }

}  // namespace

ContactResponder bearing_responder() {
  return [](const Problem& problem, const ResponseRequest& request) {
    for (const double part : asked_parts) {
      ResponseRequest closer = request;
      closer.tolerance *= part;
      Response found = default_solver().respond(problem, closer);
      if (accepted_of(found, problem.groups.M) || found.status == StopReason::limit_reached) return found;
    }
    ResponseRequest certified = request;
    certified.tolerance = certified_tolerance;
    return certified_solver().respond(problem, certified);
  };
}

ResponseRequest bearing_response_request() {
  ResponseRequest request;
  request.tolerance = first_asked;
  request.seeks_highest = false;
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
  bearing::SolvedResponse solved{.slow = in_series(*response.slow, datum)};
  for (const Stiffness& at : response.frequencies) {
    if (!known(at) && !is_beyond_grids(at))
      return failed(fmt::format("no kappa at Omega = {}: {}", plain(at.Omega, 4), response.reason));
    solved.at.push_back(known(at) ? in_series(at, datum) : bearing::unknown_at(solved.slow));
  }
  return solved;
}

}  // namespace ehd
