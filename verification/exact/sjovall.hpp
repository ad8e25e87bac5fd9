// SPDX-License-Identifier: GPL-3.0-or-later
// Sjovall's load integral: how a radial load is shared by infinitely many rollers on a rigid ring.
#pragma once

namespace ehd::verification::exact {

/// J_r(eps; n) = (1/2 pi) Int_-psi_l^psi_l (1 - (1 - cos psi)/(2 eps))^n cos psi d psi, cos psi_l = 1 - 2 eps where
/// eps < 1, else psi_l = pi. Contact law f ~ delta^n over BOTH contacts of a roller; eps = (1 - P_d/(2 delta_r))/2.
/// Then F_r = Z Q_max J_r(eps), exactly as Z -> infinity. 1/J_r(1/2; 10/9) = 4.0850.
/// Source: Sjovall 1933; any rolling bearing textbook.
struct SjovallIntegral {
  double exponent = 10.0 / 9.0;

  /// By adaptive quadrature (GSL), relative error below 1e-12. Throws std::domain_error for eps <= 0.
  [[nodiscard]] double operator()(double eps) const;
};

}  // namespace ehd::verification::exact
