// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/film_curve.hpp"

#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <set>
#include <stdexcept>

#include "contact/hertz.hpp"

namespace ehd::bearing {

using std::numbers::pi;

const ContactResult& SolvedContacts::at(double force_N) {
  const auto known = results_.find(force_N);
  if (known != results_.end()) {
    ++recalls_;
    return known->second;
  }
  ++solves_;
  return results_.emplace(force_N, solve_(force_N / contact_.length_m)).first->second;
}

long SolvedContacts::unconverged() const {
  return std::count_if(results_.begin(), results_.end(), [](const auto& entry) {
    const auto* const solved = std::get_if<SolvedContact>(&entry.second);
    return solved && !solved->converged;
  });
}

bool SolvedContacts::hit_limit() const {
  return std::any_of(results_.begin(), results_.end(), [](const auto& entry) {
    const auto* const failure = std::get_if<SolveFailure>(&entry.second);
    return failure && failure->limit;
  });
}

double offset_film_m(const RacewayContact& contact, double force_N, const SolvedContact& solved) {
  const double b = hertz::half_width_m(contact.at(force_N));
  return b * b / contact.reduced_radius_m * (solved.offset - hertz::dry_offset());
}

double martin_film_m(const RacewayContact& contact, double force_N) {
  constexpr double martin = 2.4474842468;
  return martin * contact.viscosity_Pa_s * contact.speed_sum_m_per_s * contact.reduced_radius_m * contact.length_m /
         force_N;
}

namespace {

/// A film [m] and d ln(film)/d ln(f).
struct FilmAndExponent {
  double film = 0, exponent = 0;
};

FilmAndExponent rigid_minimum(const RacewayContact& contact, double force_N) {
  return {martin_film_m(contact, force_N), -1};
}

FilmAndExponent rigid_offset(const RacewayContact& contact, double force_N) {
  constexpr double mean_log_tangent = -0.3284612545;
  const double film = martin_film_m(contact, force_N);
  const double b = hertz::half_width_m(contact.at(force_N));
  const double deformation = b * b / (2 * contact.reduced_radius_m) / film;  // 4w/(pi E' h), grows as f^2
  const double ratio = deformation * (std::log(std::sqrt(2 * contact.reduced_radius_m * film) / b) + mean_log_tangent -
                                      2 * hertz::dry_offset());
  const double ratio_slope = 2 * ratio - deformation;  // the logarithm falls by 1 per unit of ln f
  // Positive far beyond its range, where the ratio is negative.
  const double factor = ratio > 0 ? 1 + ratio : 1 / (1 - ratio);
  return {film * factor, -1 + ratio_slope / (1 + std::abs(ratio))};
}

}  // namespace

double martin_offset_film_m(const RacewayContact& contact, double force_N) {
  return rigid_offset(contact, force_N).film;
}

struct FilmCurve::Spline {
  explicit Spline(const std::vector<double>& log_force, const std::vector<double>& log_film)
      : spline(gsl_spline_alloc(gsl_interp_steffen, log_force.size()), gsl_spline_free) {
    gsl_spline_init(spline.get(), log_force.data(), log_film.data(), log_force.size());
  }
  /// ln film and its derivative to ln f, inside the points.
  [[nodiscard]] ValueAndSlope at(double log_force) const {
    return {gsl_spline_eval(spline.get(), log_force, nullptr), gsl_spline_eval_deriv(spline.get(), log_force, nullptr)};
  }
  std::unique_ptr<gsl_spline, void (*)(gsl_spline*)> spline;
};

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

FilmCurve::FilmCurve(RacewayContact contact, std::vector<double> forces_N, std::vector<double> offset_films_m,
                     std::vector<double> minimum_films_m)
    : contact_(contact), forces_N_(std::move(forces_N)) {
  const auto points = forces_N_.size();
  if (points < 3 || offset_films_m.size() != points || minimum_films_m.size() != points)
    throw std::invalid_argument("film curve: " + std::to_string(points) + " forces, " +
                                std::to_string(offset_films_m.size()) + " offset films and " +
                                std::to_string(minimum_films_m.size()) +
                                " minimum films; give equal numbers of each, at least three");
  if (std::adjacent_find(forces_N_.begin(), forces_N_.end(), std::greater_equal<>()) != forces_N_.end())
    throw std::invalid_argument("film curve: the forces must increase");
  const std::vector<double> log_force = logarithms(forces_N_, "force");
  offset_ = std::make_shared<const Spline>(log_force, logarithms(offset_films_m, "offset film"));
  minimum_ = std::make_shared<const Spline>(log_force, logarithms(minimum_films_m, "minimum film"));
}

double FilmCurve::compliance_scale() const { return 4 / (pi * contact_.reduced_modulus_Pa * contact_.length_m); }

namespace {

/// Inside the points the spline; above, its end's power law; below, ln F = ln F_rigid + a t^(3/2) + c t^3, where value
/// and slope at t = 1 fix a and c.
template <class Rigid>
ValueAndSlope evaluate(const FilmCurve& curve, double force_N, const Rigid& rigid, auto&& spline_at) {
  const double s = std::log(force_N), first = std::log(curve.lightest_N()), last = std::log(curve.heaviest_N());
  if (force_N >= curve.lightest_N() && force_N <= curve.heaviest_N()) {
    const ValueAndSlope inside = spline_at(std::clamp(s, first, last));
    const double film = std::exp(inside.value);
    return {film, film * inside.slope / force_N};
  }
  if (force_N > curve.heaviest_N()) {
    const ValueAndSlope end = spline_at(last);
    const double film = std::exp(end.value + end.slope * (s - last));
    return {film, film * end.slope / force_N};
  }
  const FilmAndExponent at_joint = rigid(curve.contact(), curve.lightest_N()), here = rigid(curve.contact(), force_N);
  const ValueAndSlope joint = spline_at(first);
  const double v = joint.value - std::log(at_joint.film), d = joint.slope - at_joint.exponent;
  const double c = (d - 1.5 * v) / 1.5, a = v - c;
  const double t = force_N / curve.lightest_N(), t15 = t * std::sqrt(t);
  const double film = here.film * std::exp(a * t15 + c * t15 * t15);
  return {film, film / force_N * (here.exponent + 1.5 * a * t15 + 3 * c * t15 * t15)};
}

}  // namespace

ValueAndSlope FilmCurve::offset_film(double force_N) const {
  return evaluate(*this, force_N, rigid_offset, [&](double log_force) { return offset_->at(log_force); });
}
ValueAndSlope FilmCurve::minimum_film(double force_N) const {
  return evaluate(*this, force_N, rigid_minimum, [&](double log_force) { return minimum_->at(log_force); });
}

namespace {

/// The points a curve is made of.
class Points {
 public:
  explicit Points(SolvedContacts& contacts) : contacts_(contacts) {}

