// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/martin.hpp"

#include <cmath>
#include <numbers>

#include "contact/hertz.hpp"

namespace ehd::bearing {

namespace {

ValueAndExponent martin_kappa_1(const RacewayContact& contact, double force_N) {
  constexpr double damping = 6.5482758191;
  const double b = hertz::half_width_m(contact.at(force_N)), film = martin_film(contact, force_N).value;
  const double c = damping * contact.viscosity_Pa_s * std::pow(contact.reduced_radius_m / film, 1.5);
  return {2 * c * contact.speed_sum_m_per_s / (contact.reduced_modulus_Pa * b), 1};
}

}  // namespace

ValueAndExponent martin_film(const RacewayContact& contact, double force_N) {
  constexpr double martin = 2.4474842468;
  return {martin * contact.viscosity_Pa_s * contact.speed_sum_m_per_s * contact.reduced_radius_m * contact.length_m /
              force_N,
          -1};
}

ValueAndExponent martin_offset_film(const RacewayContact& contact, double force_N) {
  constexpr double mean_log_tangent = -0.3284612545;
  const double film = martin_film(contact, force_N).value;
  const double b = hertz::half_width_m(contact.at(force_N));
  const double deformation = b * b / (2 * contact.reduced_radius_m) / film;  // 4w/(pi E' h), grows as f^2
  const double ratio = deformation * (std::log(std::sqrt(2 * contact.reduced_radius_m * film) / b) + mean_log_tangent -
                                      2 * hertz::dry_offset());
  const double ratio_slope = 2 * ratio - deformation;  // the logarithm falls by 1 per unit of ln f
  // Far beyond its range the ratio is negative; this keeps the film positive.
  const double factor = ratio > 0 ? 1 + ratio : 1 / (1 - ratio);
  return {film * factor, -1 + ratio_slope / (1 + std::abs(ratio))};
}

ValueAndExponent martin_rolling_force(const RacewayContact& contact, double force_N) {
  constexpr double rolling = 1.4705152789;
  return {rolling * std::sqrt(contact.viscosity_Pa_s * contact.speed_sum_m_per_s * force_N / contact.length_m), 0.5};
}

ValueAndExponent martin_kappa_0(const RacewayContact& contact, double force_N) {
  const double b = hertz::half_width_m(contact.at(force_N)), film = martin_film(contact, force_N).value;
  return {std::numbers::pi / 2 * b * b / (contact.reduced_radius_m * film), 2};  // b^2 ~ f, film ~ 1/f
}

ValueAndExponent martin_lag(const RacewayContact& contact, double force_N) {
  const ValueAndExponent stiffness = martin_kappa_0(contact, force_N), damping = martin_kappa_1(contact, force_N);
  return {damping.value / (stiffness.value * stiffness.value), damping.exponent - 2 * stiffness.exponent};
}

}  // namespace ehd::bearing
