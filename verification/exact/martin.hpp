// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid cylinder on a plane, isoviscous, incompressible, Reynolds exit (Martin 1916).
//
// With x = sqrt(2 R h_0) tan g and h = h_0/cos^2 g, Reynolds' equation dp/dx = 12 eta u_m (h - h_exit)/h^3 integrates
// to
//   p(g) = 12 eta u_m sqrt(2 R h_0)/h_0^2 Int_-pi/2^g (cos^2 t - cos^4 t/cos^2 g_c) dt,
// and p = 0 at the exit g_c, where dp/dx = 0 too, fixes g_c.
#pragma once

namespace ehd::verification::exact {

/// The numbers that do not depend on the load, computed from the exit equation.
struct Martin {
  Martin();

  double exit_angle = 0;     ///< g_c, rad: 25.41379133 degrees
  double exit = 0;           ///< X_c = tan g_c, in sqrt(2 R h_0): 0.4751299200930562
  double exit_film = 0;      ///< h_exit/h_0 = 1/cos^2 g_c: 1.225748441
  double load_mean = 0;      ///< h_0 w/(eta u_m R) = 6 cos^2 g_c: 4.894968494
  double load_sum = 0;       ///< the same with u_s: 2.447484
  double pressure_max = 0;   ///< p_max h_0^2/(eta u_m sqrt(2 R h_0)), found at -X_c: 1.520945584
  double pressure_at_0 = 0;  ///< likewise at x = 0: half of it
  double rolling_force = 0;  ///< F_t/(E'R sqrt(U_s W)): 1.470515
  /// Damping of small vertical motion per length, over eta (R/h_0)^(3/2): 6.548275819. With the speed V of separation
  /// dp/dx = 12 eta (V x + constant)/h^3 between p = 0 at both ends, so that w = -12 2^(3/2) B eta V (R/h_0)^(3/2),
  /// B = I_2 - I_1^2/I_0, I_k = Int tan^k g cos^4 g dg from -pi/2 to g_c. It does not depend on the frequency.
  double damping = 0;

  /// p h_0^2/(eta u_m sqrt(2 R h_0)) at x = sqrt(2 R h_0) tan(angle), angle in [-pi/2, g_c].
  [[nodiscard]] double pressure(double angle) const;
};

/// Martin's contact at Moes' load group M (L = 0, M -> 0), films in Moes units and in Hertz units. The elastic
/// contact differs from it by O(M^2).
struct MartinContact {
  explicit MartinContact(double M);

  double moes_minimum = 0;   ///< 2.447484/M
  double moes_couette = 0;   ///< 3/M, exactly
  double hertz_minimum = 0;  ///< times pi/(8M)
  double hertz_couette = 0;
  double hertz_exit = 0;          ///< X* = sqrt(2 H_min) X_c
  double hertz_pressure_max = 0;  ///< P = p/p_H
  double rolling_force = 0;       ///< T* = 1.4475/M
};

/// h_0 w/(eta u_m R) where the positive half of the antisymmetric pressure carries the load: 4.
[[nodiscard]] double half_sommerfeld_load();

}  // namespace ehd::verification::exact
