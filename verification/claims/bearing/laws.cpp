// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11: the force laws. Force and approach are inverse, slopes are derivatives, and the load of a ring is the
// gradient of the energy stored in its contacts.
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "verification/claims/bearing/by_hand.hpp"
#include "verification/claims/bearing/parts.hpp"
#include "verification/claims/bearing/rings.hpp"

namespace ehd::verification::bearing_parts {

using std::numbers::pi;

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// The energy stored in the contacts of a displaced ring with balanced rollers, less the work of the centrifugal force.
/// The law of a film stores infinite energy down to zero force. Its energy is counted from the roller's forces in
/// `from`, one step away.
double energy_J(const bearing::Geometry& geometry, const bearing::LawPair& laws, double centrifugal_N, double along_m,
                double across_m, const std::vector<bearing::RollerState>& from) {
  const auto stored = [](const bearing::ForceLaw& law, const bearing::ContactState& at,
                         const bearing::ContactState& began) {
    if (at.force_N <= 0) return 0.0;
    if (std::holds_alternative<bearing::PowerLaw>(law)) return 9.0 / 19 * at.force_N * at.approach_m;
    if (const auto* film =
            std::get_if<bearing::CurveLaw>(&law)) {  // Int f d(delta) = [f delta] - Int delta df, by Simpson
      const double by_N = at.force_N - began.force_N, middle_m = film->approach(began.force_N + by_N / 2);
      return at.force_N * at.approach_m - began.force_N * began.approach_m -
             by_N / 6 * (began.approach_m + 4 * middle_m + at.approach_m);
    }
    const auto& line = std::get<bearing::LinearLaw>(law);
    return at.force_N * at.force_N / (2 * line.K_N_per_m);
  };
  double energy = 0;
  for (int j = 0; j < geometry.rollers; ++j) {
    const double psi = (geometry.first_azimuth_deg + 360.0 * j / geometry.rollers) * pi / 180;
    const auto roller = bearing::balance_roller(
        laws, centrifugal_N, along_m * std::cos(psi) + across_m * std::sin(psi) - geometry.clearance_m / 2);
    const auto& began = from[static_cast<std::size_t>(j)];
    energy += stored(laws.inner, roller.inner, began.inner) + stored(laws.outer, roller.outer, began.outer) -
              centrifugal_N * roller.outer.approach_m;
  }
  return energy;
}

}  // namespace

void add_energy(Findings& found, const std::string& name, const bearing::Geometry& geometry,
                const bearing::LawPair& laws, double centrifugal_N, double radial_N) {
  const auto balanced = bearing::balance(geometry, laws, {.radial_N = radial_N, .centrifugal_N = centrifugal_N});
  double along = nothing, across = nothing;
  if (const auto* ring = std::get_if<bearing::Equilibrium>(&balanced)) {
    const double x = ring->displacement_m, y = ring->lateral_displacement_m, h = 1e-5 * x;
    const auto slope = [&](double to_x, double to_y) {
      const auto E = [&](double steps) {
        return energy_J(geometry, laws, centrifugal_N, x + steps * h * to_x, y + steps * h * to_y, ring->rollers);
      };
      return (8 * (E(1) - E(-1)) - (E(2) - E(-2))) / (12 * h);
    };
    along = slope(1, 0);
    across = slope(0, 1);
  }
  // Fourth differences at 1e-5: nothing of the fifth derivative's part, eps/1e-5 of rounding; at the edge of the load
  // zone a roller's energy has a second derivative that jumps, and no roller is within 2e-5 of the displacement from
  // it.
  const Tolerance differences = Tolerance::discretisation(1e-7, 10);
  found.claims.push_back(claim_value(
      sentence("energy/" + name, "the radial load is the gradient of the energy stored in the contacts, law " + name),
      along, radial_N, 0, differences));
  found.claims.push_back(
      claim(sentence("energy/" + name + "/across",
                     "under a cage that is not symmetric the energy is least across the load, law " + name),
            std::abs(across) / radial_N, 0, differences));
}

