// SPDX-License-Identifier: GPL-3.0-or-later
// The law set that the published tables of this project use: Roelands z = 0.68, alpha = 2.2e-8 1/Pa, p_0 = 1.96e8 Pa,
// Dowson-Higginson density.
#pragma once

#include "contact/nondimensional.hpp"

namespace ehd {

inline Problem roelands_problem(double M, double L, const Inlet& inlet) {
  const Lubricant oil{.viscosity = ViscosityLaw::roelands,
                      .density = DensityLaw::dowson_higginson,
                      .alpha_per_Pa = 2.2e-8,
                      .z = 0.68,
                      .p0_Pa = 1.96e8};
  return nondimensionalise(MoesGroups{M, L}, oil, inlet).problem;
}

inline Problem barus_problem(double M, double L, const Inlet& inlet) {
  return nondimensionalise(MoesGroups{M, L}, Lubricant{}, inlet).problem;
}

}  // namespace ehd
