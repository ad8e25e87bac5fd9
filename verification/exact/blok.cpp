// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/exact/blok.hpp"

#include <cmath>
#include <numbers>

#include "verification/exact/martin.hpp"

namespace ehd::verification::exact {

Blok::Blok() {
  // q_max = c eta u_m sqrt(2 R h_0)/h_0^2 = 1/alpha; with h_0 = H R U_s^(1/2), eta u_m = E'R U_s/2:
  // H^(3/2) = c L/sqrt 2.
  const Martin martin;
  minimum = std::pow(martin.pressure_max / std::numbers::sqrt2, 2.0 / 3);
  couette = minimum * martin.exit_film;
}

}  // namespace ehd::verification::exact
