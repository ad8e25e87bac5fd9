// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ehd::bearing {

using std::numbers::pi;

namespace {

double gamma_of(const Geometry& geometry) { return geometry.roller_diameter_m / geometry.pitch_diameter_m; }

/// Azimuths closer than this are equal: ten times their rounding. A load turned by this has 2e-14 of itself across.
constexpr double same_deg = 1e-12;

}  // namespace

Speeds speeds_from_rpm(double inner_rpm, double outer_rpm) { return {inner_rpm * pi / 30, outer_rpm * pi / 30}; }

int most_rollers(double pitch_diameter_m, double roller_diameter_m) {
  constexpr double rounding = 1e-9;  // six rollers of half the pitch circle touch, and fit
  return static_cast<int>(pi / std::asin(roller_diameter_m / pitch_diameter_m) + rounding);
}

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

double roller_mass_kg(const Geometry& geometry) {
  const double D = geometry.roller_diameter_m;
  return geometry.density_kg_per_m3 * pi * D * D * geometry.length_m / 4;
}

double centrifugal_force_N(const Geometry& geometry, const Speeds& speeds) {
  const double cage = cage_speed_rad_per_s(geometry, speeds);
  return roller_mass_kg(geometry) * geometry.pitch_diameter_m / 2 * cage * cage;
}

double reduced_modulus_Pa(double modulus_Pa, double poisson) { return modulus_Pa / (1 - poisson * poisson); }

std::vector<double> azimuths_deg(const Geometry& geometry) {
  std::vector<double> azimuths;
  const double half_pitch_deg = 180.0 / geometry.rollers,
               steps = std::round(geometry.first_azimuth_deg / half_pitch_deg);
  const bool symmetric = std::abs(geometry.first_azimuth_deg - steps * half_pitch_deg) <= same_deg;
  for (int j = 0; j < geometry.rollers; ++j) {
    // In half pitches a symmetric cage is counted in integers, so that mirrored rollers agree to the bit.
    double psi = symmetric ? 180.0 * std::remainder(steps + 2.0 * j, 2.0 * geometry.rollers) / geometry.rollers
                           : std::remainder(geometry.first_azimuth_deg + 360.0 * j / geometry.rollers, 360.0);
    if (psi <= -180) psi += 360;
    azimuths.push_back(psi + 0.0);  // no negative zero
  }
  return azimuths;
}

double cosine_of_degrees(double degrees) {
  const double magnitude = std::abs(degrees);
  if (magnitude > 90) return -cosine_of_degrees(180 - magnitude);
  if (magnitude == 90) return 0;
  if (magnitude == 60) return 0.5;
  return std::cos(magnitude * pi / 180);
}

double sine_of_degrees(double degrees) {
  const double magnitude = std::abs(degrees), sign = degrees < 0 ? -1 : 1;
  if (magnitude > 90) return sign * sine_of_degrees(180 - magnitude);
  if (magnitude == 30) return sign * 0.5;
  return sign * (magnitude == 90 ? 1 : std::sin(magnitude * pi / 180));
}

std::vector<RollerGroup> mirror_groups(const std::vector<double>& azimuths_deg) {
  std::vector<RollerGroup> groups;
  for (int j = 0; j < static_cast<int>(azimuths_deg.size()); ++j) {
    const double magnitude = std::abs(azimuths_deg[static_cast<std::size_t>(j)]);
    bool found = false;
    for (std::size_t g = 0; g < groups.size() && !found; ++g) {
      if (std::abs(groups[g].azimuth_deg - magnitude) > same_deg) continue;
      groups[g].members.push_back(j);
      found = true;
    }
    if (found) continue;
    groups.push_back({magnitude, cosine_of_degrees(magnitude), {j}});
  }
  return groups;
}

bool symmetric_to_load(const std::vector<double>& azimuths_deg) {
  const auto groups = mirror_groups(azimuths_deg);
  return std::all_of(groups.begin(), groups.end(), [&](const RollerGroup& group) {
    return group.members.size() == 2 || group.azimuth_deg <= same_deg || group.azimuth_deg >= 180 - same_deg;
  });
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
