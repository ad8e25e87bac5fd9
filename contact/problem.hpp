// SPDX-License-Identifier: GPL-3.0-or-later
// The dimensionless problem that a solver sees, in Hertz scaling:
//   d/dX( rho H^3/(eta lambda) dP/dX ) = d(rho H)/dX  on X_a < X < X*,  P(X*) = P'(X*) = 0,
//   H(X) = H_0 + X^2/2 - (1/pi) Int P(X') ln|X - X'| dX',   Int P dX = pi/2.
// X = x/b, P = p/p_H, H = h R/b^2.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "contact/conditions.hpp"
#include "contact/quantities.hpp"
#include "contact/rheology.hpp"

namespace ehd {

/// M and L with the sum speed (Moes); lambda = 3 pi^2/(8 M^2); alpha p_H = L sqrt(M/(2 pi)).
struct Groups {
  double M = 0;
  double L = 0;
  double lambda = 0;
  double alpha_p_H = 0;
};

/// Source terms, which make a chosen state the solution (method of manufactured solutions). Functions of X with their
/// derivatives, since X* is an unknown.
template <class Scalar>
struct SourcesOf {
  using Differentiable = std::function<std::pair<Scalar, Scalar>(const Scalar& X)>;
  Differentiable film;     ///< added to H(X)
  Differentiable balance;  ///< eps P' - rho H + C = balance(X), so that C = rho H + balance at X*
  Scalar load{0};          ///< 2/pi Int P dX = 1 + load
};
using Sources = SourcesOf<double>;

struct Problem {
  Groups groups;
  Viscosity viscosity;  ///< for pressures in units of p_H
  Density density;      ///< for pressures in units of p_H
  Inlet inlet;
  Wanted wanted = want_everything();
  /// Empty in every physical problem; only verification sets it.
  std::shared_ptr<const Sources> sources = {};
};

}  // namespace ehd
