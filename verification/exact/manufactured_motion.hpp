// SPDX-License-Identifier: GPL-3.0-or-later
// A manufactured small motion about a manufactured contact (manufactured.hpp): the amplitudes of pressure and film are
// chosen, and the sources that make them the solution of the first-order equations (contact/response.hpp) follow.
//
//   P_1(X) = (X - X_a)(X* - X)(a + b X)/cosh((X - c)/w),  c and w those of the steady pressure,
//   H_1(X) = e + f e^(-i q X),
//   R_1(X) = H_1 - H_01 + (1/pi) Int P_1(X') ln|X - X'| dX',
//   g_1(X) = [m P' - rho H]_1 + C_1 + i Omega Int_X^X* (rho H)_1 dX',  W_1 = Int P_1 dX.
// H_01 and C_1 are free. The exit moves by X*_1 = -P_1'(X*)/P_0''(X*). The steady contact is the given one, with
// C = rho H at the exit: the oil that the moving exit leaves behind is then what the steady flux carries away, as in a
// problem without sources. All formulas go on beyond X*.
#pragma once

#include <complex>

#include "verification/exact/manufactured.hpp"

namespace ehd::verification::exact {

class ManufacturedMotion {
 public:
  using Complex = std::complex<double>;
  struct Choice {
    double Omega = 0;
    Complex pressure, pressure_slope;  ///< a, b
    Complex offset;                    ///< H_01
    Complex flux;                      ///< C_1
    Complex film, film_wave;           ///< e, f
    double wavenumber = 0;             ///< q
  };
  ManufacturedMotion(const Manufactured& contact, const Choice& choice);
  /// Omega = 2.3 about Manufactured::compressible() or Manufactured::barus().
  [[nodiscard]] static ManufacturedMotion about(const Manufactured& contact);

  [[nodiscard]] const Manufactured& steady() const { return steady_; }
  [[nodiscard]] const Choice& choice() const { return choice_; }

  struct Jet {
    Complex value, slope;
  };
  [[nodiscard]] Jet pressure(double X) const;
  [[nodiscard]] Complex film(double X) const;
  [[nodiscard]] Complex exit() const;  ///< X*_1
  [[nodiscard]] Complex load() const;  ///< W_1
  /// Of a point that moves with by_exit X*_1, 0 at the inlet and 1 at the exit.
  [[nodiscard]] Complex moving_pressure(double X, double by_exit) const;

  [[nodiscard]] Complex feature(double X) const;         ///< R_1
  [[nodiscard]] Complex balance_source(double X) const;  ///< g_1

 private:
  Manufactured steady_;
  Choice choice_;
};

}  // namespace ehd::verification::exact
