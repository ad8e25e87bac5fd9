// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/exact/ertel_grubin.hpp"

#include <cmath>

#include "contact/nondimensional.hpp"
#include "verification/exact/numerics.hpp"

namespace ehd::verification::exact {

namespace {

/// Hertz gap at X = -cosh t: (sinh 2t - 2t)/4.
double gap_at(double t) {
  if (t > 0.2) return (std::sinh(2 * t) - 2 * t) / 4;
  const double s = 4 * t * t;  // a series, because the difference would cancel; its next term is 1e-19 at t = 0.2
  return t * t * t / 3 * (1 + s / 20 * (1 + s / 42 * (1 + s / 72 * (1 + s / 110 * (1 + s / 156 * (1 + s / 210))))));
}

}  // namespace

double ertel_grubin_defect(double M, double L, double moes_film) {
  const Groups groups = groups_from(MoesGroups{.M = M, .L = L});
  const double film = moes_film / moes_film_per_hertz_film(M);
  const auto integrand = [film](double t) {
    const double gap = gap_at(t);
    return gap / std::pow(film + gap, 3) * std::sinh(t);
  };
  // The integrand peaks where gap = film/2 and falls like e^(-3t): beyond t = 40 nothing is left in double.
  const double peak = std::asinh(std::cbrt(1.5 * film));
  const double reduced_pressure = groups.lambda * (integral(integrand, 0, peak) + integral(integrand, peak, peak + 2) +
                                                   integral(integrand, peak + 2, peak + 40));
  return reduced_pressure * groups.alpha_p_H - 1;
}

double ertel_grubin_film(double M, double L) {
  // The reduced pressure falls from infinity to 0 as the film grows. Films of elastic contacts up to M = 1e6 lie
  // between Blok's rigid film and a hundredth of it; this bracket is wider.
  const double rigid = std::pow(L, 2.0 / 3);
  return root([&](double film) { return ertel_grubin_defect(M, L, film); }, 1e-3 * rigid, 1e2 * rigid);
}

}  // namespace ehd::verification::exact
