// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/contact_memory.hpp"

#include <algorithm>
#include <utility>

namespace ehd {

namespace {

/// So many sets of forces are solved one by one; then a curve through all loads is as cheap (NA4908: 22 contacts a set,
/// 100 for the curve).
constexpr int sets_of_forces = 4;

/// The request; without its forces where a curve through all loads is known, or as cheap.
bearing::ResponseCurveRequest as_met(const auto& curves, const bearing::ResponseCurveRequest& request) {
  bearing::ResponseCurveRequest everywhere = request;
  everywhere.read_at_N.clear();
  if (curves.contains(everywhere)) return everywhere;
  if (curves.contains(request)) return request;
  const auto sets = std::ranges::count_if(curves, [&](const auto& known) {
    bearing::ResponseCurveRequest other = known.first;
    other.read_at_N.clear();
    return other == everywhere;
  });
  return sets < sets_of_forces ? request : everywhere;
}

}  // namespace

using bearing::FilmCurve;
using bearing::RacewayContact;
using bearing::SolvableContact;
using bearing::SolveFailure;

ContactMemory::ContactMemory(ContactSolver solver, Request request)
    : ContactMemory(std::make_shared<ContactCache>(with_fallback(std::move(solver))), request) {}

ContactMemory::ContactMemory(std::shared_ptr<ContactCache> cache, Request request)
    : cache_(std::move(cache)), request_(request) {}

ContactMemory::Key ContactMemory::key_of(const RacewayContact& contact, const Lubricant& lubricant) {
  // A member that is added to the lubricant does not compile here.
  const auto& [viscosity, density, alpha_per_Pa, z, p0_Pa] = lubricant;
  return {contact, viscosity, density, alpha_per_Pa, z, p0_Pa};
}

SolvableContact ContactMemory::of(const RacewayContact& contact, const Lubricant& lubricant) {
  Raceway& raceway = raceways_[key_of(contact, lubricant)];  // a map: the reference stays valid
  return {contact, [this, &raceway, contact, lubricant](double load_N_per_m) {
            ++(raceway.loads_N_per_m.insert(load_N_per_m).second ? solves_ : recalls_);
            return solve_bearing_contact(contact, lubricant, load_N_per_m, request_, *cache_);
          }};
}

const std::variant<FilmCurve, SolveFailure>& ContactMemory::curve(const RacewayContact& contact,
                                                                  const Lubricant& lubricant,
                                                                  const bearing::CurveRequest& request) {
  auto& curves = raceways_[key_of(contact, lubricant)].curves;
  const bearing::CurveRequest key = bearing::as_met(request);
  const auto known = curves.find(key);
  if (known == curves.end())
    return curves.emplace(key, bearing::build_curve(of(contact, lubricant), key)).first->second;
  if (const auto* curve = std::get_if<FilmCurve>(&known->second))
    recalls_ += static_cast<long>(curve->forces_N().size());
  return known->second;
}

void ContactMemory::respond_by(ContactResponder responder, ResponseRequest request) {
  responder_ = std::move(responder);
  response_request_ = std::move(request);
}

const std::variant<bearing::ResponseCurve, SolveFailure>& ContactMemory::response_curve(
    const RacewayContact& contact, const Lubricant& lubricant, const bearing::ResponseCurveRequest& request) {
  auto& curves = raceways_[key_of(contact, lubricant)].responses;
  const bearing::ResponseCurveRequest asked = as_met(curves, request);
  const auto known = curves.find(asked);
  if (known != curves.end()) return known->second;
  const bearing::RespondingContact contacts{contact, [&](double load_N_per_m, const std::vector<double>& omegas) {
                                              ++responses_;
                                              return respond_bearing_contact(contact, lubricant, load_N_per_m, omegas,
                                                                             response_request_, responder_);
                                            }};
  return curves.emplace(asked, bearing::build_response_curve(contacts, asked)).first->second;
}

}  // namespace ehd
