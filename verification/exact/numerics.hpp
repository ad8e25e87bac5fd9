// SPDX-License-Identifier: GPL-3.0-or-later
// Quadrature and roots for exact solutions (GSL), to nearly the digits of double.
#pragma once

#include <functional>

namespace ehd::verification::exact {

/// By default GSL aborts the program. After this every status has to be checked instead. Never undone: the handler is
/// one for all threads.
void keep_going_on_gsl_errors();

/// Int_a^b f dx, adaptive Gauss-Kronrod with extrapolation at end-point singularities. Error below 1e-13 |value| +
/// 1e-15 by GSL's own estimate; NaN where that is not reached.
[[nodiscard]] double integral(const std::function<double(double)>& f, double a, double b);

/// Int_a^infinity f dx, likewise.
[[nodiscard]] double integral_to_infinity(const std::function<double(double)>& f, double a);

/// Int_a^b f(t) ln|X - t| dt, where f goes on analytically to X. Error below 1e-13 by GSL's own estimate; NaN where
/// that is not reached.
[[nodiscard]] double log_potential(const std::function<double(double)>& f, double a, double b, double X);

/// The root of f between a and b, where f changes sign, to 4 eps relative; NaN where it does not change sign.
[[nodiscard]] double root(const std::function<double(double)>& f, double a, double b);

}  // namespace ehd::verification::exact
