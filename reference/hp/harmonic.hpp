// SPDX-License-Identifier: GPL-3.0-or-later
// The first-order equations of a small harmonic motion about one solved discretisation.
//
// Derivation. Reynolds' equation with squeeze, (mobility P' - rho H)' = d(rho H)/dT, is integrated from X to the exit,
// where P = P' = 0 and rho H = C:
//   mobility P' - rho H + C + Int_X^X* d(rho H)/dT dX' = 0.
// The mesh moves with X*: a point of fixed xi has dX/dX* = V = 1 + xi/T, which is 1 at the exit. With
// N(xi) = Int_X^X* rho H dX' between two moving ends
//   Int_X^X* d(rho H)/dT dX' = dN/dT - C dX*/dT + V rho H dX*/dT.
// So Newton's own unknowns u = (P_1, H_01, C_1, X*_1), all at fixed xi, satisfy
//   (J + i Omega K) u = drive.
// J is the Jacobian of the steady equations. At the collocation points
//   K u = N_1 + (V rho H - C) X*_1,
//   N_1 = Int_X^X* (rho' H P_1 + rho H_1) dX' + X*_1/(X* - X_a) Int_X^X* rho H dX'.
// An integrand is the polynomial through its values at the collocation points and at the right end of each element.
// J's row of the load is (2/pi) W_1, so that a drive of 2/pi there means W_1 = 1.
//
// Flooded. Before X_a = -x, H = y^2/2 and mobility = H^3/lambda at X = -y. To leading order
//   dP_1/dX = -8 lambda/y^6 [ C_1 + i Omega N_1(X_a) + i Omega Int_x^y H_1 dy' ] + terms of J,
//   H_1 = H_1(X_a) - (W_1/pi) ln(y/x).
// C_1 is in J too. The integrals of the other terms, i Omega K u, are
//   of P_1(X_a): -i Omega lambda [ 8 N_1(X_a)/(5 x^5) + (2/5 H_1(X_a) - W_1/(10 pi))/x^4 ],
//   of the load: -i Omega lambda [ 2 N_1(X_a)/(5 x^4) + (4/15 H_1(X_a) - 11/90 W_1/pi)/x^3 ].
// This load, spread like y^-4, deflects the surface within. What is neglected is smaller by (ln y)/y^2.
//
// Only double is offered. Rounding changes kappa by 1e-12 at (5, 5). The certified error is 1e-8.
#pragma once

#include <complex>
#include <optional>
#include <utility>
#include <vector>

#include "contact/response.hpp"
#include "reference/hp/homotopy.hpp"

namespace ehd::reference::hp {

using Complex = std::complex<double>;
using ComplexVector = VectorOf<Complex>;

/// u for a load of amplitude 1 to first order in the frequency: u_0 + i Omega u_1.
struct SlowMotion {
  VectorOf<double> u_0, u_1;
};

/// The first-order equations about `steady`, which has no sources. u: n + 3 entries, as the columns of J.
class Harmonic {
 public:
  Harmonic(const Problem& problem, Resolved steady);

  /// u for a load of amplitude 1, R_1 = 0.
  [[nodiscard]] const ComplexVector& of_load(double Omega) const;
  /// u for a waviness of amplitude 1 at a constant load.
  [[nodiscard]] const ComplexVector& of_waviness(const Waviness& waviness) const;
  /// What drives a motion besides the bodies.
  struct Sources {
    ArrayOf<Complex> feature;  ///< R_1 at the rows
    ComplexVector balance;     ///< at the n collocation points, then at the exit
    Complex load = 0;          ///< W_1
  };
  [[nodiscard]] ComplexVector of_sources(double Omega, const Sources& sources) const;
  [[nodiscard]] const SlowMotion& of_slow_load() const;
  /// K u.
  [[nodiscard]] VectorOf<double> squeeze(const VectorOf<double>& u) const { return K_ * u; }

  [[nodiscard]] int intervals() const { return steady_.equations->intervals(); }
  [[nodiscard]] const Resolved& steady() const { return steady_; }
  /// H_01 of a u, real or complex.
  [[nodiscard]] auto offset(const auto& u) const { return u[intervals()]; }
  /// H_1 at the fixed place X = 0, without R_1. Empty where the contact does not reach X = 0.
  [[nodiscard]] std::optional<Complex> central_film(const ComplexVector& u, double Omega) const;

  /// The error of each element over the allowed one: above 1 the element is to be split. `film`: the error that one
  /// element may cause in the amplitude of the film, relative to `amplitude`.
  [[nodiscard]] std::vector<double> excess(const ComplexVector& u, double Omega, double film, double amplitude,
                                           const Waviness* waviness = nullptr) const;

 private:
  void add_squeeze();
  void add_tail();
  [[nodiscard]] ComplexVector solved(double Omega, const ComplexVector& drive) const;
  /// dH at the rows for a change u, without R_1.
  [[nodiscard]] ComplexVector film_change(const ComplexVector& u, double Omega) const;
  /// R_1 at the rows.
  [[nodiscard]] ArrayOf<Complex> feature(const Waviness& waviness) const;
  /// Int_X^X* dX' of functions that are given at the rows, at the collocation points and, last, at the inlet.
  template <class AtRows>
  [[nodiscard]] AtRows integrals_to_exit(const AtRows& at_rows) const;

  Resolved steady_;
  double lambda_, stretching_;
  ArrayOf<double> by_film_;       ///< d balance/dH, rows
  ArrayOf<double> coordinate_;    ///< V, rows
  MatrixOf<double> film_, mass_;  ///< dH/du and d(rho H)/du, rows x (n + 3)
  MatrixOf<double> J_, K_;
  VectorOf<double> inflow_;        ///< K u at X_a
  VectorOf<double> tail_load_;     ///< the tail's load is i Omega tail_load_ . u; 0 where the inlet is cut
  ArrayOf<double> tail_film_;      ///< film that a tail's load of 1 causes, rows
  VectorOf<double> tail_squeeze_;  ///< Int_X^X* rho tail_film_ dX', at the points

  /// The last answer of each kind. A caller asks for one several times: first where it needs a finer mesh, then for its
  /// amplitude, its lag and how it moves with the floor. References to it are valid until the next question of its
  /// kind.
  mutable std::optional<std::pair<double, ComplexVector>> of_load_ = {};
  mutable std::optional<std::pair<Waviness, ComplexVector>> of_waviness_ = {};
  mutable std::optional<SlowMotion> of_slow_load_ = {};
};

}  // namespace ehd::reference::hp
