// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11: the ring that moves along and across the load: its stiffness, the full relation in it, and its agreement
// with the radial form.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "verification/claims/bearing/by_hand.hpp"
#include "verification/claims/bearing/parts.hpp"
#include "verification/claims/bearing/rings.hpp"
#include "verification/solution_memory.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification::bearing_parts {

using std::numbers::pi;

namespace {

/// Sum f (cos, sin) of a ring at a given displacement, from its rollers.
std::pair<double, double> ring_force_N(const bearing::Geometry& geometry, const bearing::LawPair& laws,
                                       double centrifugal_N, double along_m, double across_m) {
  std::pair<double, double> sum{0, 0};
  for (const auto& [psi, roller] : rollers_at(geometry, laws, centrifugal_N, along_m, across_m)) {
    sum.first += roller.inner.force_N * std::cos(psi);
    sum.second += roller.inner.force_N * std::sin(psi);
  }
  return sum;
}

/// The stiffness of a bearing, compared with differences of its rollers' forces and of other balances.
void add_stiffness(Findings& found, const std::string& name, const bearing::Geometry& geometry,
                   const bearing::LawPair& laws, double centrifugal_N, double radial_N) {
  const auto ring_of = [&](const bearing::Geometry& of, double load_N) -> std::optional<bearing::Equilibrium> {
    const auto result = bearing::balance(of, laws, {.radial_N = load_N, .centrifugal_N = centrifugal_N});
    const auto* ring = std::get_if<bearing::Equilibrium>(&result);
    return ring ? std::optional(*ring) : std::nullopt;
  };
  double forces_error = nothing, balances_error = nothing, reciprocity = nothing;
  if (const auto ring = ring_of(geometry, radial_N)) {
    const auto& K = ring->stiffness_N_per_m;
    const double x = ring->displacement_m, y = ring->lateral_displacement_m, h = 1e-5 * x;
    const auto slope = [&](double to_x, double to_y) {
      const auto more = ring_force_N(geometry, laws, centrifugal_N, x + h * to_x, y + h * to_y),
                 less = ring_force_N(geometry, laws, centrifugal_N, x - h * to_x, y - h * to_y);
      return std::pair{(more.first - less.first) / (2 * h), (more.second - less.second) / (2 * h)};
    };
    const auto along = slope(1, 0), across = slope(0, 1);
    forces_error = worse(worse(std::abs(along.first - K[0][0]), std::abs(along.second - K[1][0])),
                         worse(std::abs(across.first - K[0][1]), std::abs(across.second - K[1][1]))) /
                   K[0][0];
    // The inverse, by other balances: the load changed by 1e-5 along, and by as much across. A load with a part across
    // is a load along a cage that is turned back.
    constexpr double part = 1e-5;
    const auto more = ring_of(geometry, radial_N * (1 + part)), less = ring_of(geometry, radial_N * (1 - part));
    const auto with_lateral = [&](double part_across) {
      const double angle = std::atan(part_across);
      bearing::Geometry turned = geometry;
      turned.first_azimuth_deg -= angle * 180 / pi;
      const auto seen = ring_of(turned, radial_N / std::cos(angle));
      return seen ? seen->displacement_m * std::cos(angle) - seen->lateral_displacement_m * std::sin(angle) : nothing;
    };
    if (more && less) {
      const double determinant = K[0][0] * K[1][1] - K[0][1] * K[0][1], unit = K[1][1] / determinant,
                   load = 2 * part * radial_N;
      const double gives_along = (more->displacement_m - less->displacement_m) / load,
                   gives_across = (more->lateral_displacement_m - less->lateral_displacement_m) / load;
      balances_error =
          worse(std::abs(gives_along - K[1][1] / determinant), std::abs(gives_across + K[0][1] / determinant)) / unit;
      reciprocity = std::abs((with_lateral(part) - with_lateral(-part)) / load - gives_across) / unit;
    }
  }
  // (h/x)^2 times a third derivative of order a thousand, which a roller near the edge of the load zone has.
  const Tolerance differences = Tolerance::discretisation(1e-10, 1e3);
  const std::string of = ", law " + name;
  found.claims.push_back(
      claim(sentence("stiffness/" + name + "/forces",
                     "the stiffness of the bearing is the derivative of the rollers' forces along and across" + of),
            forces_error, 0, differences));
  found.claims.push_back(claim(
      sentence("stiffness/" + name + "/balances", "its inverse is how other balances give way, along and across" + of),
      balances_error, 0, differences));
  found.claims.push_back(claim(sentence("stiffness/" + name + "/reciprocal",
                                        "a load across moves the ring along as a load along moves it across" + of),
                               reciprocity, 0, differences));
}

}  // namespace

Findings judge_plane() {
  const bearing::RollerContact contact = some_contact();
  const bearing::Geometry geometry{.rollers = 9,
                                   .pitch_diameter_m = contact.pitch_diameter_m,
                                   .roller_diameter_m = contact.roller_diameter_m,
                                   .length_m = contact.length_m,
                                   .clearance_m = 6e-6,
                                   .density_kg_per_m3 = 7790,
                                   .first_azimuth_deg = 8.3};
  Findings found;
  for (const bearing::Law law : bearing::laws_of(bearing::Laws::dry))
    add_stiffness(found, std::string(to_string(law)), geometry, dry_laws(law, contact), 57, 7.7e3);
  return found;
}

