// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_plan.hpp"

#include <algorithm>

#include "workflow/bearing_of_case.hpp"

namespace ehd {

namespace {

bool contains(const std::vector<bearing::Law>& laws, bearing::Law law) {
  return std::find(laws.begin(), laws.end(), law) != laws.end();
}

}  // namespace

std::string bearing_stage::balance(bearing::Law law) { return "balance: " + std::string(to_string(law)); }
std::string bearing_stage::film(bearing::Law law) { return "film at each roller: " + std::string(to_string(law)); }

Plan plan_bearing(const BearingCase& body, const std::vector<bearing::Law>& asked, bearing::Form form,
                  int cage_positions) {
  Plan plan;
  const auto decide = [&plan](std::string_view stage, const std::string& why_skipped = "") {
    if (why_skipped.empty()) {
      plan.run.emplace_back(stage);
    } else {
      plan.skipped.push_back({std::string(stage), why_skipped});
    }
  };
  const std::string no_film = !body.lubricant ? "the case has no lubricant"
                              : at_rest(body) ? "the rings do not move against each other: no film"
                                              : "";
  const bool linear = no_film.empty() && contains(asked, bearing::Law::ehd_linear);
  const bool full = no_film.empty() && contains(asked, bearing::Law::ehd);
  const bool film = linear || full;
  const std::string why_no_film = !no_film.empty() ? no_film : "no law with a film is asked for";

  decide(bearing_stage::geometry);
  const auto azimuths = bearing::azimuths_deg(geometry_of(body));
  const auto cages = bearing::mirror_groups(azimuths);
  const int mirrored = body.geometry.rollers - static_cast<int>(cages.size());
  if (mirrored > 0)
    decide("balance of mirrored rollers", std::to_string(mirrored) + " of " + std::to_string(body.geometry.rollers) +
                                              " rollers mirror another and carry the same");
  decide(bearing_stage::across, form == bearing::Form::radial ? "the radial form is asked for"
                                : bearing::symmetric_to_load(azimuths)
                                    ? "the cage stands symmetric to the load, and so does the ring"
                                    : "");
  decide(bearing_stage::cage, cage_positions > 0 ? "" : "not asked for (--cage-positions N)");
  decide(bearing_stage::dry, !film                                              ? why_no_film
                             : full || datum_from_dry(body) || !body.fit.load_N ? ""
                                                                                : "datum and fit range are stated");
  decide(bearing_stage::datum, film ? "" : why_no_film);
  decide(bearing_stage::solves, film ? "" : why_no_film);
  if (film) {
    decide("second solve of an equal contact",
           "a load already solved at a raceway is taken from memory, by every law, clearance and case");
    decide("quantities beside film.minimum, film.central and film.offset", "not asked for: the laws need no others");
  }
  decide(bearing_stage::fit, linear ? "" : film ? "ehd-linear is not asked for" : why_no_film);
  decide(bearing_stage::curve, film ? "" : why_no_film);
  for (const bearing::Law law : bearing::laws_of(bearing::Laws::all)) {
    const bool possible = !needs_film(law) || no_film.empty();
    const bool no_ring = needs_ring_thickness(law) && !body.geometry.ring_thickness_m;
    decide(bearing_stage::balance(law), !contains(asked, law) ? "not asked for"
                                        : !possible           ? no_film
                                        : no_ring             ? "bearing.ring_thickness_m is not stated"
                                                              : "");
    if (!contains(asked, law)) continue;
    decide(bearing_stage::film(law), !needs_film(law) ? "a dry law has no film" : possible ? "" : no_film);
  }
  decide(bearing_stage::variant, linear ? "" : film ? "ehd-linear is not asked for" : why_no_film);
  decide(bearing_stage::lambda, !film                        ? why_no_film
                                : !body.geometry.roughness_m ? "bearing.roughness_m is not stated"
                                                             : "");
  return plan;
}

}  // namespace ehd
