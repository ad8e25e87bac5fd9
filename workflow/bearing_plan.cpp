// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "workflow/bearing_of_case.hpp"

namespace ehd {

namespace {

bool contains(const std::vector<bearing::Law>& laws, bearing::Law law) {
  return std::find(laws.begin(), laws.end(), law) != laws.end();
}

/// Whether a law among these is made in this way.
template <class Maker>
bool any_made(const std::vector<bearing::Law>& laws) {
  return std::any_of(laws.begin(), laws.end(),
                     [](bearing::Law law) { return std::holds_alternative<Maker>(bearing::row_of(law).make); });
}

}  // namespace

std::string bearing_stage::balance(bearing::Law law) { return "balance: " + std::string(to_string(law)); }
std::string bearing_stage::film(bearing::Law law) { return "film at each roller: " + std::string(to_string(law)); }

Plan plan_bearing(const BearingCase& body, const std::vector<bearing::Law>& asked, bearing::Form form,
                  int cage_positions, bool dynamic) {
  Plan plan;
  const std::string no_film = !body.lubricant ? "the case has no lubricant"
                              : at_rest(body) ? "the rings do not move against each other: no film"
                                              : "";
  const bool linear = no_film.empty() && any_made<bearing::FromFits>(asked);
  const bool full = no_film.empty() && any_made<bearing::FromCurves>(asked);
  const bool film = linear || full;
  const std::string why_no_film = film ? "" : !no_film.empty() ? no_film : "no law with a film is asked for";
  const std::string why_no_fit =
      linear || !film ? why_no_film : bearing::names_of(bearing::Laws::from_fits) + " is not asked for";

  plan.decide(bearing_stage::geometry);
  const auto azimuths = bearing::azimuths_deg(body.geometry);
  const auto cages = bearing::mirror_groups(azimuths);
  const int mirrored = body.geometry.rollers - static_cast<int>(cages.size());
  if (mirrored > 0)
    plan.decide("balance of mirrored rollers",
                fmt::format("{} of {} rollers mirror another and carry the same", mirrored, body.geometry.rollers));
  plan.decide(bearing_stage::across, form == bearing::Form::radial ? "the radial form is asked for"
                                     : bearing::symmetric_to_load(azimuths)
                                         ? "the cage stands symmetric to the load, and so does the ring"
                                         : "");
  plan.decide(bearing_stage::cage, cage_positions > 0 ? "" : "not asked for (--cage-positions N)");
  plan.decide(bearing_stage::dry, !film ? why_no_film
                                  : full || datum_from_dry(body) || !body.fit.load_N
                                      ? ""
                                      : "datum and fit range are stated");
  plan.decide(bearing_stage::datum, why_no_film);
  plan.decide(bearing_stage::solves, why_no_film);
  if (film) {
    plan.decide("second solve of an equal contact",
                "a load already solved at a raceway is taken from memory, by every law, clearance and case");
    plan.decide("quantities beside film.minimum, film.central, film.offset and rolling_force",
                "not asked for: the laws need no others");
  }
  plan.decide(bearing_stage::fit, why_no_fit);
  plan.decide(bearing_stage::curve, why_no_film);
  for (const bearing::Law law : bearing::laws_of(bearing::Laws::all)) {
    const bool possible = !needs_film(law) || no_film.empty();
    const bool no_ring = needs_ring_thickness(law) && !body.ring_thickness_m;
    plan.decide(bearing_stage::balance(law), !contains(asked, law) ? "not asked for"
                                             : !possible           ? no_film
                                             : no_ring             ? "bearing.ring_thickness_m is not stated"
                                                                   : "");
    if (!contains(asked, law)) continue;
    plan.decide(bearing_stage::film(law), !needs_film(law) ? "a dry law has no film" : possible ? "" : no_film);
  }
  plan.decide(bearing_stage::variant, why_no_fit);
  plan.decide(bearing_stage::lambda, !film               ? why_no_film
                                     : !body.roughness_m ? "bearing.roughness_m is not stated"
                                                         : "");
  plan.decide(bearing_stage::torque, why_no_film);
  const std::string why_not_dynamic = dynamic ? "" : "not asked for (--dynamic)";
  plan.decide(bearing_stage::dynamics, why_not_dynamic);
  plan.decide(bearing_stage::response, !dynamic           ? why_not_dynamic
                                       : !no_film.empty() ? no_film
                                       : !full            ? "no law whose contacts follow a solved film is asked for"
                                                          : "");
  return plan;
}

}  // namespace ehd
