// SPDX-License-Identifier: GPL-3.0-or-later
// A manufactured contact: pressure and film are chosen, and the source terms that make them the solution of the coupled
// equations follow (Roache, Verification and Validation in Computational Science and Engineering, 1998, chapter 3).
//
//   P(X) = A (X - X_a)(X* - X)^2/cosh((X - c)/w)  on X_a <= X <= X*,  A from the load,
//   H(X) = H_c + y^4/(2(d^2 + y^2)),  y = X - q:  flat in the contact, opening at X*, a parabola far away.
// P is analytic; the singularities nearest to the axis are the poles X = c +- i pi w/2. Sources (contact/problem.hpp):
//   film(X)    = H - H_0 - X^2/2 + (1/pi) J[P](X),        J[f](X) = Int_(X_a)^(X*) f(t) ln|X - t| dt,
//   film'(X)   = H' - X + (1/pi) J[P'](X),                 since P vanishes at both ends,
//   balance(X) = m P' - rho H + C,                         m = rho H^3/(eta lambda),
//   balance'(X) = F_P P' + F_P' P'' + F_H H' with the derivatives of F = m P' - rho H.
// C and H_0 are free; they are chosen so that no two of the three sources (film,
// balance, load) vanish at the same place. The film is full throughout. All formulas go on beyond X*, because a
// solver's X* is another one.
//
// The laws, lambda = 3 pi^2/(8 M^2) and alpha p_H = L sqrt(M/(2 pi)) are written here a second time, on purpose.
#pragma once

#include <complex>
#include <utility>

#include "contact/problem.hpp"

namespace ehd::verification::exact {

class Manufactured {
 public:
  struct Choice {
    double M = 0, L = 0;
    Viscosity viscosity;  ///< in units of p_H; its alpha is set to alpha p_H
    Density density;      ///< in units of p_H
    double inlet = 0, exit = 0;
    double offset = 0;                                     ///< H_0
    double flux = 0;                                       ///< C
    double load = 0;                                       ///< 2/pi Int P dX - 1
    double centre = 0, width = 0;                          ///< c, w
    double film = 0, film_centre = 0, film_roundness = 0;  ///< H_c, q, d
  };
  explicit Manufactured(const Choice& choice);
  /// Roelands, Dowson-Higginson, M = 4.3, L = 5.2, alpha p_H = 4.30.
  [[nodiscard]] static Manufactured compressible();
  /// Barus, incompressible, M = 6.1, L = 3.4, alpha p_H = 3.35.
  [[nodiscard]] static Manufactured barus();

  [[nodiscard]] const Choice& choice() const { return choice_; }
  [[nodiscard]] double lambda() const { return lambda_; }
  /// The problem as a solver takes it, sources included.
  [[nodiscard]] Problem problem() const;

  /// Value and derivatives.
  struct Jet {
    double value = 0, slope = 0, curvature = 0;
  };
  [[nodiscard]] Jet pressure(double X) const;  ///< of the formula, beyond X* too
  [[nodiscard]] Jet film(double X) const;      ///< curvature is not computed
  /// m P' - rho H, and its derivatives to P, P' and H.
  struct Flux {
    double value = 0, by_pressure = 0, by_slope = 0, by_film = 0;
    double density = 0, density_slope = 0;
  };
  [[nodiscard]] Flux flux(double P, double slope, double H) const;
  /// Value and derivative. The quadrature is granted 1e-13 absolute, NaN where that is not reached.
  [[nodiscard]] std::pair<double, double> film_source(double X) const;
  [[nodiscard]] std::pair<double, double> balance_source(double X) const;

  /// Where the pressure is singular, in the upper half plane: what limits a spectral method.
  [[nodiscard]] std::complex<double> pole() const;

 private:
  Choice choice_;
  double lambda_, amplitude_ = 1;
};

}  // namespace ehd::verification::exact
