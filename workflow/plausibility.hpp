// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that no ordinary contact or bearing has, most often from a slip of a unit: mm for m, mPa s for Pa s; and
// contacts outside the range in which stated errors were tested. A number outside its usual range gives a note, never a
// refusal.
//
// To add one: a member of Facts, its value in facts_of, and a row in plausibility.cpp.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ehd {

struct BearingCase;
struct ContactCase;
struct ContactRun;
struct RollerRow;

/// What is known of a contact or a bearing, in SI. Absent: not known, or it has no such thing.
struct Facts {
  std::optional<double> M = {}, L = {};              ///< of a contact with a film
  std::optional<double> cut_X = {};                  ///< where its inlet is cut; absent in a flooded one
  std::optional<double> surface_speed_m_per_s = {};  ///< the faster raceway; of a contact the mean of both surfaces
  std::optional<double> viscosity_Pa_s = {};
  std::optional<double> alpha_per_Pa = {}, p0_Pa = {};  ///< where the viscosity law reads them
  std::optional<double> load_N_per_m = {};              ///< of a contact
  std::optional<double> reduced_radius_m = {};          ///< of a contact
  std::optional<double> reduced_modulus_Pa = {};        ///< E'
  std::optional<double> roller_density_kg_per_m3 = {};
  std::optional<double> roughness_m = {};
  std::optional<double> hertz_pressure_Pa = {};     ///< the highest
  std::optional<double> film_minimum_m = {};        ///< the thinnest
  std::optional<double> rollers_over_most = {};     ///< Z over bearing::most_rollers
  std::optional<double> length_over_diameter = {};  ///< l/D
  std::optional<double> diameter_over_pitch = {};   ///< D/d_m
  std::optional<double> clearance_over_pitch = {};  ///< P_d/d_m
};
[[nodiscard]] Facts facts_of(const ContactCase& contact, const ContactRun& run);
/// `rollers` may be empty: then the stated numbers alone are known.
[[nodiscard]] Facts facts_of(const BearingCase& body, const std::vector<RollerRow>& rollers);

/// A row of the table: a number, where it usually lies, and why.
struct UsualRange {
  std::string_view name;
  std::optional<double> Facts::*fact;
  std::optional<double> lowest, highest;  ///< SI
  double shown_over_SI = 1;               ///< the note shows this times the number ...
  std::string_view unit;                  ///< ... in this unit
  std::string_view reason;
  bool impossible = false;  ///< outside, nobody can build it: tables say so before the numbers
};
[[nodiscard]] std::span<const UsualRange> usual_ranges();

/// A number outside its range.
struct Unusual {
  const UsualRange* range = nullptr;
  double value = 0;  ///< SI
};
/// In the order of the table.
[[nodiscard]] std::vector<Unusual> unusual(const Facts& facts);
/// "p_H = 4.9 GPa is above 4 GPa: a numerical test, not a contact of steel"
[[nodiscard]] std::string sentence_of(const Unusual& unusual);

}  // namespace ehd