  /// Solves and keeps; returns why not otherwise.
  [[nodiscard]] std::optional<std::string> add(double force_N) {
    const ContactResult& result = contacts_.at(force_N);
    if (const auto* failure = std::get_if<SolveFailure>(&result)) return failure->why;
    const auto& solved = std::get<SolvedContact>(result);
    const double F = offset_film_m(contacts_.contact(), force_N, solved);
    if (!(F > 0) || !(solved.film_minimum_m > 0)) return "the solved film is not positive";
    points_[force_N] = {F, solved.film_minimum_m};
    solver_error_ = std::max(solver_error_, solved.offset_error / (solved.offset - hertz::dry_offset()));
    return std::nullopt;
  }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] double solver_error() const { return solver_error_; }
  [[nodiscard]] std::vector<double> forces() const {
    std::vector<double> forces;
    for (const auto& point : points_) forces.push_back(point.first);
    return forces;
  }
  [[nodiscard]] FilmCurve curve() const {
    std::vector<double> forces, offsets, minima;
    for (const auto& [force_N, films] : points_) {
      forces.push_back(force_N);
      offsets.push_back(films.offset);
      minima.push_back(films.minimum);
    }
    return {contacts_.contact(), forces, offsets, minima};
  }
  /// Largest |ln(curve/solved)| of both films at one solved point that the curve may or may not contain.
  [[nodiscard]] double disagreement(const FilmCurve& curve, double force_N) const {
    const Films& solved = points_.at(force_N);
    return std::max(std::abs(std::log(curve.offset_film(force_N).value / solved.offset)),
                    std::abs(std::log(curve.minimum_film(force_N).value / solved.minimum)));
  }

