// SPDX-License-Identifier: GPL-3.0-or-later
// Film and lubricant at the nodes X_i = X_a + l phi_i, l = X* - X_a:
//
//   H_i = H_0 + X_i^2/2 - (l/pi) (Sum_j K_ij P_j + ln l Int P dphi) (+ deflection by the far inlet)
//
// and ln eta, rho and 1/eta of the pressure there.
#pragma once

#include <algorithm>
#include <array>

#include "contact/array.hpp"
#include "contact/rheology.hpp"
#include "fast/grid.hpp"
#include "fast/state.hpp"

namespace ehd::fast {

struct Counters;

/// Arrays have n + 1 entries, one a node; their storage is used again.
struct NodeFields {
  int n = 0;
  Grid* grid = nullptr;
  double length = 0;            ///< l = X* - X_a
  Array product;                ///< K P over the inner nodes
  double product_integral = 0;  ///< Int P dphi over the inner nodes
  Array deflection;             ///< Int P ln|X_i - X'| dX' over the grid
  double integral = 0;          ///< Int P dphi over the grid
  Array H;
  LawValues<double> log_viscosity, density;
  Array fluidity;                              ///< 1/eta
  std::array<double, 5> tail_deflection = {};  ///< by the far inlet: coefficients of 1, X, …, X^4

  /// deflection, integral and H of the state; `product` and `product_integral` must belong to its pressure already.
  /// Sets the pressure at both ends. False where the film is not positive everywhere.
  [[nodiscard]] bool evaluate_film(const Setting& setting, State& state, Grid& on);
  /// The laws of viscosity and density at the pressure P.
  void evaluate_laws(const Setting& setting, const Array& P, Counters& counters);
  /// The fields of a finer grid at the nodes of this one: what a coarse level needs to linearise. Every second node
  /// where `fine` has twice the intervals, else linear interpolation. `pressure` becomes `fine_pressure` at these
  /// nodes.
  void inject(const NodeFields& fine, const Array& fine_pressure, Array& pressure, Grid& on);

  /// X_i.
  [[nodiscard]] Array places(double inlet) const { return inlet + length * grid->place; }
  /// A node next to X = 0.
  [[nodiscard]] Eigen::Index centre(double inlet) const {
    const auto at = std::lower_bound(grid->place.begin(), grid->place.end(), -inlet / length);
    return std::min<Eigen::Index>(at - grid->place.begin(), n);
  }
  /// rho_n H_n.
  [[nodiscard]] double exit_flux() const { return density.value[n] * H[n]; }
};

}  // namespace ehd::fast
