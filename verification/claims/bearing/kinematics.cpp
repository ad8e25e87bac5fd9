// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11: radii, speeds and centrifugal forces, and the contacts that a bearing asks a solver for.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "bearing/geometry.hpp"
#include "verification/claims/bearing/by_hand.hpp"
#include "verification/claims/bearing/parts.hpp"
#include "verification/solution_memory.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification::bearing_parts {

using std::numbers::pi;

/// The groups of each contact that a bearing solves. The solver of its memory records them.
Findings judge_contacts_asked(const Case& bearing_case) {
  const auto& body = std::get<BearingCase>(bearing_case.body);
  std::vector<MoesGroups> asked;
  ContactMemory memory([&](const Problem& problem, const Request& request) {
    asked.push_back({problem.groups.M, problem.groups.L});
    return remembered(default_solver().name).solve(problem, request);
  });
  const auto results = run_bearing(bearing_case, {.laws = {bearing::Law::ehd_linear}, .films = false}, memory);
  std::vector<MoesGroups> expected;
  const auto [lowest, highest] = body.fit.load_N.value_or(std::pair(nothing, nothing));
  for (const bool inner : {true, false}) {
    const ByHand contact = by_hand(body, inner);
    const double U =
        body.lubricant->viscosity_Pa_s * contact.sum_speed_m_per_s / (contact.modulus_Pa * contact.radius_m);
    for (int i = 0; i < body.fit.points; ++i) {
      const double force = lowest + (highest - lowest) * i / (body.fit.points - 1);
      expected.push_back(
          {force / contact.length_m / (contact.modulus_Pa * contact.radius_m) / std::sqrt(U),
           body.lubricant->lubricant.alpha_per_Pa.value_or(nothing) * contact.modulus_Pa * std::sqrt(std::sqrt(U))});
    }
  }
  // Each expected contact is among the solved ones, in any order.
  double worst = asked.size() == expected.size() ? 0 : nothing;
  for (const MoesGroups& wanted : expected) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const MoesGroups& one : asked)
      nearest = std::min(nearest, worse(std::abs(one.M / wanted.M - 1), std::abs(one.L / wanted.L - 1)));
    worst = worse(worst, nearest);
  }
  Findings found;
  found.claims.push_back(
      claim(sentence("kinematics/" + bearing_case.id + "/contacts",
                     bearing_case.id + ": the contacts solved for the fit have the M and L of both raceways, "
                                       "equally spaced in force"),
            worst, 0, rounding(), fmt::format("{} contacts", asked.size())));
  return found;
}

Findings judge_kinematics(const Case& na4908) {
  const auto& body = std::get<BearingCase>(na4908.body);
  Findings found;
  const auto add = [&](const std::string& id, const std::string& statement, double value, double expected) {
    found.claims.push_back(claim_value(sentence("kinematics/" + id, statement), value, expected, 0, rounding()));
  };
  const auto printed = [&](const std::string& id, const std::string& statement, double value,
                           const std::string& digits) {
    found.claims.push_back(claim_value(sentence("kinematics/" + id, statement + " " + digits), value, std::stod(digits),
                                       0, Tolerance::published_digits(digits)));
  };
  const bearing::Geometry& geometry = body.geometry;
  printed("na4908/inner-radius", "the inner contacts of NA4908 have R [mm] =",
          1e3 * bearing::reduced_radius_m(geometry, bearing::Raceway::inner), "2.264");
  printed("na4908/outer-radius", "the outer contacts of NA4908 have R [mm] =",
          1e3 * bearing::reduced_radius_m(geometry, bearing::Raceway::outer), "2.736");
  printed("na4908/speed", "the surfaces in NA4908's contacts have the sum speed [m/s]",
          bearing::sum_speed_m_per_s(geometry, bearing::speeds_from_rpm(5000, 0)), "13.75");
  const struct {
    const char* name;
    double inner_rpm, outer_rpm;
  } turns[] = {{"inner", 5000, 0}, {"outer", 0, 3100}, {"both", 4200, 1300}, {"against", 2100, -900}};
  for (const auto& turn : turns) {
    BearingCase turned = body;
    turned.operation.inner_speed_rpm = turn.inner_rpm;
    turned.operation.outer_speed_rpm = turn.outer_rpm;
    const auto speeds = bearing::speeds_from_rpm(turn.inner_rpm, turn.outer_rpm);
    const std::string ring = turn.name, who = ring == "both"      ? "both rings turning"
                                              : ring == "against" ? "rings turning against each other"
                                                                  : "the " + ring + " ring turning";
    for (const bool inner : {true, false})
      add(fmt::format("{}/{}/speed", ring, raceway_name(inner)),
          fmt::format("rolling without slip gives the sum speed at the {} raceway, {}", raceway_name(inner), who),
          bearing::sum_speed_m_per_s(geometry, speeds), by_hand(turned, inner).sum_speed_m_per_s);
    const double cage =
        (turn.inner_rpm * 48 + turn.outer_rpm * 58) / 106 * pi / 30;  // r_i : r_o = 48 : 58, d_m = 53 mm
    add(ring + "/cage", "the cage goes as the rollers' centres, " + who,
        bearing::cage_speed_rad_per_s(geometry, speeds), cage);
    const double mass = 7850 * pi / 4 * 0.005 * 0.005 * 0.122;
    add(ring + "/centrifugal", "a roller's mass and the cage's speed make the centrifugal force, " + who,
        bearing::centrifugal_force_N(geometry, speeds), mass * 0.053 / 2 * cage * cage);
  }
  return found;
}

}  // namespace ehd::verification::bearing_parts
