// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/random_bearing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/studies/draw.hpp"

namespace ehd::verification {

namespace {

using std::numbers::pi;

constexpr double heaviest_Pa = 4e9;

/// The contact force at a Hertz pressure, f = 2 pi R p^2 l/E' [N].
double force_at(double pressure_Pa, const bearing::Geometry& geometry, const bearing::RollerContact& contact,
                bearing::Raceway raceway) {
  return 2 * pi * bearing::reduced_radius_m(geometry, raceway) * pressure_Pa * pressure_Pa * contact.length_m /
         bearing::reduced_modulus_Pa(contact.modulus_Pa, contact.poisson);
}

}  // namespace

RandomBearing random_bearing(unsigned seed) {
  Draw draw(seed);
  RandomBearing drawn;
  bearing::Geometry& geometry = drawn.geometry;
  geometry.rollers = std::clamp(static_cast<int>(std::lround(draw.logarithmic(2.6, 450))), 3, 400);
  geometry.pitch_diameter_m = draw.logarithmic(0.02, 0.5);
  const double side_by_side = std::sin(pi / geometry.rollers);
  geometry.roller_diameter_m = geometry.pitch_diameter_m * std::min(0.45, side_by_side * draw.uniform(0.2, 0.95));
  geometry.length_m = geometry.roller_diameter_m * draw.logarithmic(0.5, 25);
  geometry.density_kg_per_m3 = draw.uniform(3000, 8000);
  drawn.contact = {.force_N = 0,
                   .length_m = geometry.length_m,
                   .roller_diameter_m = geometry.roller_diameter_m,
                   .pitch_diameter_m = geometry.pitch_diameter_m,
                   .modulus_Pa = draw.uniform(1.9e11, 3.1e11),
                   .poisson = draw.uniform(0.25, 0.31),
                   .ring_thickness_m = geometry.roller_diameter_m * draw.uniform(0.2, 1.5)};
  const double most_N = force_at(heaviest_Pa, geometry, drawn.contact, bearing::Raceway::inner);
  const bearing::PowerLaw palmgren = bearing::palmgren_law(geometry.length_m);

  const double preload_m = std::min(20e-6, 2 * palmgren.approach(most_N));  // half of what 4 GPa on both contacts take
  const double room = draw.uniform(0, 1);
  geometry.clearance_m = room < 0.1   ? 0
                         : room < 0.3 ? draw.uniform(-preload_m, 0)
                         : room < 0.5 ? draw.logarithmic(1e-9, 1e-5)
                                      : draw.uniform(0, 200e-6);

  const double stands = draw.uniform(0, 1), pitch_deg = 360.0 / geometry.rollers;
  const double symmetric_deg = draw.integer(0, 1) * pitch_deg / 2;
  geometry.first_azimuth_deg = stands < 0.2   ? symmetric_deg
                               : stands < 0.3 ? symmetric_deg + draw.logarithmic(1e-13, 1e-2)
                                              : draw.uniform(-180, 180);

  const double turning = draw.uniform(0, 1);
  double inner_rpm = draw.uniform(-30000, 30000), outer_rpm = draw.uniform(-30000, 30000);
  if (turning < 0.5) outer_rpm = 0;
  if (turning > 0.7) inner_rpm = 0;
  if (turning > 0.9) outer_rpm = 0;
  drawn.speeds = bearing::speeds_from_rpm(inner_rpm, outer_rpm);
  const double thrown_N = bearing::centrifugal_force_N(geometry, drawn.speeds);
  const double slower = std::min(1.0, std::sqrt(most_N / 2 / std::max(thrown_N, 1e-300)));
  drawn.speeds = bearing::speeds_from_rpm(slower * inner_rpm, slower * outer_rpm);
  drawn.loading.centrifugal_N = bearing::centrifugal_force_N(geometry, drawn.speeds);

  // The largest roller force, and the rollers that share the load with it: Stribeck's fifth of those in the load zone.
  const double largest_N =
      force_at(draw.logarithmic(1e5, heaviest_Pa), geometry, drawn.contact, bearing::Raceway::inner);
  const double approach_m = 2 * palmgren.approach(largest_N), gap_m = std::max(0.0, geometry.clearance_m / 2);
  const double zone = std::acos(gap_m / (gap_m + approach_m)) / (pi / 2) * geometry.rollers / 5;
  drawn.loading.radial_N = largest_N * (zone > 1 ? draw.uniform(1, zone) : 1);
  if (draw.uniform(0, 1) < 0.05) drawn.loading.radial_N = 0;
  return drawn;
}

}  // namespace ehd::verification
