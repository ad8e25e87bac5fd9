// SPDX-License-Identifier: GPL-3.0-or-later
// The dimensionless problem that a solver sees, in Hertz scaling:
//   d/dX( rho H^3/(eta lambda) dP/dX ) = d(rho H)/dX  on X_a < X < X*,  P(X*) = P'(X*) = 0,
//   H(X) = H_0 + X^2/2 - (1/pi) Int P(X') ln|X - X'| dX',   Int P dX = pi/2.
// X = x/b, P = p/p_H, H = h R/b^2.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <optional>
#include <utility>
#include <vector>

#include "contact/conditions.hpp"
#include "contact/rheology.hpp"

namespace ehd {

/// M and L with the sum speed (Moes); lambda = 3 pi^2/(8 M^2); alpha p_H = L sqrt(M/(2 pi)).
struct Groups {
  double M = 0;
  double L = 0;
  double lambda = 0;
  double alpha_p_H = 0;
};

/// The quantities that can be asked for; names as in case files (to_string).
enum class Quantity {
  film_minimum,
  film_central,
  film_couette,
  film_offset,
  pressure_maximum,
  pressure_spike,
  pressure_exit,
  approach,
  rolling_force,
  load_error,
  flux_variation,
};
inline constexpr Quantity all_quantities[] = {
    Quantity::film_minimum,   Quantity::film_central,  Quantity::film_couette, Quantity::film_offset,
    Quantity::pressure_maximum, Quantity::pressure_spike, Quantity::pressure_exit, Quantity::approach,
    Quantity::rolling_force,  Quantity::load_error,    Quantity::flux_variation};

[[nodiscard]] std::string_view to_string(Quantity quantity);  ///< "film.minimum", …
[[nodiscard]] std::optional<Quantity> quantity_from(std::string_view text);

/// The quantities that a caller asks for; what is not wanted is not computed.
using Wanted = std::set<Quantity>;
[[nodiscard]] Wanted want_everything();

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
