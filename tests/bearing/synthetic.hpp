// SPDX-License-Identifier: GPL-3.0-or-later
// A contact in closed form, with Martin's films at vanishing load and nearly load-independent ones at high load. It
// tests the EHD laws without a solver.
#pragma once

#include <cmath>

#include "bearing/approach_formulas.hpp"
#include "bearing/martin.hpp"
#include "bearing/solved_contacts.hpp"
#include "contact/hertz.hpp"

namespace ehd::bearing::synthetic {

inline RacewayContact contact() {
  return {.length_m = 0.05,
          .reduced_radius_m = 2.3e-3,
          .reduced_modulus_Pa = 2.2e11,
          .speed_sum_m_per_s = 11.0,
          .viscosity_Pa_s = 0.017};
}

/// A roller of steel, as the dry laws need it.
inline RollerContact roller() {
  return {.force_N = 0,
          .length_m = 0.021,
          .roller_diameter_m = 0.013,
          .pitch_diameter_m = 0.087,
          .modulus_Pa = 2.07e11,
          .poisson = 0.29,
          .ring_thickness_m = 0.0071};
}

inline constexpr double knee_N = 180;  ///< where piezoviscosity takes over

inline double enhancement(double force_N, double power) { return std::pow(1 + std::pow(force_N / knee_N, 1.5), power); }
/// Slope of ln F over ln f: -1 at light, -0.13 at heavy load.
inline double offset_film_m(double force_N) {
  const double rigid = martin_film(contact(), force_N).value;
  const double deformation = martin_offset_film(contact(), force_N).value - rigid;
  return rigid * enhancement(force_N, 0.58) + deformation / enhancement(force_N, 4);
}
inline double minimum_film_m(double force_N) {
  return martin_film(contact(), force_N).value * enhancement(force_N, 0.56);
}

inline SolvedContact solved(double force_N, double offset_m, double minimum_m) {
  const double b = hertz::half_width_m(contact().at(force_N));
  return {.offset = offset_m * contact().reduced_radius_m / (b * b) + hertz::dry_offset(),
          .offset_error = 1e-9,
          .film_minimum_m = minimum_m,
          .film_error = 1e-9};
}
inline SolvedContact solve(double force_N) { return solved(force_N, offset_film_m(force_N), minimum_film_m(force_N)); }

inline SolvableContact contacts() {
  return {contact(), [](double load_N_per_m) -> ContactResult { return solve(load_N_per_m * contact().length_m); }};
}

}  // namespace ehd::bearing::synthetic
