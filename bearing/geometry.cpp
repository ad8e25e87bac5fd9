// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/geometry.hpp"

#include <cmath>
#include <numbers>

namespace ehd::bearing {

using std::numbers::pi;

namespace {

double gamma_of(const Geometry& geometry) { return geometry.roller_diameter_m / geometry.pitch_diameter_m; }

/// Exact at multiples of 60 and 90 degrees, so that a roller at 90 degrees carries nothing of the load.
double cosine_of_degrees(double degrees) {
  const double magnitude = std::abs(degrees);
  if (magnitude > 90) return -cosine_of_degrees(180 - magnitude);
  if (magnitude == 90) return 0;
  if (magnitude == 60) return 0.5;
  return std::cos(magnitude * pi / 180);
}

}  // namespace

Speeds speeds_from_rpm(double inner_rpm, double outer_rpm) { return {inner_rpm * pi / 30, outer_rpm * pi / 30}; }

double raceway_radius_m(const Geometry& geometry, Raceway raceway) {
  const double sign = raceway == Raceway::inner ? -1 : 1;
  return (geometry.pitch_diameter_m + sign * geometry.roller_diameter_m) / 2;
}

double reduced_radius_m(const Geometry& geometry, Raceway raceway) {
  const double sign = raceway == Raceway::inner ? 1 : -1;
  return 1 / (2 / geometry.roller_diameter_m + sign / raceway_radius_m(geometry, raceway));
}

double cage_speed_rad_per_s(const Geometry& geometry, const Speeds& speeds) {
  const double gamma = gamma_of(geometry);
  return (speeds.inner_rad_per_s * (1 - gamma) + speeds.outer_rad_per_s * (1 + gamma)) / 2;
}

double sum_speed_m_per_s(const Geometry& geometry, const Speeds& speeds) {
  const double gamma = gamma_of(geometry);
  return geometry.pitch_diameter_m / 2 * (1 - gamma * gamma) *
         std::abs(speeds.inner_rad_per_s - speeds.outer_rad_per_s);
}

double centrifugal_force_N(const Geometry& geometry, const Speeds& speeds) {
  const double D = geometry.roller_diameter_m, cage = cage_speed_rad_per_s(geometry, speeds);
  const double mass_kg = geometry.density_kg_per_m3 * pi * D * D * geometry.length_m / 4;
  return mass_kg * geometry.pitch_diameter_m / 2 * cage * cage;
}

double reduced_modulus_Pa(double modulus_Pa, double poisson) { return modulus_Pa / (1 - poisson * poisson); }

std::vector<double> azimuths_deg(const Geometry& geometry) {
  std::vector<double> azimuths;
  for (int j = 0; j < geometry.rollers; ++j) {
    double psi = std::remainder(geometry.first_azimuth_deg + 360.0 * j / geometry.rollers, 360.0);
    if (psi <= -180) psi += 360;
    azimuths.push_back(psi);
  }
  return azimuths;
}

std::vector<RollerGroup> mirror_groups(const std::vector<double>& azimuths_deg) {
  constexpr double same_deg = 1e-9;  // far above the rounding of an azimuth, far below any spacing
  std::vector<RollerGroup> groups;
  std::vector<double> magnitudes;
  for (int j = 0; j < static_cast<int>(azimuths_deg.size()); ++j) {
    const double magnitude = std::abs(azimuths_deg[static_cast<std::size_t>(j)]);
    bool found = false;
    for (std::size_t g = 0; g < groups.size() && !found; ++g) {
      if (std::abs(magnitudes[g] - magnitude) > same_deg) continue;
      groups[g].members.push_back(j);
      found = true;
    }
    if (found) continue;
    groups.push_back({cosine_of_degrees(magnitude), {j}});
    magnitudes.push_back(magnitude);
  }
  return groups;
}

Conditions RacewayContact::at(double force_N) const {
  Conditions conditions{.load_N_per_m = force_N / length_m,
                        .reduced_radius_m = reduced_radius_m,
                        .reduced_modulus_Pa = reduced_modulus_Pa};
  if (speed_sum_m_per_s > 0) conditions.speed_sum_m_per_s = speed_sum_m_per_s;
  if (viscosity_Pa_s > 0) conditions.viscosity_Pa_s = viscosity_Pa_s;
  return conditions;
}

}  // namespace ehd::bearing
