// SPDX-License-Identifier: GPL-3.0-or-later
// An oil by its grade: viscosity and density at a temperature, from what its data sheet prints.
//
// Sources. Viscosity over temperature: ASTM D341 (Walther). Viscosity index: ASTM D2270, with the coefficients of its
// appendix for L and H. Grades: ISO 3448. Density over temperature: ASTM D1250, table 54D, lubricating oils. Pressure
// coefficient: R. W. Wooster's relation of 1937 for mineral oils, as Stachowiak & Batchelor print it (Engineering
// Tribology, chapter 2).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ehd {

/// The 20 grades of ISO 3448, from 2 to 3200.
[[nodiscard]] std::span<const double> iso_viscosity_grades();
/// The midpoint viscosity of a grade at 40 C [mm2/s]; the oil itself may lie 10 % off. Equal to the number of the grade
/// but for 2, 3, 5 and 7. Absent for a number that is no grade.
[[nodiscard]] std::optional<double> midpoint_of_grade_mm2_per_s(double grade);

/// The viscosity at 100 C [mm2/s] below which ASTM D2270 defines no viscosity index.
inline constexpr double least_with_index = 2;
/// The viscosity index [-]. Absent below `least_with_index`.
[[nodiscard]] std::optional<double> viscosity_index(double viscosity_40C_mm2_per_s, double viscosity_100C_mm2_per_s);
/// The viscosity at 100 C [mm2/s] of an oil with that index. Absent where it would lie below 2 mm2/s, or would not lie
/// below the viscosity at 40 C.
[[nodiscard]] std::optional<double> viscosity_100C_mm2_per_s(double viscosity_40C_mm2_per_s, double index);

/// Kinematic viscosity [mm2/s] at a temperature, by two others: log log Z is linear in log T. ASTM D341 gives it from
/// 0.21 to 2e7 mm2/s; absent outside.
[[nodiscard]] std::optional<double> viscosity_at_mm2_per_s(double viscosity_40C_mm2_per_s,
                                                           double viscosity_100C_mm2_per_s, double temperature_C);

/// Density [kg/m3] of a lubricating oil at a temperature, by that at 15 C.
[[nodiscard]] double oil_density_kg_per_m3(double density_15C_kg_per_m3, double temperature_C);

/// alpha [1/Pa] = (0.6 + 0.965 log10(eta_0/mPa s)) 1e-8, for mineral oils: an estimate. Absent where it is not
/// positive, below 0.24 mPa s.
[[nodiscard]] std::optional<double> wooster_alpha_per_Pa(double viscosity_Pa_s);

/// An oil as a case states it, and what follows at the film's inlet.
struct GradedOil {
  std::optional<double> iso_vg = {};  ///< absent where both viscosities are stated
  double viscosity_40C_mm2_per_s = 0;
  double viscosity_100C_mm2_per_s = 0;
  std::optional<double> viscosity_index = {};  ///< absent where none is defined
  double temperature_C = 0;
  double density_15C_kg_per_m3 = 0;
  double viscosity_mm2_per_s = 0;  ///< at temperature_C, as the two below
  double density_kg_per_m3 = 0;
  double viscosity_Pa_s = 0;                          ///< eta_0
  std::optional<double> estimated_alpha_per_Pa = {};  ///< where the case leaves alpha out and its law needs it
};
/// The numbers that came out, and by which formulas; `more` notes follow.
[[nodiscard]] std::vector<std::string> notes_of(const GradedOil& oil, const std::vector<std::string>& more = {});

}  // namespace ehd
