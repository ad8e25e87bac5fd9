// SPDX-License-Identifier: GPL-3.0-or-later
// Similarity groups in both conventions, and nondimensionalise(): from what a user states in SI or by groups to the
// dimensionless Problem that a solver gets.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "contact/conditions.hpp"
#include "contact/problem.hpp"

namespace ehd {

/// lambda = 3 pi^2/(8 M^2), alpha p_H = L sqrt(M/(2 pi)).
[[nodiscard]] Groups groups_from(const MoesGroups& moes);
/// The inverse of the above: M = sqrt(3 pi^2/(8 lambda)).
[[nodiscard]] Groups groups_from(const HertzGroups& hertz);

/// H_Moes = H * 8M/pi, H_Moes = (h/R) U_s^(-1/2).
[[nodiscard]] double moes_film_per_hertz_film(double M);

/// Dowson's and Hamrock's groups: MEAN speed. W = w/(E'R), U_mean = eta_0 u_m/(E'R) = U_s/2, G = alpha E'.
struct DowsonGroups {
  double W = 0;
  double U_mean = 0;
  double G = 0;
};
/// M = W (2 U_mean)^(-1/2), L = G (2 U_mean)^(1/4).
[[nodiscard]] MoesGroups moes_from(const DowsonGroups& groups);
/// The inverse, for one chosen G (M and L fix W and U_mean once G is chosen).
[[nodiscard]] DowsonGroups dowson_from(const MoesGroups& moes, double G);

/// Hertz scales in SI, where they are known.
struct Scales {
  double hertz_pressure_Pa = 0;
  std::optional<double> half_width_m = {};
  std::optional<double> reduced_radius_m = {};
  std::optional<DowsonGroups> dowson = {};  ///< G = 0 where alpha is unknown
  /// h = H b^2/R; absent where only the pressure scale is known.
  [[nodiscard]] std::optional<double> film_m_per_hertz_film() const;
};

struct Nondimensional {
  Problem problem;
  std::optional<Scales> scales;    ///< absent where the statement fixes no pressure in Pa
  std::vector<std::string> notes;  ///< how the case was read, where that may surprise the user
};

/// A statement that cannot be made into a problem; `key` names the case-file key at fault ("lubricant.viscosity").
class StatementError : public std::invalid_argument {
 public:
  StatementError(std::string key, const std::string& what) : std::invalid_argument(what), key_(std::move(key)) {}
  [[nodiscard]] const std::string& key() const { return key_; }

 private:
  std::string key_;
};

/// The allowed range of the groups (exit 2 outside).
inline constexpr double smallest_M = 1e-3, largest_M = 1e6, largest_L = 100;

/// SI stops here. Roelands' relation alpha = z (ln eta_0 + 9.67)/p_0 supplies alpha or z where eta_0 is known and one
/// of the two is left out. L = 0 means isoviscous and incompressible whatever the laws say (noted, as is a z or p0_Pa
/// that the law does not read); isoviscous with L > 0, a law that needs pressures in Pa where p_H is unknown, and
/// groups out of range throw StatementError.
[[nodiscard]] Nondimensional nondimensionalise(const Statement& statement, const Lubricant& lubricant,
                                               const Inlet& inlet);

}  // namespace ehd
