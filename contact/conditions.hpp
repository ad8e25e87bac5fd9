// SPDX-License-Identifier: GPL-3.0-or-later
// What a user states: the contact in one of three ways, the lubricant, and where the inlet begins. Names of
// numbers in SI carry the unit. Solvers see none of them (nondimensional.hpp).
#pragma once

#include <optional>
#include <string_view>
#include <variant>

namespace ehd {

/// One line contact in SI. Speed and viscosity are absent where the contact is dry.
struct Conditions {
  double load_N_per_m = 0;
  double reduced_radius_m = 0;                   ///< 1/R = 1/R_1 + 1/R_2, concave negative
  double reduced_modulus_Pa = 0;                 ///< E', 2/E' = (1-nu_1^2)/E_1 + (1-nu_2^2)/E_2
  std::optional<double> speed_sum_m_per_s = {};  ///< u_s = u_1 + u_2, the SUM
  std::optional<double> viscosity_Pa_s = {};     ///< eta_0
};

/// M = W U_s^(-1/2), L = G U_s^(1/4) (Moes, sum speed).
struct MoesGroups {
  double M = 0;
  double L = 0;
};

/// lambda = 6 eta_0 u_s R^2/(b^3 p_H) and alpha p_H themselves.
struct HertzGroups {
  double lambda = 0;
  double alpha_p_H = 0;
};

/// The three ways to state a problem.
using Statement = std::variant<MoesGroups, Conditions, HertzGroups>;

enum class ViscosityLaw { isoviscous, barus, roelands };
enum class DensityLaw { incompressible, dowson_higginson, dowson_higginson_1977 };

inline constexpr double roelands_pressure_Pa = 1.9613e8;  ///< p_0 where a case states none

struct Lubricant {
  ViscosityLaw viscosity = ViscosityLaw::barus;
  DensityLaw density = DensityLaw::incompressible;
  std::optional<double> alpha_per_Pa = {};
  std::optional<double> z = {};         ///< Roelands' exponent
  double p0_Pa = roelands_pressure_Pa;  ///< Roelands' reference pressure
};

/// The solver answers for X -> -infinity; its truncation error is part of its error estimate.
struct Flooded {};
/// The domain begins exactly at X = x (Hertz half-widths, negative): a literature case, truncated by definition.
struct TruncatedAt {
  double x = -4;
};
using Inlet = std::variant<Flooded, TruncatedAt>;

[[nodiscard]] std::string_view to_string(ViscosityLaw law);
[[nodiscard]] std::string_view to_string(DensityLaw law);
[[nodiscard]] std::optional<ViscosityLaw> viscosity_law_from(std::string_view text);
[[nodiscard]] std::optional<DensityLaw> density_law_from(std::string_view text);

}  // namespace ehd
