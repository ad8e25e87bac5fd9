// SPDX-License-Identifier: GPL-3.0-or-later
// Where a graded grid puts its nodes: a smooth density adapted to the solution.
#pragma once

#include "reference/study.hpp"

namespace ehd::reference {

/// The node density is ds/dX with
///   s(X) = asinh(X/(0.7 l)) + bump(X + l; d l) + 3 atan((X + l(1+d))/(2 d l)) + bump(X - X_sp; w_sp),
///   bump(x; w) = asinh(x/w) - asinh(x/(3 l)), whose density 1/sqrt(x^2 + w^2) - 1/sqrt(x^2 + 9 l^2) is local.
/// l = max(1, sqrt(2 H_c)), d = min(H_c, 1)^(2/3). The wedge's k is -0.5 tanh(4X/l): 0.5 in the inlet, -0.5 at the
/// spike. With k = 0 throughout, one of 400 points fails; with this k none. Nodes are equally spaced in s between inlet
/// and exit, so that n, 2n, 4n … are nested grids of one map.
struct GradedMap {
  double inlet = 0;                                       ///< X_a
  double exit = 0;                                        ///< X* of the solution that the map was made from
  double length = 1;                                      ///< l
  double inlet_zone = 1;                                  ///< d = min(H_c, 1)^(2/3), in units of l
  double spike = 1;                                       ///< X_sp, where the pressure falls most steeply
  double spike_width = 1;                                 ///< w_sp
  [[nodiscard]] double density_integral(double X) const;  ///< s(X)
  [[nodiscard]] Grid grid(int intervals) const;
};

/// A map made from a film formula alone. central_film: Hertz units.
[[nodiscard]] GradedMap first_map(double inlet, double central_film);
/// A map made from a solution on a coarser grid.
[[nodiscard]] GradedMap adapted_map(const State& state, const Evaluation& at);

}  // namespace ehd::reference
