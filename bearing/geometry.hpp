// SPDX-License-Identifier: GPL-3.0-or-later
// A cylindrical roller bearing: where its rollers are, how its raceways curve, how fast the surfaces move.
#pragma once

#include <string_view>
#include <vector>

#include "contact/conditions.hpp"
#include "contact/enum_words.hpp"

namespace ehd::bearing {

/// Lengths in m. gamma = D/d_m is below 1; rollers are equally spaced, roller 1 at first_azimuth_deg from the load.
struct Geometry {
  int rollers = 0;
  double pitch_diameter_m = 0;   ///< d_m
  double roller_diameter_m = 0;  ///< D
  double length_m = 0;           ///< l, effective contact length
  double clearance_m = 0;        ///< P_d, diametral; negative: preload
  double density_kg_per_m3 = 0;  ///< of the rollers
  double first_azimuth_deg = 0;
};

/// Angular speeds of the rings.
struct Speeds {
  double inner_rad_per_s = 0;
  double outer_rad_per_s = 0;
};
[[nodiscard]] Speeds speeds_from_rpm(double inner_rpm, double outer_rpm);

/// The most rollers that fit beside each other without a cage: the whole part of pi/asin(D/d_m).
[[nodiscard]] int most_rollers(double pitch_diameter_m, double roller_diameter_m);

enum class Raceway { inner, outer };
[[nodiscard]] inline std::string_view to_string(Raceway raceway) {
  return raceway == Raceway::inner ? "inner" : "outer";
}
inline constexpr auto both_raceways = all_words<Raceway>;

template <class T>
struct BothRaceways {
  T inner, outer;
  [[nodiscard]] const T& at(Raceway raceway) const { return raceway == Raceway::inner ? inner : outer; }
};

/// r_i = (d_m - D)/2, r_o = (d_m + D)/2 [m].
[[nodiscard]] double raceway_radius_m(const Geometry& geometry, Raceway raceway);
/// 1/R_i = 2/D + 1/r_i, 1/R_o = 2/D - 1/r_o.
[[nodiscard]] double reduced_radius_m(const Geometry& geometry, Raceway raceway);
/// w_c = [w_i (1 - gamma) + w_o (1 + gamma)]/2 [rad/s].
[[nodiscard]] double cage_speed_rad_per_s(const Geometry& geometry, const Speeds& speeds);
/// u_s = (d_m/2)(1 - gamma^2)|w_i - w_o| [m/s], the SUM of the surface speeds; the same at both raceways.
[[nodiscard]] double sum_speed_m_per_s(const Geometry& geometry, const Speeds& speeds);
/// m = density pi D^2 l/4 of a solid roller [kg].
[[nodiscard]] double roller_mass_kg(const Geometry& geometry);
/// F_c = m (d_m/2) w_c^2 [N].
[[nodiscard]] double centrifugal_force_N(const Geometry& geometry, const Speeds& speeds);
/// E' = E/(1 - nu^2) of two equal bodies [Pa].
[[nodiscard]] double reduced_modulus_Pa(double modulus_Pa, double poisson);

/// Azimuths of rollers 1..Z from the load line, psi_j = first_azimuth + 360 (j-1)/Z, in (-180, 180]. Under a cage
/// that is symmetric to the load (to 1e-12 degrees), mirrored rollers have equal and opposite azimuths to the bit.
[[nodiscard]] std::vector<double> azimuths_deg(const Geometry& geometry);

/// For |degrees| <= 180. Where a multiple of 30 degrees makes the value 0, 1/2 or 1 it is exact, so that a roller at 90
/// degrees carries nothing of the load. The values of opposite angles are equal, or equal and opposite, to the bit.
[[nodiscard]] double cosine_of_degrees(double degrees);
[[nodiscard]] double sine_of_degrees(double degrees);

/// Rollers that a ring moving along the load cannot tell apart: psi and -psi.
struct RollerGroup {
  double azimuth_deg = 0;    ///< |psi|
  double cosine = 0;         ///< of psi; exact at 0, 90 and 180 degrees
  std::vector<int> members;  ///< indices of rollers, from 0
};
[[nodiscard]] std::vector<RollerGroup> mirror_groups(const std::vector<double>& azimuths_deg);
/// True where every roller has its mirror image in the load line, or stands on it.
[[nodiscard]] bool symmetric_to_load(const std::vector<double>& azimuths_deg);

/// Everything about the contact of a roller with one raceway that does not change with the load.
struct RacewayContact {
  double length_m = 0;
  double reduced_radius_m = 0;
  double reduced_modulus_Pa = 0;
  double speed_sum_m_per_s = 0;
  double viscosity_Pa_s = 0;  ///< eta_0; 0 in a dry bearing

  /// The line contact at a contact force [N]; speed and viscosity are absent where they are 0.
  [[nodiscard]] Conditions at(double force_N) const;
  friend auto operator<=>(const RacewayContact&, const RacewayContact&) = default;
};

}  // namespace ehd::bearing
