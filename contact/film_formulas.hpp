// SPDX-License-Identifier: GPL-3.0-or-later
// Published film formulas, for comparison only.
#pragma once

#include <string>
#include <vector>

#include "contact/nondimensional.hpp"
#include "contact/quantities.hpp"

namespace ehd {

/// G = alpha E' where a case does not fix alpha or E': that of a mineral oil between steel surfaces.
inline constexpr double usual_G = 5000;

/// One formula evaluated at one point; film in Moes units (h/R) U_s^(-1/2).
struct FilmFormula {
  std::string name;  ///< "Dowson & Higginson 1977"
  Quantity of = Quantity::film_minimum;
  double moes_film = 0;
};

/// Moes' interpolation (as in Venner 1991) of the four asymptotes; for the central (Couette) film, sum speed.
[[nodiscard]] double moes_film_formula(const MoesGroups& moes);
/// The same in Hertz units: the film that solvers expect. Starts use it; no result does.
[[nodiscard]] double expected_film(const MoesGroups& moes);

/// Every formula that the groups allow. The power laws of U, W, G need G = alpha E'; a caller that does not know G
/// assumes one.
[[nodiscard]] std::vector<FilmFormula> film_formulas(const MoesGroups& moes, double G);

/// Pan & Hamrock 1989: p_spike/E' = 0.648 W^0.185 U^0.275 G^0.391, x_spike/R = 1.111 W^0.606 U^-0.021 G^0.077,
/// x_min/R = 1.439 W^0.548 U^-0.011 G^0.026 (mean speed), in Hertz units: p_H = E' sqrt(W/2pi), b = R sqrt(8W/pi).
/// L and G > 0.
struct SpikeFormula {
  double height = 0;         ///< P = p/p_H
  double place = 0;          ///< X = x/b
  double minimum_place = 0;  ///< X of the smallest film
};
[[nodiscard]] SpikeFormula pan_hamrock_spike(const MoesGroups& moes, double G);

}  // namespace ehd
