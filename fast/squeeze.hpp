// SPDX-License-Identifier: GPL-3.0-or-later
// The squeeze of oil in a small motion of amplitude e^(s T) about a steady state, s the rate: i Omega, or real.
// Reynolds' equation with squeeze, dF/dX = -d(rho H)/dT, integrated from face i to the exit, where P = P' = 0:
//
//   F_i - rho_n H_n = Int_(X_f)^X* d(rho H)/dT dX = dN_i/dT - rho_n H_n dX*/dT + (rho H)_f dX_f/dT,
//
// N_i = Int rho H dX between two moving ends, of which face i moves with dX_f = phi_f dX*. On the nodes
// N_i = Sum_(j > i) w_j (rho H)_j with w_j = l phi'_j/n, half of that for the node at the exit. To first order the flux
// error e_i of a steady state becomes e_i - s Q_i,
//
//   Q_i = Sum_(j > i) w_j m_j + a_i dX*,  m_j = rho'_j H_j dP_j + rho_j dH_j,
//   a_i = (1/l) Sum_(j > i) w_j (rho H)_j + phi_f (rho H)_f - rho_n H_n;  f: mean of two nodes.
//
// Between two faces only the oil of one node remains: Q_(i-1) - Q_i = w_i m_i + (a_(i-1) - a_i) dX*.
#pragma once

#include "contact/array.hpp"
#include "fast/state.hpp"

namespace ehd::fast {

struct NodeFields;

/// Coefficients of Q. Storage is used again.
struct Squeeze {
  Array by_pressure;          ///< w_j rho'_j H_j, n + 1; with half of w also at the first node
  Array by_film;              ///< w_j rho_j, n + 1
  Array by_exit;              ///< a_i, n faces
  double inflow_by_exit = 0;  ///< a_i at X_a in place of a face

  void linearise(const NodeFields& nodes);
  /// Takes s Q off the flux errors of a change.
  template <class Scalar>
  void subtract(Scalar rate, const StepOf<Scalar>& step, ChangeOf<Scalar>& change) const;
  /// Q at X_a in place of a face.
  template <class Scalar>
  [[nodiscard]] Scalar inflow(const StepOf<Scalar>& step, const ArrayOf<Scalar>& film) const;
};

}  // namespace ehd::fast
