// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11: properties of any bearing: symmetry of the cage, displacement as a power of the load, rings that change
// places. Bearings are drawn from a fixed seed. These claims need no other solution.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "bearing/equilibrium.hpp"
#include "verification/claims/bearing/parts.hpp"
#include "verification/claims/shared.hpp"
#include "verification/studies/draw.hpp"

namespace ehd::verification::bearing_parts {

namespace {

constexpr unsigned bearing_seed = 20261128;

struct DrawnBearing {
  bearing::Geometry geometry;
  bearing::LawPair laws;
  bearing::Loading loading;
};

/// Dry and straight-line laws in turn, clearance or preload, any position of the cage.
DrawnBearing drawn_bearing(Draw& draw, int i) {
  DrawnBearing drawn;
  const double pitch = draw.logarithmic(0.02, 0.3), length = draw.uniform(0.01, 0.1);
  drawn.geometry = {.rollers = draw.integer(5, 40),
                    .pitch_diameter_m = pitch,
                    .roller_diameter_m = pitch * draw.uniform(0.05, 0.2),
                    .length_m = length,
                    .clearance_m = draw.uniform(-2e-5, 4e-5),
                    .density_kg_per_m3 = draw.uniform(3000, 8000),
                    .first_azimuth_deg = draw.uniform(-20, 20)};
  const bearing::LinearLaw line{.K_N_per_m = draw.logarithmic(5e8, 5e9), .dF_N = draw.uniform(0, 2000)};
  const bearing::ForceLaw law = i % 3 == 0   ? bearing::ForceLaw{bearing::palmgren_law(length)}
                                : i % 3 == 1 ? bearing::ForceLaw{bearing::iso_law(length)}
                                             : bearing::ForceLaw{line};
  drawn.laws = {law, law};
  const auto speeds = bearing::speeds_from_rpm(draw.uniform(0, 10000), 0);
  drawn.loading = {.radial_N = draw.logarithmic(1e3, 1e5),
                   .centrifugal_N = bearing::centrifugal_force_N(drawn.geometry, speeds)};
  return drawn;
}

/// Largest |f_a - f_b| over the rollers that `other_of` pairs, relative to the larger of F_r and the sum of forces.
template <class Pairing>
double forces_apart(const DrawnBearing& one, const bearing::Geometry& turned, Pairing other_of) {
  const auto a = bearing::balance(one.geometry, one.laws, one.loading),
             b = bearing::balance(turned, one.laws, one.loading);
  const auto *x = std::get_if<bearing::Equilibrium>(&a), *y = std::get_if<bearing::Equilibrium>(&b);
  if (!x || !y) return nothing;
  double sum = 0, apart = 0;
  const auto count = static_cast<int>(x->rollers.size());
  for (int i = 0; i < count; ++i) {
    const auto& roller = x->rollers[static_cast<std::size_t>(i)];
    const auto& other = y->rollers[static_cast<std::size_t>(other_of(i, count))];
    sum += roller.inner.force_N;
    apart = worse(apart, std::abs(roller.inner.force_N - other.inner.force_N),
                  std::abs(roller.outer.force_N - other.outer.force_N));
  }
  return apart / std::max(one.loading.radial_N, sum);
}

}  // namespace

Findings judge_bearing_symmetry() {
  constexpr int bearings = 60;
  Draw draw(bearing_seed);
  double mirrored = 0, turned_by_a_pitch = 0, displaced = 0, other_ring = 0, both_rings = 0;
  const auto keep = [](double& worst, double value) { worst = worse(worst, value); };
  for (int i = 0; i < bearings; ++i) {
    const DrawnBearing one = drawn_bearing(draw, i);
    bearing::Geometry turned = one.geometry;
    turned.first_azimuth_deg = -one.geometry.first_azimuth_deg;  // psi_j = a + j pitch becomes -a + j pitch
    keep(mirrored, forces_apart(one, turned, [](int j, int count) { return (count - j) % count; }));
    turned.first_azimuth_deg = one.geometry.first_azimuth_deg + 360.0 / one.geometry.rollers;
    keep(turned_by_a_pitch, forces_apart(one, turned, [](int j, int count) { return (j + count - 1) % count; }));

    // f ~ delta^(10/9) at both contacts, no clearance, nothing thrown out: delta_r ~ F_r^(9/10).
    DrawnBearing plain_one = one;
    plain_one.geometry.clearance_m = 0;
    plain_one.loading.centrifugal_N = 0;
    plain_one.laws = {bearing::iso_law(one.geometry.length_m), bearing::palmgren_law(one.geometry.length_m)};
    DrawnBearing heavier = plain_one;
    heavier.loading.radial_N *= 8;
    const auto a = bearing::balance(plain_one.geometry, plain_one.laws, plain_one.loading),
               b = bearing::balance(heavier.geometry, heavier.laws, heavier.loading);
    const auto *x = std::get_if<bearing::Equilibrium>(&a), *y = std::get_if<bearing::Equilibrium>(&b);
    keep(displaced, x && y ? std::abs(y->displacement_m / (x->displacement_m * std::pow(8.0, 0.9)) - 1) : nothing);

    const double rpm = draw.uniform(100, 10000), cage = draw.uniform(-3000, 3000);
    const auto sum_speed = [&](double inner, double outer) {
      return bearing::sum_speed_m_per_s(one.geometry, bearing::speeds_from_rpm(inner, outer));
    };
    keep(other_ring, std::abs(sum_speed(0, rpm) / sum_speed(rpm, 0) - 1));
    keep(both_rings, std::abs(sum_speed(rpm + cage, cage) / sum_speed(rpm, 0) - 1));
  }
  const std::string of = fmt::format(" of {} random bearings", bearings);
  // A balance error of 1e-12 of the load changes no roller's force by more.
  const Tolerance balanced =
      Tolerance::required(2 * bearing::largest_balance_error, "two balances, each to 1e-12 of the load");
  // Some ten operations. The speed that both rings share cancels with a condition of (rpm + 2 |cage|)/rpm, at most 61.
  const Tolerance ten_operations = Tolerance::round_off(16), cancelling = Tolerance::round_off(16, 61);
  const auto says = [](const char* id, std::string statement) {
    return Sentence{.id = std::string("properties/bearing/") + id, .rung = 11, .statement = std::move(statement)};
  };
  Findings found;
  found.claims.push_back(claim(says("mirrored", "a cage mirrored in the load line carries the mirrored forces" + of),
                               mirrored, 0, balanced));
  found.claims.push_back(
      claim(says("one-pitch", "a cage turned by one pitch carries the same forces, one roller on" + of),
            turned_by_a_pitch, 0, balanced));
  found.claims.push_back(claim(says("load-power", "displacement ~ load^(9/10) by a dry law without clearance" + of),
                               displaced, 0, balanced));
  found.claims.push_back(
      claim(says("other-ring", "the sum speed is the same whichever ring turns" + of), other_ring, 0, ten_operations));
  found.claims.push_back(
      claim(says("both-rings", "the sum speed does not change when both rings turn faster alike" + of), both_rings, 0,
            cancelling));
  return found;
}

}  // namespace ehd::verification::bearing_parts
