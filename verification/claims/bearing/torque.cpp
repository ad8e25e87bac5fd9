// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11: the rolling torque of a bearing, from the rolling forces of its contacts.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "contact/text.hpp"
#include "verification/claims/bearing/by_hand.hpp"
#include "verification/claims/bearing/parts.hpp"
#include "verification/exact/martin.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification::bearing_parts {

namespace {

/// Of the contacts of one raceway, by `reference` at the rollers' loads.
struct Powers {
  double surfaces_W = 0, dissipated_W = 0;  ///< all rollers: u_s l F_t, and what the flow dissipates
  double error = 0;                         ///< relative, of the dissipation at any roller
  double worst_contact = 0;                 ///< relative difference of the two at any roller
};

Powers powers_of(const BearingCase& body, const BearingResult& result, bool inner) {
  Powers all;
  const ByHand contact = by_hand(body, inner);
  for (const RollerRow& roller : result.rollers) {
    const SolvedByHand solved = solved_by_hand(body, inner, one_of(roller, inner).force_N);
    const double surfaces = contact.sum_speed_m_per_s * solved.rolling_force_N_per_m;
    all.surfaces_W += contact.length_m * surfaces;
    all.dissipated_W += contact.length_m * solved.dissipation_W_per_m;
    all.error = worse(all.error, solved.dissipation_error);
    all.worst_contact = worse(all.worst_contact, std::abs(solved.dissipation_W_per_m / surfaces - 1));
  }
  return all;
}

}  // namespace

Findings judge_torque(const Case& bearing_case, ContactMemory& memory) {
  const auto& body = std::get<BearingCase>(bearing_case.body);
  const auto results = run_bearing(bearing_case, {.laws = {bearing::Law::ehd}}, memory);
  const bool known = results.size() == 1 && results[0].torque && results[0].curve;
  Findings found;
  const std::string id = "torque/" + bearing_case.id;
  if (!known) {
    found.claims.push_back(claim_fact(sentence(id, "the bearing has a rolling torque"), false, "a balance with films"));
    return found;
  }
  const BearingResult& result = results[0];
  const Powers inner = powers_of(body, result, true), outer = powers_of(body, result, false);
  const double turn_rad_per_s =
      std::abs(body.operation.inner_speed_rpm - body.operation.outer_speed_rpm) * std::numbers::pi / 30;
  const double surfaces_W = inner.surfaces_W + outer.surfaces_W;
  found.claims.push_back(claim_value(
      sentence(id + "/contacts",
               "torque times the speed of the rings is u_s l F_t of all contacts, F_t by `reference` at the "
               "rollers' loads"),
      result.torque->torque_N_m * turn_rad_per_s, surfaces_W, 0, film_tolerance(),
      fmt::format("{} N m, {} W", plain(result.torque->torque_N_m, 6), plain(surfaces_W, 6))));
  found.claims.push_back(
      claim(sentence(id + "/stated", "the stated error of the torque covers that of its rolling forces"),
            std::abs(result.torque->torque_N_m * turn_rad_per_s / surfaces_W - 1) / result.torque->error, 0,
            Tolerance::stated(), "stated " + plain(result.torque->error, 2)));
  // Cells of two intervals err four times as much as cells of one: a third of the difference is the error.
  const double estimate = worse(inner.error, outer.error) / 3;
  found.claims.push_back(claim(
      sentence(id + "/energy",
               "the power that the surfaces give to each film is what its flow dissipates: compression costs no work "
               "(compressible oil)"),
      worse(inner.worst_contact, outer.worst_contact), 0, Tolerance::discretisation(estimate, 2),
      fmt::format("all contacts together {} of {} W", plain(inner.dissipated_W + outer.dissipated_W, 6),
                  plain(surfaces_W, 6))));
  for (const bool at_inner : {true, false}) {
    const ByHand contact = by_hand(body, at_inner);
    const bearing::FilmCurve& curve = one_of(*result.curve, at_inner);
    const double force_N = curve.lightest_N() / 100;
    const double martin =
        exact::Martin{}.rolling_force *
        std::sqrt(body.lubricant->viscosity_Pa_s * contact.sum_speed_m_per_s * force_N / contact.length_m);
    found.claims.push_back(
        claim(sentence(id + "/rigid/" + raceway_name(at_inner),
                       "far below its lightest contact the curve has the rolling force of a rigid cylinder, " +
                           raceway_name(at_inner) + " raceway"),
              std::abs(curve.rolling_force_N_per_m(force_N).value_or(nothing) / martin - 1), 0,
              Tolerance::asymptotic(1e-3, "5 % x 100^(-3/2), and twenty times that")));
  }
  return found;
}

}  // namespace ehd::verification::bearing_parts
