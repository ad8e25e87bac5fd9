// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/film_curve.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "bearing/martin.hpp"
#include "contact/approach.hpp"

namespace ehd::bearing {

using std::numbers::pi;

namespace {

std::vector<double> logarithms(const std::vector<double>& values, const char* name) {
  std::vector<double> logs;
  for (const double value : values) {
    if (!(value > 0) || !std::isfinite(value))
      throw std::invalid_argument(std::string("film curve: a ") + name + " is " + std::to_string(value) +
                                  "; all must be positive and finite");
    logs.push_back(std::log(value));
  }
  return logs;
}

}  // namespace

FilmCurve::FilmCurve(RacewayContact contact, std::vector<double> forces_N, const std::vector<double>& offset_films_m,
                     const std::vector<double>& minimum_films_m, CurveErrors errors)
    : contact_(contact), forces_N_(std::move(forces_N)), errors_(std::move(errors)) {
  const auto points = forces_N_.size();
  if (points < 3 || offset_films_m.size() != points || minimum_films_m.size() != points)
    throw std::invalid_argument("film curve: " + std::to_string(points) + " forces, " +
                                std::to_string(offset_films_m.size()) + " offset films and " +
                                std::to_string(minimum_films_m.size()) +
                                " minimum films; give equal numbers of each, at least three");
  if (std::adjacent_find(forces_N_.begin(), forces_N_.end(), std::greater_equal<>()) != forces_N_.end())
    throw std::invalid_argument("film curve: the forces must increase");
  const std::vector<double> log_force = logarithms(forces_N_, "force");
  offset_ = std::make_shared<const MonotoneSpline>(log_force, logarithms(offset_films_m, "offset film"));
  minimum_ = std::make_shared<const MonotoneSpline>(log_force, logarithms(minimum_films_m, "minimum film"));
}

double FilmCurve::compliance_scale() const { return 4 / (pi * contact_.reduced_modulus_Pa * contact_.length_m); }

namespace {

using MartinFilm = FilmAndExponent (*)(const RacewayContact& contact, double force_N);

/// Below the lightest point, ln F = ln F_Martin + a t^(3/2) + c t^3. Value and slope at t = 1 fix a and c.
ValueAndSlope below_lightest(const FilmCurve& curve, double force_N, MartinFilm martin, const MonotoneSpline& spline) {
  const FilmAndExponent at_joint = martin(curve.contact(), curve.lightest_N()), here = martin(curve.contact(), force_N);
  const ValueAndSlope joint = spline.at(spline.first());
  const double v = joint.value - std::log(at_joint.film), d = joint.slope - at_joint.exponent;
  const double c = (d - 1.5 * v) / 1.5, a = v - c;
  const double t = force_N / curve.lightest_N(), t15 = t * std::sqrt(t);
  const double film = here.film * std::exp(a * t15 + c * t15 * t15);
  return {film, film / force_N * (here.exponent + 1.5 * a * t15 + 3 * c * t15 * t15)};
}

ValueAndSlope evaluate(const FilmCurve& curve, double force_N, MartinFilm martin, const MonotoneSpline& spline) {
  if (force_N < curve.lightest_N()) return below_lightest(curve, force_N, martin, spline);
  const double log_force = std::log(force_N), last = spline.last();
  if (force_N <= curve.heaviest_N()) {
    const ValueAndSlope inside = spline.at(std::clamp(log_force, spline.first(), last));
    const double film = std::exp(inside.value);
    return {film, film * inside.slope / force_N};
  }
  const ValueAndSlope end = spline.at(last);
  const double film = std::exp(end.value + end.slope * (log_force - last));
  return {film, film * end.slope / force_N};
}

}  // namespace

ValueAndSlope FilmCurve::offset_film(double force_N) const {
  return evaluate(*this, force_N, martin_offset_film, *offset_);
}
double FilmCurve::rise_m(double force_N) const {
  // delta_dry = (4 f/(pi E' l)) [ln(2 x_0/b) + 1/2], b ~ sqrt(f)
  const double dry_m = dry_approach_m(contact_.at(force_N), contact_.length_m);
  return dry_m - compliance_scale() * force_N / 2 - force_N * offset_film(force_N).slope;
}
ValueAndSlope FilmCurve::minimum_film(double force_N) const { return evaluate(*this, force_N, martin_film, *minimum_); }

}  // namespace ehd::bearing
