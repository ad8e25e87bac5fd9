// SPDX-License-Identifier: GPL-3.0-or-later
// The laws that a case may name: one table of viscosity laws, one of density laws. The formulas stand in rheology.hpp.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>

#include "contact/conditions.hpp"
#include "contact/enum_words.hpp"
#include "contact/rheology.hpp"

namespace ehd {

struct ViscosityLawRow {
  ViscosityLaw law;
  std::string_view name;  ///< in case files
  LawKeys keys;           ///< what the law reads of [lubricant]
  /// The law for pressures in the unit that the inputs have.
  Viscosity (*from)(const LawInputs& inputs);
};

struct DensityLawRow {
  DensityLaw law;
  std::string_view name;  ///< in case files
  Density per_Pa;         ///< for pressures in Pa
};

/// Each alternative of Viscosity is one row; the enum ViscosityLaw has the same order.
inline constexpr std::size_t viscosity_law_count = std::variant_size_v<Viscosity>;
/// More rows than alternatives of Density: two printed laws have one shape.
inline constexpr std::size_t density_law_count = word_count<DensityLaw>();

[[nodiscard]] const std::array<ViscosityLawRow, viscosity_law_count>& viscosity_laws();
[[nodiscard]] const std::array<DensityLawRow, density_law_count>& density_laws();
[[nodiscard]] const ViscosityLawRow& row_of(ViscosityLaw law);
[[nodiscard]] const DensityLawRow& row_of(DensityLaw law);

/// "barus or roelands": the laws whose viscosity depends on pressure, for messages.
[[nodiscard]] std::string piezoviscous_names();

}  // namespace ehd
