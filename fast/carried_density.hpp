// SPDX-License-Identifier: GPL-3.0-or-later
// The density at the nodes as the wedge carries it.
//
// Behind the spike the pressure falls within a cell. A node inside this fall has a pressure between both sides: with
// it the trapezoidal rule of the load and the deflection puts the fall at its right place between the nodes. The wedge
// sums rho H by the same rule. So its density has to be linear in that pressure too:
//
//   rho^_j = rho_(j-1) + sigma_j (P_j - P_(j-1)),  sigma_j = (rho_(j+1) - rho_(j-1))/(P_(j+1) - P_(j-1)),
//   carried density = (1 - w_j) rho_j + w_j rho^_j,  w = Grid::near_spike.
//
// Where P is smooth, rho^ differs from rho by O(h^2). With rho alone the error of the smallest film fell only as h, and
// depended on where between the nodes the fall was. At 60 contacts (M of 5..3000, L of 8..25, compressible, Barus and
// Roelands, flooded and cut) the extrapolated H_min of 1024 intervals was off by 2e-6 in the median and by 2.1e-5 at
// the worst tenth; with rho^ it is off by 6e-7 and 2.4e-6. Newton takes .94 of the steps.
#pragma once

#include "contact/array.hpp"

namespace ehd::fast {

struct NodeFields;
struct Setting;

/// Arrays have n + 1 entries, one a node; their storage is used again.
struct CarriedDensity {
  Array value;
  Array by_left, by_own, by_right;  ///< derivatives by P_(j-1), P_j, P_(j+1)
  bool by_neighbours = false;       ///< by_left and by_right are not 0 everywhere

  /// The value, of the fields at the nodes and the pressure P.
  void evaluate(const Setting& setting, const NodeFields& nodes, const Array& P);
  /// The value and the derivatives.
  void linearise(const Setting& setting, const NodeFields& nodes, const Array& P);
};

}  // namespace ehd::fast