/// Energy, slopes and stiffness of the full relation, under a cage that is not symmetric.
Findings judge_full_relation(const Case& bearing_case, ContactMemory& memory) {
  const auto& body = std::get<BearingCase>(bearing_case.body);
  const auto results = run_bearing(bearing_case, {.laws = {bearing::Law::ehd}, .explicitly = true}, memory);
  const auto laws = results.size() == 1 ? laws_of(body, results[0]) : std::nullopt;
  Findings found;
  if (!laws) {
    found.claims.push_back(
        claim_fact(sentence("energy/ehd", "the full relation has a balance"), false, "a law to judge", "no balance"));
    return found;
  }
  bearing::Geometry geometry = body.geometry;
  geometry.first_azimuth_deg = 4.3;
  geometry.clearance_m = 7e-6;
  constexpr double centrifugal_N = 31, radial_N = 43e3;
  add_energy(found, "ehd", geometry, *laws, centrifugal_N, radial_N);
  add_law(found, "ehd", *laws);
  add_stiffness(found, "ehd", geometry, *laws, centrifugal_N, radial_N);
  return found;
}

/// Under a cage that is symmetric to the load, the ring moves along the load, and the form in two displacements takes
/// the radial form as a short cut. Turning the cage by 1e-9 degrees avoids the short cut.
Findings judge_forms(const Case& bearing_case) {
  constexpr double turned_deg = 1e-9;
  const auto& body = std::get<BearingCase>(bearing_case.body);
  ContactMemory memory(remembered(default_solver().name).solve);
  std::vector<bearing::Law> possible;
  for (const bearing::Law law : bearing::laws_of(bearing::Laws::all))
    if (plan_bearing(body, {law}).runs(bearing_stage::balance(law))) possible.push_back(law);
  Findings found;
  for (const BearingResult& result :
       run_bearing(bearing_case, {.laws = possible, .explicitly = true, .films = false}, memory)) {
    const auto laws = laws_of(body, result);
    double worst = laws ? 0 : nothing, bound = 0;
    for (const double of_pitch : {0.0, 0.5}) {
      if (!laws) break;
      bearing::Geometry geometry = body.geometry;
      geometry.first_azimuth_deg = of_pitch * 360 / geometry.rollers;
      const bearing::Loading loading{
          .radial_N = body.operation.radial_load_N,
          .centrifugal_N = bearing::centrifugal_force_N(
              geometry, bearing::speeds_from_rpm(body.operation.inner_speed_rpm, body.operation.outer_speed_rpm))};
      const auto along = bearing::balance(geometry, *laws, loading, bearing::Form::radial);
      bearing::Geometry turned = geometry;
      turned.first_azimuth_deg += turned_deg;
      const auto plane = bearing::balance(turned, *laws, loading, bearing::Form::plane);
      const auto* const one = std::get_if<bearing::Equilibrium>(&along);
      const auto* const other = std::get_if<bearing::Equilibrium>(&plane);
      // The short cut balances mirrored rollers once; in the plane every roller is a group of its own.
      if (!one || !other || other->groups != geometry.rollers || one->groups == geometry.rollers) {
        worst = nothing;
        break;
      }
      double sum_N = 0;
      for (const auto& roller : one->rollers) sum_N += roller.inner.force_N;
      const double scale_N = std::max(loading.radial_N, sum_N), x = one->displacement_m;
      worst = worse(worst, std::abs(other->displacement_m / x - 1), std::abs(other->lateral_displacement_m / x));
      for (std::size_t j = 0; j < one->rollers.size(); ++j)
        worst = worse(worst, std::abs(other->rollers[j].inner.force_N - one->rollers[j].inner.force_N) / scale_N,
                      std::abs(other->rollers[j].outer.force_N - one->rollers[j].outer.force_N) / scale_N);
      // A turn by t moves a roller by t x, which pushes the ring by K t x at most. A balance with its largest error
      // moves the ring by that error over K.
      const auto& K = one->stiffness_N_per_m;
      const double stiffest = K[0][0] + K[1][1], softest = std::min(K[0][0], K[1][1]);
      const double turn = turned_deg * pi / 180,
                   from_balance = 2 * bearing::largest_balance_error * scale_N / (softest * x);
      bound = worse(bound, turn * worse(stiffest / softest, stiffest * x / scale_N) +
                               from_balance * worse(1, stiffest * x / scale_N));
    }
    const std::string name(to_string(result.law));
    found.claims.push_back(claim(
        sentence(fmt::format("forms/{}/{}", bearing_case.id, name),
                 bearing_case.id + ": under a symmetric cage the form in two displacements gives the radial one, law " +
                     name),
        worst, 0, Tolerance::asymptotic(bound, "a cage turned by 1e-9 degrees, and twice what a balance promises"),
        "a roller under the load, and two beside it"));
  }
  return found;
}

}  // namespace ehd::verification::bearing_parts
