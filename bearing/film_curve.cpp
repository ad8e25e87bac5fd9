// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/film_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "bearing/martin.hpp"
#include "contact/approach.hpp"

namespace ehd::bearing {

using std::numbers::pi;

FilmCurve::FilmCurve(RacewayContact contact, std::vector<double> forces_N, const std::vector<double>& offset_films_m,
                     const std::vector<double>& minimum_films_m, CurveErrors errors,
                     const std::vector<double>& rolling_forces_N_per_m)
    : contact_(contact),
      forces_N_(std::move(forces_N)),
      offset_(contact, forces_N_, offset_films_m, martin_offset_film, "offset film"),
      minimum_(contact, forces_N_, minimum_films_m, martin_film, "minimum film"),
      errors_(std::move(errors)) {
  if (!rolling_forces_N_per_m.empty())
    rolling_.emplace(contact, forces_N_, rolling_forces_N_per_m, martin_rolling_force, "rolling force");
}

double FilmCurve::compliance_scale() const { return 4 / (pi * contact_.reduced_modulus_Pa * contact_.length_m); }

ValueAndSlope FilmCurve::offset_film(double force_N) const { return offset_.at(force_N); }
ValueAndSlope FilmCurve::minimum_film(double force_N) const { return minimum_.at(force_N); }
std::optional<double> FilmCurve::rolling_force_N_per_m(double force_N) const {
  return rolling_ ? std::optional(rolling_->at(force_N).value) : std::nullopt;
}

double FilmCurve::rise_m(double force_N) const {
  // delta_dry = (4 f/(pi E' l)) [ln(2 x_0/b) + 1/2], b ~ sqrt(f)
  const double dry_m = dry_approach_m(contact_.at(force_N), contact_.length_m);
  return dry_m - compliance_scale() * force_N / 2 - force_N * offset_film(force_N).slope;
}

double FilmCurve::force_error(double force_N) const {
  return (force_N < lightest_N() ? errors_.joint_force : errors_.interpolation_force) +
         errors_.solver_offset_film * film_part(force_N);
}

double FilmCurve::compliance_error(double force_N) const {
  const double part = film_part(force_N), solver = errors_.solver_offset_film * part;
  constexpr double steepest_below = 3;  // the error falls like f^3 at most
  if (force_N < lightest_N()) return steepest_below * (std::min(errors_.joint_force, errors_.joint * part) + solver);
  const auto inside = std::upper_bound(forces_N_.begin(), forces_N_.end() - 1, force_N);
  const double gap = std::log(*inside / *(inside - 1));
  constexpr double steepest_inside = 6 * std::numbers::sqrt3;
  return steepest_inside * (std::min(errors_.interpolation_force, errors_.interpolation * part) + solver) / gap;
}

}  // namespace ehd::bearing
