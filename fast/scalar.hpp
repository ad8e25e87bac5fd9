// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of linear systems: double in Newton's method, complex in harmonic motion.
#pragma once

#include <cmath>
#include <complex>
#include <type_traits>

namespace ehd::fast {

using Complex = std::complex<double>;

/// How many real products one product with a real kernel takes.
template <class Scalar>
inline constexpr int parts_of = std::is_same_v<Scalar, double> ? 1 : 2;

/// a b. Of complex numbers without the standard's care for infinite ones, which costs a comparison and a branch.
[[nodiscard]] inline double times(double a, double b) { return a * b; }
[[nodiscard]] inline Complex times(double a, Complex b) { return {a * b.real(), a * b.imag()}; }
[[nodiscard]] inline Complex times(Complex a, double b) { return times(b, a); }
[[nodiscard]] inline Complex times(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// 1/a.
[[nodiscard]] inline double inverse_of(double a) { return 1 / a; }
[[nodiscard]] inline Complex inverse_of(Complex a) { return std::conj(a) / std::norm(a); }

/// A size without a root: |a|, of complex numbers |Re a| + |Im a|.
[[nodiscard]] inline double size_of(double a) { return std::abs(a); }
[[nodiscard]] inline double size_of(Complex a) { return std::abs(a.real()) + std::abs(a.imag()); }

}  // namespace ehd::fast
