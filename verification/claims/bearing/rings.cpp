// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11: balances at light load, of random bearings, and of very many rollers.
#include "verification/claims/bearing/rings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "bearing/equilibrium.hpp"
#include "contact/text.hpp"
#include "verification/claims/bearing/by_hand.hpp"
#include "verification/claims/bearing/parts.hpp"
#include "verification/exact/sjovall.hpp"
#include "verification/studies/bearing_check.hpp"
#include "verification/studies/fits.hpp"
#include "verification/studies/random_bearing.hpp"

namespace ehd::verification::bearing_parts {

using std::numbers::pi;

bearing::RollerContact some_contact() {
  return {.force_N = 0,
          .length_m = 0.017,
          .roller_diameter_m = 0.011,
          .pitch_diameter_m = 0.083,
          .modulus_Pa = 2.09e11,
          .poisson = 0.28,
          .ring_thickness_m = 0.0064};
}

std::vector<PlacedRoller> rollers_at(const bearing::Geometry& geometry, const bearing::LawPair& laws,
                                     double centrifugal_N, double along_m, double across_m) {
  std::vector<PlacedRoller> rollers;
  for (int j = 0; j < geometry.rollers; ++j) {
    const double psi = (geometry.first_azimuth_deg + 360.0 * j / geometry.rollers) * pi / 180;
    const double room_m = along_m * std::cos(psi) + across_m * std::sin(psi) - geometry.clearance_m / 2;
    rollers.push_back({psi, bearing::balance_roller(laws, centrifugal_N, room_m)});
  }
  return rollers;
}

/// With clearance, a light load rests on the two rollers beside it. Their forces are F sin(b)/sin(a + b) and
/// F sin(a)/sin(a + b).
Findings judge_light_load() {
  const bearing::RollerContact contact = some_contact();
  double worst = 0;
  int balances = 0;
  for (const int rollers : {3, 5, 36, 400})
    for (const double part : {1e-5, 0.2, 0.49, 0.9})
      for (const double load_N : {1e-9, 1e-3}) {
        const double pitch = 2 * pi / rollers, a = part * pitch, b = pitch - a;
        const bearing::Geometry geometry{.rollers = rollers,
                                         .pitch_diameter_m = contact.pitch_diameter_m,
                                         .roller_diameter_m = contact.roller_diameter_m,
                                         .length_m = contact.length_m,
                                         .clearance_m = 200e-6,
                                         .density_kg_per_m3 = 7790,
                                         .first_azimuth_deg = part * 360 / rollers};
        const auto result = bearing::balance(geometry, dry_laws(bearing::Law::tripp, contact),
                                             {.radial_N = load_N, .centrifugal_N = 57});
        const auto* ring = std::get_if<bearing::Equilibrium>(&result);
        const double first = ring ? ring->rollers.front().inner.force_N : nothing,
                     last = ring ? ring->rollers.back().inner.force_N : nothing;
        worst = worse(worst, std::abs(first / load_N - std::sin(b) / std::sin(pitch)),
                      std::abs(last / load_N - std::sin(a) / std::sin(pitch)));
        ++balances;
      }
  Findings found;
  found.claims.push_back(
      claim(sentence("statics", "a light load rests on the two rollers beside it, with the forces that statics gives"),
            worst, 0, Tolerance::round_off(20, 100), fmt::format("{} bearings; 1/sin(pitch) is below 100", balances)));
  return found;
}

/// Bearings over the whole ranges; bisection checks each balance.
Findings judge_random_bearings() {
  constexpr unsigned bearings = 150;
  Findings found;
  for (const bearing::Law law : bearing::laws_of(bearing::Laws::dry)) {
    double worst = 0;
    unsigned worst_seed = 0;
    for (unsigned seed = 1; seed <= bearings; ++seed) {
      const RandomBearing drawn = random_bearing(seed);
      const bearing::LawPair laws = dry_laws(law, drawn.contact);
      const auto result = bearing::balance(drawn.geometry, laws, drawn.loading);
      const auto* ring = std::get_if<bearing::Equilibrium>(&result);
      const double error =
          ring ? worst_bisection_error(drawn.geometry, laws, drawn.loading, bearing::Form::plane, *ring) : nothing;
      if (!(error <= worst) && !std::isnan(worst)) {
        worst = error;
        worst_seed = seed;
      }
    }
    const std::string name(to_string(law));
    found.claims.push_back(
        claim(sentence("random/" + name,
                       fmt::format("{} random bearings are balanced, which bisection of every roller confirms, law {}",
                                   bearings, name)),
              worst, 0, Tolerance::required(bearing::largest_balance_error, "what a balance promises"),
              fmt::format("worst at seed {}", worst_seed)));
  }
  return found;
}

/// F_r/(Z Q_max) goes to Sjovall's integral as Z grows. The rollers sum a periodic function that has a corner of power
/// n = 10/9 at the edge of the load zone: the largest error over the cage's positions falls like Z^-(n + 1).
Findings judge_many_rollers() {
  constexpr double length_m = 0.012, clearance_m = 5e-6;
  const bearing::PowerLaw law = bearing::palmgren_law(length_m);
  Findings found;
  std::vector<double> x, y;
  double worst_on_last = 0;
  for (const int rollers : {24, 48, 96, 192, 384}) {
    double worst = 0;
    for (int position = 0; position < 12; ++position) {
      const bearing::Geometry geometry{.rollers = rollers,
                                       .pitch_diameter_m = 0.07,
                                       .roller_diameter_m = 0.009,
                                       .length_m = length_m,
                                       .clearance_m = clearance_m,
                                       .density_kg_per_m3 = 7850,
                                       .first_azimuth_deg = 360.0 / rollers * (position / 12.0 - 0.5)};
      const double load_N = 180.0 * rollers;
      const auto balanced = bearing::balance(geometry, {law, law}, {.radial_N = load_N}, bearing::Form::radial);
      const auto* ring = std::get_if<bearing::Equilibrium>(&balanced);
      double error = nothing;
      if (ring) {
        const double eps = (1 - clearance_m / (2 * ring->displacement_m)) / 2;
        const double at_top_mm =
            1e3 * (ring->displacement_m - clearance_m / 2) / 2;  // each contact, f = 8.06e4 l^(8/9) delta^(10/9)
        const double largest = 8.06e4 * std::pow(1e3 * length_m, 8.0 / 9) * std::pow(at_top_mm, 10.0 / 9);
        error = std::abs(load_N / (rollers * largest) / exact::SjovallIntegral{}(eps)-1);
      }
      worst = worse(worst, error);
    }
    x.push_back(-std::log(rollers));
    y.push_back(std::log(worst));
    worst_on_last = worst;
  }
  found.claims.push_back(order_claim(
      sentence("sjovall/order", "the load shares of Z rollers go to Sjovall's integral with order n + 1 = 19/9"),
      slope(x, y), 19.0 / 9, Tolerance::calibrated(0.2, "an envelope over twelve cage positions, read to a fifth"),
      fmt::format("24 to 384 rollers, error {} on the last", scientific(worst_on_last, 2))));
  return found;
}

}  // namespace ehd::verification::bearing_parts
