// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/contact_cache.hpp"

#include <algorithm>

#include "contact/approach.hpp"
#include "contact/hertz.hpp"
#include "contact/nondimensional.hpp"
#include "contact/text.hpp"

namespace ehd {

using bearing::FilmCurve;
using bearing::RacewayContact;
using bearing::SolvedContact;
using bearing::SolvedContacts;
using bearing::SolveFailure;

ContactMemory::ContactMemory(ContactSolver solver, Request request)
    : solver_(std::move(solver)), request_(std::move(request)) {}

Request ContactMemory::bearing_request() {
  Request request;
  request.tolerance = 1e-4;
  return request;
}

namespace {

bearing::ContactResult solve_contact(const RacewayContact& contact, const Lubricant& lubricant,
                                     const ContactSolver& solver, const Request& request, double load_N_per_m) {
  const Conditions conditions = contact.at(load_N_per_m * contact.length_m);
  Nondimensional reading;
  try {
    reading = nondimensionalise(conditions, lubricant, Flooded{});
  } catch (const StatementError& error) {
    return SolveFailure{.why = error.what()};
  }
  reading.problem.wanted = {Quantity::film_minimum, Quantity::film_central, Quantity::film_offset};
  // Asked for is a tenth of what a contact law needs of its points. Where that is not met, the need itself is asked
  // for: on finer and finer grids a spike that meets X = 0 only blurs what a coarser one knew.
  constexpr double needed = 1e-3;
  Solution solution = solver(reading.problem, request);
  if (solution.record.status == StopReason::tolerance_not_met && request.tolerance.value_or(needed) < needed) {
    Request less = request;
    less.tolerance = needed;
    if (Solution again = solver(reading.problem, less); again.record.status == StopReason::converged)
      solution = std::move(again);
  }
  const StopReason status = solution.record.status;
  const std::string groups =
      "M = " + plain(reading.problem.groups.M, 4) + ", L = " + plain(reading.problem.groups.L, 4) + ": ";
  if (status != StopReason::converged && status != StopReason::tolerance_not_met)
    return SolveFailure{.why = groups + std::string(to_string(status)) +
                               (solution.record.reason.empty() ? "" : " (" + solution.record.reason + ")"),
                        .limit = status == StopReason::limit_reached};
  const auto film = solution.observables.find(Quantity::film_minimum);
  const auto offset = solution.observables.find(Quantity::film_offset);
  if (film == solution.observables.end() || offset == solution.observables.end() || !offset->second.error ||
      !film->second.error)
    return SolveFailure{.why = groups + "the solver gives no film.minimum or film.offset with an error"};
  // A film that is a small part of the approach need not be known as well as one that is all of it: what it does to the
  // contact force counts too, against the dry approach with x_0 = l.
  constexpr double largest_offset_error =
      1e-2;  // more than a per cent of film, and of force, is no solution for a bearing
  const double force_N = load_N_per_m * contact.length_m, b = hertz::half_width_m(conditions);
  const double dry_offset = dry_approach_m(contact.at(force_N), contact.length_m) * contact.reduced_radius_m / (b * b);
  const double offset_film = offset->second.value - hertz::dry_offset();
  const auto known_to = [&](double share) {
    return *offset->second.error <= share * std::max(offset_film, dry_offset / 10);
  };
  if (!known_to(largest_offset_error))
    return SolveFailure{.why = groups + "the offset film is known to " + plain(*offset->second.error / offset_film, 2) +
                               " of itself only, and to more than " + plain(largest_offset_error) +
                               " of a tenth of the approach"};
  return SolvedContact{
      .offset = offset->second.value,
      .offset_error = *offset->second.error,
      .film_minimum_m = film->second.value * *reading.scales->film_m_per_hertz_film(),
      .film_error = *film->second.error,
      .converged = status == StopReason::converged || (*film->second.error <= needed && known_to(needed))};
}

}  // namespace

ContactMemory::Raceway& ContactMemory::raceway(const RacewayContact& contact, const Lubricant& lubricant) {
  const Key key{contact, lubricant.viscosity, lubricant.density, lubricant.alpha_per_Pa, lubricant.z, lubricant.p0_Pa};
  Raceway& raceway = raceways_[key];
  if (!raceway.contacts)
    raceway.contacts = std::make_unique<SolvedContacts>(
        contact, [contact, lubricant, solver = solver_, request = request_](double load_N_per_m) {
          return solve_contact(contact, lubricant, solver, request, load_N_per_m);
        });
  return raceway;
}

SolvedContacts& ContactMemory::of(const RacewayContact& contact, const Lubricant& lubricant) {
  return *raceway(contact, lubricant).contacts;
}

const std::variant<FilmCurve, SolveFailure>& ContactMemory::curve(const RacewayContact& contact,
                                                                  const Lubricant& lubricant,
                                                                  const bearing::CurveRequest& request) {
  Raceway& of = raceway(contact, lubricant);
  const bearing::CurveRequest key = bearing::as_met(request);
  const auto known = of.curves.find(key);
  if (known == of.curves.end()) return of.curves.emplace(key, bearing::build_curve(*of.contacts, key)).first->second;
  if (const auto* curve = std::get_if<FilmCurve>(&known->second))
    curve_recalls_ += static_cast<long>(curve->forces_N().size());
  return known->second;
}

long ContactMemory::solves() const {
  long sum = 0;
  for (const auto& raceway : raceways_) sum += raceway.second.contacts->solves();
  return sum;
}

long ContactMemory::recalls() const {
  long sum = curve_recalls_;
  for (const auto& raceway : raceways_) sum += raceway.second.contacts->recalls();
  return sum;
}

}  // namespace ehd
