// SPDX-License-Identifier: GPL-3.0-or-later
// The dry contact from its integral: the film of Hertz's pressure, by quadrature of the logarithmic kernel.
#pragma once

namespace ehd::verification::exact {

/// X^2/2 - (1/pi) Int_-1^1 sqrt(1 - t^2) ln|X - t| dt, by quadrature to 1e-12: -H_0,dry plus the gap. It uses none of
/// the closed forms in contact/hertz.hpp, which it checks.
[[nodiscard]] double hertz_film_by_quadrature(double X);

}  // namespace ehd::verification::exact
