// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/exact/martin.hpp"

#include <cmath>
#include <numbers>

#include "verification/exact/numerics.hpp"

namespace ehd::verification::exact {

using std::numbers::pi;

namespace {

/// Int_-pi/2^g cos^2 and cos^4.
double cos_2(double g) { return (g + pi / 2) / 2 + std::sin(2 * g) / 4; }
double cos_4(double g) { return 3 * (g + pi / 2) / 8 + std::sin(2 * g) / 4 + std::sin(4 * g) / 32; }

/// Int_-pi/2^g (cos^2 - k cos^4).
double wedge_integral(double g, double k) { return cos_2(g) - k * cos_4(g); }

double exit_film_at(double angle) { return 1 / (std::cos(angle) * std::cos(angle)); }

}  // namespace

Martin::Martin() {
  exit_angle = root([](double g) { return wedge_integral(g, exit_film_at(g)); }, 0.1, 1.0);
  exit = std::tan(exit_angle);
  exit_film = exit_film_at(exit_angle);
  // w = -Int x dp: Int tan g (cos^2 g - k cos^4 g) dg = -cos^2 g_c/4 with k = 1/cos^2 g_c.
  load_mean = 6 / exit_film;
  load_sum = load_mean / 2;
  pressure_max = pressure(-exit_angle);
  pressure_at_0 = pressure(0);
  // F_t = (1/2) Int h dp = 3 eta u_s sqrt(2R/h_0) Int (1 - k cos^2 g) dg, with h_0 from the load.
  const double film_over_pressure = std::abs(exit_angle + pi / 2 - exit_film * cos_2(exit_angle));
  rolling_force = 3 * std::sqrt(2 / load_sum) * film_over_pressure;
  const double I_0 = cos_4(exit_angle), I_1 = -std::pow(std::cos(exit_angle), 4) / 4, I_2 = cos_2(exit_angle) - I_0;
  damping = 12 * std::pow(2, 1.5) * (I_2 - I_1 * I_1 / I_0);
}

double Martin::pressure(double angle) const { return 12 * wedge_integral(angle, exit_film); }

MartinContact::MartinContact(double M) {
  const Martin martin;
  const double hertz_per_moes = pi / (8 * M);
  const double lambda = 3 * pi * pi / (8 * M * M);
  moes_minimum = martin.load_sum / M;
  moes_couette = moes_minimum * martin.exit_film;
  hertz_minimum = moes_minimum * hertz_per_moes;
  hertz_couette = moes_couette * hertz_per_moes;
  const double length = std::sqrt(2 * hertz_minimum);
  hertz_exit = length * martin.exit;
  // 12 eta u_m R^2/(b^3 p_H) = lambda.
  hertz_pressure_max = martin.pressure_max / 12 * lambda * length / (hertz_minimum * hertz_minimum);
  // F_t/(E'R) = T* W (2/pi) sqrt(8 W/pi).
  rolling_force = martin.rolling_force / (M * (2 / pi) * std::sqrt(8 / pi));
}

double half_sommerfeld_load() {
  // h_exit = 4/3 h_0 makes the pressure antisymmetric; its positive half, x < 0: -24 Int tan g (cos^2 - 4/3 cos^4) dg.
  return 24 * (1.0 / 2 - (4.0 / 3) / 4);
}

}  // namespace ehd::verification::exact