Findings judge_energy() {
  const bearing::Geometry geometry{.rollers = 17,
                                   .pitch_diameter_m = 0.061,
                                   .roller_diameter_m = 0.0083,
                                   .length_m = 0.011,
                                   .clearance_m = 7e-6,
                                   .density_kg_per_m3 = 7810,
                                   .first_azimuth_deg = 4.3};
  constexpr double centrifugal_N = 31, radial_N = 8.7e3;
  const bearing::PowerLaw power = bearing::palmgren_law(geometry.length_m);
  const bearing::LinearLaw inner{.K_N_per_m = 3.3e8, .dF_N = 410}, outer{.K_N_per_m = 2.7e8, .dF_N = 530};
  Findings found;
  for (const auto& [name, pair] : {std::pair<std::string, bearing::LawPair>{"hertz", {power, power}},
                                   std::pair<std::string, bearing::LawPair>{"ehd-linear", {inner, outer}}})
    add_energy(found, name, geometry, pair, centrifugal_N, radial_N);
  return found;
}

/// Nine decades of force, to 4 GPa; of a film's law as far as it has solved contacts.
void add_law(Findings& found, const std::string& name, const bearing::LawPair& laws) {
  double slope_error = 0, inverse_error = 0;
  int forces = 0;
  const bool film = std::holds_alternative<bearing::CurveLaw>(laws.inner);
  for (const bearing::ForceLaw* one : {&laws.inner, &laws.outer})
    for (double f = 1e-4; f < 1e5; f *= 3.1) {
      if (std::holds_alternative<bearing::LinearLaw>(*one) && f < 1) continue;  // lost beside dF
      const auto* curve = std::get_if<bearing::CurveLaw>(one);
      if (curve && 1.01 * f > curve->curve().heaviest_N()) continue;
      const double delta = bearing::approach(*one, f), step = 1e-4 * f, shift = 1e-4 * f * bearing::compliance(*one, f);
      const double compliance = (bearing::approach(*one, f + step) - bearing::approach(*one, f - step)) / (2 * step);
      const double stiffness =
          (bearing::force(*one, delta + shift) - bearing::force(*one, delta - shift)) / (2 * shift);
      slope_error = worse(slope_error, std::abs(bearing::compliance(*one, f) / compliance - 1),
                          std::abs(bearing::stiffness(*one, delta) / stiffness - 1));
      inverse_error = worse(inverse_error, std::abs(bearing::force(*one, delta) / f - 1));
      ++forces;
    }
  const std::string about = std::to_string(forces) + " forces";
  // delta = -C/f of a light film has differences that are off by (step/f)^2, and a curve that bends by a few times
  // that.
  found.claims.push_back(claim(sentence("laws/" + name + "/slopes", "the slopes of the law " + name +
                                                                        " are those of its force and of its approach"),
                               slope_error, 0, Tolerance::discretisation(1e-8, film ? 10 : 1),
                               about + ", central differences of 1e-4"));
  found.claims.push_back(claim(
      sentence("laws/" + name + "/inverse", "the law " + name + " gives back the force that its approach came from"),
      inverse_error, 0, Tolerance::round_off(film ? 20 : 2, name == "ehd-linear" ? 1e3 : 50),
      about + (film
                   ? "; twenty operations behind a film and an approach, whose difference loses less than fifty of them"
                   : "; the logarithm of f over its coefficient is below 50, dF over f below 1000")));
}

Findings judge_dry_laws() {
  Findings found;
  for (const bearing::Law law : printed_laws)
    add_law(found, std::string(to_string(law)), dry_laws(law, some_contact()));
  add_law(found, "ehd-linear",
          {bearing::LinearLaw{.K_N_per_m = 3.3e8, .dF_N = 410}, bearing::LinearLaw{.K_N_per_m = 2.7e8, .dF_N = -90}});
  return found;
}

}  // namespace ehd::verification::bearing_parts
