// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes that follow a narrow spike. A spike that is narrower than a cell moves every number of a grid with its place in
// that cell, by h times a function of period h. So the derivative of such a number by a motion that moves the spike is
// off by as much on every grid: at (10, 21) the lag by up to 1.3 % on 128 as on 1024 intervals. Where the nodes move
// with the spike, it keeps its place between them, and the derivative converges as h^2.
//
// The nodes move by m, in s of the map, each by its part dphi_i = m dphi_i/dm. To first order
//
//   (J - s Q) u + m (R_m - s q) = drive,
//   q_i = Sum_(j > i) (dw_j (rho H)_j + w_j rho_j dH_j) + (rho H)_f dX_f, as Q of squeeze.hpp.
//
// Exact derivatives do not depend on m, discrete ones do. m is chosen so that almost nothing of u is left under the
// spike.
#pragma once

#include "contact/array.hpp"
#include "fast/state.hpp"

namespace ehd::fast {

struct Counters;
struct Grid;

/// Derivatives by m at fixed P, H_0 and X*.
struct MovedNodes {
  Residual error;     ///< of the flux errors and of the load error: R_m
  Array place;        ///< of phi_i, n + 1
  Array film;         ///< of H_i, n + 1
  Array squeeze;      ///< q_i without its terms with dH_j, n faces
  double inflow = 0;  ///< the squeeze at X_a: q there, likewise
  double moment = 0;  ///< of Int P X dX, for the moving tail
};

/// Derivatives by a central difference: `state` on two grids, whose maps have moved by `step` and by -step. NaN where
/// one of them has no film. A one-sided difference is not enough: at (974, 10.8) a step of 1e-6 left 2e-4 in the lag.
[[nodiscard]] MovedNodes moved_nodes(const Setting& setting, const State& state, Grid& own, Grid& forward, Grid& back,
                                     double step, Counters& counters);

/// The m that makes u + m w smallest; w is the pressure's answer to m = 1. Weighted by |w|^2, so that the spike alone
/// counts.
template <class Scalar>
[[nodiscard]] Scalar shift_with_spike(const ArrayOf<Scalar>& u, const ArrayOf<Scalar>& w) {
  const Array weight = w.abs2();
  return -(weight * w.conjugate() * u).sum() / weight.square().sum();
}

}  // namespace ehd::fast
