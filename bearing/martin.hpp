// SPDX-License-Identifier: GPL-3.0-or-later
// The lubricated contact at vanishing load: a rigid cylinder in an isoviscous oil (Martin 1916). The curve of solved
// contacts goes over to it at light load (film_curve.hpp).
#pragma once

#include "bearing/geometry.hpp"

namespace ehd::bearing {

/// A film [m] and its exponent d ln(film)/d ln(f).
struct FilmAndExponent {
  double film = 0, exponent = 0;
};

/// h_min = 2.447484 eta_0 u_s R l/f.
[[nodiscard]] FilmAndExponent martin_film(const RacewayContact& contact, double force_N);
/// The offset film of that contact. The bodies deform under Martin's pressure, taken to first order:
///   F = h_min + (4w/(pi E')) [ ln(sqrt(2 R h_min)/b) + m - 2 H_0,dry ],
/// m = -0.3284613 is the mean of ln|tan g| weighted by the pressure, with x = sqrt(2 R h_min) tan g. Where the
/// deformation is not small, the value stays positive but has no meaning.
[[nodiscard]] FilmAndExponent martin_offset_film(const RacewayContact& contact, double force_N);

}  // namespace ehd::bearing