 private:
  struct Films {
    double offset = 0, minimum = 0;
  };
  SolvedContacts& contacts_;
  std::map<double, Films> points_;
  double solver_error_ = 0;
};

std::string newtons(double force_N) {
  char text[64];
  std::snprintf(text, sizeof text, "%.4g N", force_N);
  return text;
}

}  // namespace

std::variant<FilmCurve, SolveFailure> build_curve(SolvedContacts& contacts, const CurveRequest& request) {
  Points points(contacts);
  const double top = std::exp2(std::ceil(std::log2(request.heaviest_N)));
  constexpr double descent = 4;
  if (const auto why = points.add(top)) return SolveFailure{"at a contact force of " + newtons(top) + ": " + *why};

  double interpolation_error = 0, joint_error = std::numeric_limits<double>::infinity();
  std::string stopped;
  std::set<std::pair<double, double>> accepted;  // gaps whose middle agreed
  const auto refine = [&]() {
    for (bool split = true; split;) {
      split = false;
      const std::vector<double> forces = points.forces();
      const FilmCurve curve = points.curve();
      for (std::size_t k = 0; k + 1 < forces.size(); ++k) {
        const std::pair gap{forces[k], forces[k + 1]};
        if (accepted.contains(gap)) continue;
        const double middle = std::sqrt(gap.first * gap.second);
        const bool full = points.size() >= static_cast<std::size_t>(request.most_points);
        if (full || points.add(middle)) {
          accepted.insert(gap);
          interpolation_error = std::numeric_limits<double>::infinity();  // a gap that nothing was checked in
          continue;
        }
        const double error = points.disagreement(curve, middle);
        const bool agrees = error <= request.bound;
        const bool smallest = std::sqrt(gap.second / gap.first) < request.smallest_gap;
        if (agrees || smallest) {
          accepted.insert({gap.first, middle});
          accepted.insert({middle, gap.second});
          interpolation_error = std::max(interpolation_error, error);
        } else {
          split = true;
        }
      }
    }
  };
  // Down to where the rigid limit takes over: the curve so far, refined, must foretell the next lighter contact.
  for (double lighter = top / descent; stopped.empty(); lighter /= descent) {
    std::optional<FilmCurve> foreteller;
    if (points.size() >= 3) {
      refine();
      foreteller = points.curve();
    }
    if (const auto why = points.add(lighter)) {
      stopped = newtons(lighter) + " could not be solved: " + *why;
    } else if (foreteller) {
      joint_error = points.disagreement(*foreteller, lighter);
      if (joint_error <= request.bound) stopped = "the rigid limit foretells it within the bound";
    }
  }
  if (points.size() < 3)
    return SolveFailure{"only " + std::to_string(points.size()) + " contact forces up to " + newtons(top) +
                        " could be solved, three are needed; " + stopped};
  refine();
  FilmCurve curve = points.curve();
  curve.interpolation_error = interpolation_error;
  curve.joint_error = joint_error;
  curve.solver_error = points.solver_error();
  curve.lightest_because = stopped;
  return curve;
}

}  // namespace ehd::bearing
