// SPDX-License-Identifier: GPL-3.0-or-later
// The regimes by which a submission's digits are gathered: THE definition.
#pragma once

#include <array>
#include <string_view>

#include "contact/enum_words.hpp"
#include "contact/problem.hpp"

namespace ehd::judging {

enum class Load { light, moderate, heavy };
enum class Material { low, high };  ///< L: how strongly the viscosity rises with the pressure

/// Below 5 the film is thick and the pressure far from Hertz'; from 100 on it is thin and close to Hertz'.
inline constexpr double moderate_from_M = 5, heavy_from_M = 100;
/// Between the atlas' 5 and 10: above, the pressure spike is sharp at moderate loads.
inline constexpr double high_from_L = 7.5;

struct Regime {
  Load load = Load::light;
  Material material = Material::low;
  [[nodiscard]] bool operator==(const Regime&) const = default;
};

[[nodiscard]] constexpr Regime regime_of(const Groups& groups) {
  const Load load = groups.M < moderate_from_M ? Load::light : groups.M < heavy_from_M ? Load::moderate : Load::heavy;
  return {.load = load, .material = groups.L < high_from_L ? Material::low : Material::high};
}

inline constexpr std::array all_regimes{
    Regime{Load::light, Material::low},     Regime{Load::light, Material::high}, Regime{Load::moderate, Material::low},
    Regime{Load::moderate, Material::high}, Regime{Load::heavy, Material::low},  Regime{Load::heavy, Material::high},
};
static_assert(all_regimes.size() == word_count<Load>() * word_count<Material>());

[[nodiscard]] constexpr std::string_view to_string(Load load) {
  switch (load) {
    case Load::light: return "light";
    case Load::moderate: return "moderate";
    case Load::heavy: return "heavy";
  }
  return "";
}
[[nodiscard]] constexpr std::string_view to_string(Material material) {
  return material == Material::low ? "low" : "high";
}

}  // namespace ehd::judging
