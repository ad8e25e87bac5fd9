// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11: the force laws. Force and approach are inverse, slopes are derivatives, and the load of a ring is the
// gradient of the energy stored in its contacts.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "contact/overloaded.hpp"
#include "verification/claims/bearing/by_hand.hpp"
#include "verification/claims/bearing/parts.hpp"
#include "verification/claims/bearing/rings.hpp"

namespace ehd::verification::bearing_parts {

namespace {

/// Int f d(delta) of one contact. `ehd` stores infinite energy down to zero force, so that the energy of a law without
/// a closed form is counted from the state `began`, one step away.
double stored_J(const bearing::ForceLaw& law, const bearing::ContactState& at, const bearing::ContactState& began) {
  if (at.force_N <= 0) return 0;
  const auto from_began = [&](const auto& own) {  // [f delta] - Int delta df, by Simpson
    const double by_N = at.force_N - began.force_N, middle_m = own.approach(began.force_N + by_N / 2);
    return at.force_N * at.approach_m - began.force_N * began.approach_m -
           by_N / 6 * (began.approach_m + 4 * middle_m + at.approach_m);
  };
  return std::visit(
      Overloaded{[&](const bearing::PowerLaw&) { return 9.0 / 19 * at.force_N * at.approach_m; },  // of power 10/9
                 [&](const bearing::LinearLaw& line) { return at.force_N * at.force_N / (2 * line.K_N_per_m); },
                 [&](const bearing::LogarithmicLaw& own) { return from_began(own); },
                 [&](const bearing::CurveLaw& own) { return from_began(own); }},
      law);
}

/// The energy stored in the contacts of a displaced ring with balanced rollers, less the work of the centrifugal force.
double energy_J(const bearing::Geometry& geometry, const bearing::LawPair& laws, double centrifugal_N, double along_m,
                double across_m, const std::vector<bearing::RollerState>& from) {
  double energy = 0;
  auto began = from.begin();
  for (const auto& [psi, roller] : rollers_at(geometry, laws, centrifugal_N, along_m, across_m)) {
    energy += stored_J(laws.inner, roller.inner, began->inner) + stored_J(laws.outer, roller.outer, began->outer) -
              centrifugal_N * roller.outer.approach_m;
    ++began;
  }
  return energy;
}

/// Where and how sharply a law is compared with itself.
struct LawCheck {
  double lightest_N = 0, heaviest_N = std::numeric_limits<double>::infinity();
  double slope_safety = 1, operations = 2, condition = 50;
  const char* why = "the logarithm of f over its coefficient is below 50, dF over f below 1000";
};
LawCheck check_of(const bearing::ForceLaw& law) {
  return std::visit(
      Overloaded{[](const bearing::PowerLaw&) { return LawCheck{}; },
                 [](const bearing::LogarithmicLaw&) { return LawCheck{}; },
                 [](const bearing::LinearLaw&) {  // a light force is lost beside dF
                   return LawCheck{.lightest_N = 1, .condition = 1e3};
                 },
                 // delta = -C/f of a light film: differences err by (step/f)^2, and by a few times that for a curve.
                 [](const bearing::CurveLaw& film) {
                   return LawCheck{.heaviest_N = film.curve().heaviest_N(),
                                   .slope_safety = 10,
                                   .operations = 20,
                                   .why =
                                       "twenty operations behind a film and an approach, whose difference loses "
                                       "less than fifty of them"};
                 }},
      law);
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
  // Fourth-order differences at 1e-5: the fifth derivative adds nothing, rounding eps/1e-5. A roller's energy has a
  // jump in the second derivative at the edge of the load zone; no roller is within 2e-5 of the displacement from it.
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

void add_law(Findings& found, const std::string& name, const bearing::LawPair& laws) {
  double slope_error = 0, inverse_error = 0;
  int forces = 0;
  for (const bearing::ForceLaw* one : {&laws.inner, &laws.outer})
    for (double f = 1e-4; f < 1e5; f *= 3.1) {
      if (const LawCheck check = check_of(*one); f < check.lightest_N || 1.01 * f > check.heaviest_N) continue;
      const double delta = bearing::approach(*one, f), step = 1e-4 * f, shift = 1e-4 * f * bearing::compliance(*one, f);
      const double compliance = (bearing::approach(*one, f + step) - bearing::approach(*one, f - step)) / (2 * step);
      const double stiffness =
          (bearing::force(*one, delta + shift) - bearing::force(*one, delta - shift)) / (2 * shift);
      slope_error = worse(slope_error, std::abs(bearing::compliance(*one, f) / compliance - 1),
                          std::abs(bearing::stiffness(*one, delta) / stiffness - 1));
      inverse_error = worse(inverse_error, std::abs(bearing::force(*one, delta) / f - 1));
      ++forces;
    }
  const LawCheck check = check_of(laws.inner);
  const std::string about = fmt::format("{} forces", forces);
  found.claims.push_back(claim(
      sentence(fmt::format("laws/{}/slopes", name),
               fmt::format("the slopes of the law {} are those of its force and of its approach", name)),
      slope_error, 0, Tolerance::discretisation(1e-8, check.slope_safety), about + ", central differences of 1e-4"));
  found.claims.push_back(
      claim(sentence(fmt::format("laws/{}/inverse", name),
                     fmt::format("the law {} gives back the force that its approach came from", name)),
            inverse_error, 0, Tolerance::round_off(check.operations, check.condition), about + "; " + check.why));
}

Findings judge_dry_laws() {
  Findings found;
  for (const bearing::Law law : bearing::laws_of(bearing::Laws::dry))
    add_law(found, std::string(to_string(law)), dry_laws(law, some_contact()));
  add_law(found, "ehd-linear",
          {bearing::LinearLaw{.K_N_per_m = 3.3e8, .dF_N = 410}, bearing::LinearLaw{.K_N_per_m = 2.7e8, .dF_N = -90}});
  return found;
}

}  // namespace ehd::verification::bearing_parts
