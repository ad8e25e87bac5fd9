// SPDX-License-Identifier: GPL-3.0-or-later
// The lubricated contact at vanishing load: a rigid cylinder in an isoviscous oil (Martin 1916). The curves of solved
// contacts go over to it at light load (continued_spline.hpp).
#pragma once

#include "bearing/geometry.hpp"

namespace ehd::bearing {

/// A positive number and its exponent d ln(value)/d ln(f).
struct ValueAndExponent {
  double value = 0, exponent = 0;
};

/// h_min = 2.447484 eta_0 u_s R l/f [m].
[[nodiscard]] ValueAndExponent martin_film(const RacewayContact& contact, double force_N);
/// The offset film of that contact [m]. The bodies deform under Martin's pressure, taken to first order:
///   F = h_min + (4w/(pi E')) [ ln(sqrt(2 R h_min)/b) + m - 2 H_0,dry ],
/// m = -0.3284613 is the mean of ln|tan g| weighted by the pressure, with x = sqrt(2 R h_min) tan g. Where the
/// deformation is not small, the value stays positive but has no meaning.
[[nodiscard]] ValueAndExponent martin_offset_film(const RacewayContact& contact, double force_N);
/// The rolling force F_t = |Int h p' dx|/2 = 1.470515 sqrt(eta_0 u_s w), w = f/l, per length [N/m].
[[nodiscard]] ValueAndExponent martin_rolling_force(const RacewayContact& contact, double force_N);
/// kappa_0 of contact/response.hpp: the load goes as 1/h_min, so that kappa_0 = (pi/2) b^2/(R h_min).
[[nodiscard]] ValueAndExponent martin_kappa_0(const RacewayContact& contact, double force_N);
/// The lag kappa_1/kappa_0^2. kappa_1 is the damping per length, 6.548276 eta_0 (R/h_min)^(3/2), over E' b/(2 u_s). It
/// holds at any frequency.
[[nodiscard]] ValueAndExponent martin_lag(const RacewayContact& contact, double force_N);

}  // namespace ehd::bearing
