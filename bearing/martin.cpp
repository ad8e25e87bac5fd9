// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/martin.hpp"

#include <cmath>

#include "contact/hertz.hpp"

namespace ehd::bearing {

FilmAndExponent martin_film(const RacewayContact& contact, double force_N) {
  constexpr double martin = 2.4474842468;
  return {martin * contact.viscosity_Pa_s * contact.speed_sum_m_per_s * contact.reduced_radius_m * contact.length_m /
              force_N,
          -1};
}

FilmAndExponent martin_offset_film(const RacewayContact& contact, double force_N) {
  constexpr double mean_log_tangent = -0.3284612545;
  const double film = martin_film(contact, force_N).film;
  const double b = hertz::half_width_m(contact.at(force_N));
  const double deformation = b * b / (2 * contact.reduced_radius_m) / film;  // 4w/(pi E' h), grows as f^2
  const double ratio = deformation * (std::log(std::sqrt(2 * contact.reduced_radius_m * film) / b) + mean_log_tangent -
                                      2 * hertz::dry_offset());
  const double ratio_slope = 2 * ratio - deformation;  // the logarithm falls by 1 per unit of ln f
  // Far beyond its range the ratio is negative; this keeps the film positive.
  const double factor = ratio > 0 ? 1 + ratio : 1 / (1 - ratio);
  return {film * factor, -1 + ratio_slope / (1 + std::abs(ratio))};
}

}  // namespace ehd::bearing
