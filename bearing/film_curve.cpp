// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/film_curve.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <set>
#include <stdexcept>

#include "contact/approach.hpp"
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

/// GSL's cubic spline has natural ends, which are of second order, and its monotone ones are of second order
/// everywhere.
struct FilmCurve::Spline {
  Spline(std::vector<double> log_force, std::vector<double> log_film)
      : x(std::move(log_force)), y(std::move(log_film)), slope(slopes(x, y)) {}

  /// ln film and its derivative to ln f, inside the points.
  [[nodiscard]] ValueAndSlope at(double log_force) const {
    const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, log_force);
    const auto k = static_cast<std::size_t>(above - x.begin()) - 1;
    const double h = x[k + 1] - x[k], t = (log_force - x[k]) / h, secant = (y[k + 1] - y[k]) / h;
    const double c2 = 3 * secant - 2 * slope[k] - slope[k + 1], c3 = slope[k] + slope[k + 1] - 2 * secant;
    return {y[k] + h * t * (slope[k] + t * (c2 + t * c3)), slope[k] + t * (2 * c2 + t * 3 * c3)};
  }

  /// Slopes of the cubic spline with not-a-knot ends (a parabola through three points), limited where the neighbouring
  /// secants agree in sign.
  [[nodiscard]] static std::vector<double> slopes(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<Eigen::Index>(x.size());
    Eigen::VectorXd h(n - 1), secant(n - 1), right(n);
    for (Eigen::Index k = 0; k + 1 < n; ++k) {
      const auto i = static_cast<std::size_t>(k);
      h[k] = x[i + 1] - x[i];
      secant[k] = (y[i + 1] - y[i]) / h[k];
    }
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index k = 1; k + 1 < n; ++k) {
      rows(k, k - 1) = h[k];
      rows(k, k) = 2 * (h[k - 1] + h[k]);
      rows(k, k + 1) = h[k - 1];
      right[k] = 3 * (h[k] * secant[k - 1] + h[k - 1] * secant[k]);
    }
    const auto end = [&](Eigen::Index row, Eigen::Index inwards, double h0, double h1, double s0, double s1) {
      if (n == 3) {  // one parabola: d_0 + d_1 = 2 s_0
        rows(row, row) = rows(row, row + inwards) = 1;
        right[row] = 2 * s0;
        return;
      }
      rows(row, row) = h1;
      rows(row, row + inwards) = h0 + h1;
      right[row] = ((h0 + 2 * (h0 + h1)) * h1 * s0 + h0 * h0 * s1) / (h0 + h1);
    };
    end(0, 1, h[0], h[1], secant[0], secant[1]);
    end(n - 1, -1, h[n - 2], h[n - 3], secant[n - 2], secant[n - 3]);
    const Eigen::VectorXd solved = rows.partialPivLu().solve(right);
    std::vector<double> result(x.size());
    for (Eigen::Index k = 0; k < n; ++k) {
      const double before = secant[std::max<Eigen::Index>(k - 1, 0)], after = secant[std::min(k, n - 2)];
      const double largest = 3 * std::min(std::abs(before), std::abs(after));
      double d = solved[k];
      if (before * after > 0)  // monotone here; an extremum of the points keeps its slope
        d = before > 0 ? std::clamp(d, 0.0, largest) : std::clamp(d, -largest, 0.0);
      result[static_cast<std::size_t>(k)] = d;
    }
    return result;
  }

  std::vector<double> x, y, slope;
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
double FilmCurve::rise_m(double force_N) const {
  // delta_dry = (4 f/(pi E' l)) [ln(2 x_0/b) + 1/2], b ~ sqrt(f)
  const double dry_m = dry_approach_m(contact_.at(force_N), contact_.length_m);
  return dry_m - compliance_scale() * force_N / 2 - force_N * offset_film(force_N).slope;
}
ValueAndSlope FilmCurve::minimum_film(double force_N) const {
  return evaluate(*this, force_N, rigid_minimum, [&](double log_force) { return minimum_->at(log_force); });
}

namespace {

/// How far a curve is from a solved contact, relative.
struct Disagreement {
  double force = 0;                ///< of the contact force at the solved approach
  double offset = 0, minimum = 0;  ///< |ln(curve/solved)| of the films

  [[nodiscard]] double film() const { return std::max(offset, minimum); }
  /// Above 1: not within the bounds. A NaN is not.
  [[nodiscard]] double against(const CurveRequest& request) const {
    const double ratio = std::max(force / request.force_bound, minimum / request.film_bound);
    return std::isfinite(force) && std::isfinite(minimum) ? ratio : std::numeric_limits<double>::infinity();
  }
};

/// The solved contacts that a curve may be made of.
class Points {
 public:
  explicit Points(SolvedContacts& contacts) : contacts_(contacts) {}

  /// Solves and keeps; returns why not otherwise.
  [[nodiscard]] std::optional<SolveFailure> add(double force_N) {
    const ContactResult& result = contacts_.at(force_N);
    if (const auto* failure = std::get_if<SolveFailure>(&result)) return *failure;
    const auto& solved = std::get<SolvedContact>(result);
    const double F = offset_film_m(contacts_.contact(), force_N, solved);
    if (!(F > 0) || !(solved.film_minimum_m > 0)) return SolveFailure{.why = "the solved film is not positive"};
    points_[force_N] = {F, solved.film_minimum_m};
    if (!solved.converged) missed_N_.insert(force_N);
    film_error_ = std::max(film_error_, solved.film_error);
    solver_error_ = std::max(solver_error_, solved.offset_error / (solved.offset - hertz::dry_offset()));
    return std::nullopt;
  }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] double solver_error() const { return solver_error_; }
  [[nodiscard]] double film_error() const { return film_error_; }
  [[nodiscard]] const std::set<double>& missed_N() const { return missed_N_; }
  [[nodiscard]] bool has(double force_N) const { return points_.contains(force_N); }
  [[nodiscard]] FilmCurve curve(const std::set<double>& forces_N) const {
    std::vector<double> forces, offsets, minima;
    for (const double force_N : forces_N) {
      forces.push_back(force_N);
      offsets.push_back(points_.at(force_N).offset);
      minima.push_back(points_.at(force_N).minimum);
    }
    return {contacts_.contact(), forces, offsets, minima};
  }
  /// Of a curve at a solved point that it need not contain.
  [[nodiscard]] Disagreement disagreement(const FilmCurve& curve, double force_N) const {
    const Films& solved = points_.at(force_N);
    const ValueAndSlope offset = curve.offset_film(force_N);
    return {.force = std::abs(offset.value - solved.offset) / curve.rise_m(force_N),
            .offset = std::abs(std::log(offset.value / solved.offset)),
            .minimum = std::abs(std::log(curve.minimum_film(force_N).value / solved.minimum))};
  }

 private:
  struct Films {
    double offset = 0, minimum = 0;
  };
  SolvedContacts& contacts_;
  std::map<double, Films> points_;
  double solver_error_ = 0, film_error_ = 0;
  std::set<double> missed_N_;
};

std::string newtons(double force_N) {
  char text[64];
  std::snprintf(text, sizeof text, "%.4g N", force_N);
  return text;
}

constexpr double descent = 4;

/// Value and slope are joined at t = 1, so the continuation's error grows as t^p (1 - t^(3/2))^2, p = 3 or 9/2 (the
/// next powers of the piezoviscous series): at t = 1/2 it is at least .52 of its largest.
Disagreement largest_below(Disagreement at_half) {
  constexpr double factor = 2;
  return {.force = factor * at_half.force, .offset = factor * at_half.offset, .minimum = factor * at_half.minimum};
}

/// The points of a curve and the extra solves that its gaps are judged by.
class Refinement {
 public:
  Refinement(SolvedContacts& contacts, const CurveRequest& request) : points_(contacts), request_(request) {}

  /// Solves a point and keeps it; returns why not otherwise.
  [[nodiscard]] std::optional<SolveFailure> add_point(double force_N) {
    if (auto failure = points_.add(force_N)) return failure;
    nodes_.insert(force_N);
    return std::nullopt;
  }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] double lightest_N() const { return *nodes_.begin(); }

  /// Splits the gap whose extra solve disagrees most, until all agree.
  void refine() {
    while (true) {
      const FilmCurve curve = points_.curve(nodes_);
      std::optional<double> worst;
      double ratio = 1;
      worst_film_ = worst_force_ = 0;
      extras_.clear();
      for (auto low = nodes_.begin(), high = std::next(low); high != nodes_.end(); ++low, ++high) {
        const double between = extra_between(*low, *high);
        if (!solved(between)) {
          worst_film_ = worst_force_ = std::numeric_limits<double>::infinity();  // a gap that nothing was checked in
          continue;
        }
        extras_.insert(between);
        const Disagreement here = points_.disagreement(curve, between);
        worst_film_ = std::max(worst_film_, here.film());
        worst_force_ = std::max(worst_force_, here.force);
        const bool smallest = std::sqrt(*high / *low) < request_.smallest_gap;
        // One extra solve says nothing of a gap this wide: a bend beside it may change the error's sign just there.
        const bool wide = *high / *low > request_.widest_gap * (1 + 1e-9);
        const double here_ratio = wide ? std::numeric_limits<double>::infinity() : here.against(request_);
        if (here_ratio > ratio && !smallest) {
          ratio = here_ratio;
          worst = between;
        }
      }
      if (!worst) return;
      nodes_.insert(*worst);
    }
  }
  /// The middle of a gap sees nothing where the error changes its sign there. So every point is foretold by the others
  /// too, over twice the gap: where an eighth of what they are off by (a fourth-order spline's error falls to a
  /// sixteenth) is beyond the bounds, the gaps on both sides are split. Extra solves are points from here on.
  void refine_where_points_are_not_foretold() {
    nodes_.insert(extras_.begin(), extras_.end());
    extras_.clear();
    const double middles_film = worst_film_, middles_force = worst_force_;
    std::set<double> left;  // points whose gaps cannot be split any more
    while (true) {
      worst_film_ = middles_film;
      worst_force_ = middles_force;
      std::optional<double> worst;
      double ratio = 1;
      constexpr std::size_t fewest = 5;
      if (nodes_.size() >= fewest)
        for (auto at = std::next(nodes_.begin()); std::next(at) != nodes_.end(); ++at) {
          std::set<double> others = nodes_;
          others.erase(*at);
          Disagreement here = points_.disagreement(points_.curve(others), *at);
          constexpr double halved = 8;
          here = {.force = here.force / halved, .offset = here.offset / halved, .minimum = here.minimum / halved};
          worst_film_ = std::max(worst_film_, here.film());
          worst_force_ = std::max(worst_force_, here.force);
          if (here.against(request_) > ratio && !left.contains(*at)) {
            ratio = here.against(request_);
            worst = *at;
          }
        }
      if (!worst) return;
      const auto at = nodes_.find(*worst);
      const double below = *std::prev(at), above = *std::next(at);
      left.insert(*worst);
      for (const double middle : {extra_between(below, *worst), extra_between(*worst, above)}) {
        const double gap = middle < *worst ? *worst / below : above / *worst;
        if (std::sqrt(gap) < request_.smallest_gap || !solved(middle)) continue;
        nodes_.insert(middle);
        left.erase(*worst);
      }
    }
  }
  /// Points and extra solves: the curve that is returned.
  [[nodiscard]] FilmCurve curve(double down_to_N = 0) const {
    std::set<double> all = nodes_;
    all.insert(extras_.begin(), extras_.end());
    all.erase(all.begin(), all.lower_bound(down_to_N));
    FilmCurve curve = points_.curve(all);
    curve.interpolation_error = worst_film_;
    curve.interpolation_force_error = worst_force_;
    curve.solver_error = points_.solver_error();
    curve.film_error = points_.film_error();
    curve.missed_N.assign(points_.missed_N().begin(), points_.missed_N().end());
    return curve;
  }
  /// The curve's rigid continuation against a solved contact below its points.
  [[nodiscard]] Disagreement joint(const FilmCurve& curve, double force_N) const {
    return points_.disagreement(curve, force_N);
  }
  /// Solves, or remembers; false where it cannot, or has too many.
  [[nodiscard]] bool solved(double force_N, std::string* why = nullptr) {
    if (points_.has(force_N)) return true;
    if (failed_.contains(force_N) || points_.size() >= static_cast<std::size_t>(request_.most_points)) return false;
    if (const auto failure = points_.add(force_N)) {
      if (why) *why = failure->why;
      failed_.insert(force_N);
      return false;
    }
    return true;
  }

 private:
  /// The given force nearest to the middle of a gap, or the middle.
  [[nodiscard]] double extra_between(double low, double high) const {
    const double middle = std::sqrt(low * high);
    const auto off = [&](double f) { return std::abs(std::log(f / middle)); };
    double nearest = middle;
    for (const double f : request_.given_N) {
      if (f <= low || f >= high || failed_.contains(f)) continue;
      if (nearest == middle || off(f) < off(nearest)) nearest = f;
    }
    return nearest;
  }

  Points points_;
  CurveRequest request_;
  std::set<double> nodes_, extras_, failed_;
  double worst_film_ = 0, worst_force_ = 0;
};

}  // namespace

CurveRequest as_met(CurveRequest request) {
  std::vector<double>& given = request.given_N;
  std::erase_if(given, [&](double f) { return !(f > 0) || f > descent * request.heaviest_N; });
  if (given.size() < 2) given.clear();
  request.heaviest_N = !given.empty() && given.back() >= request.heaviest_N
                           ? given.back()
                           : std::exp2(std::ceil(std::log2(request.heaviest_N)));
  return request;
}

std::variant<FilmCurve, SolveFailure> build_curve(SolvedContacts& contacts, const CurveRequest& asked) {
  const CurveRequest request = as_met(asked);
  Refinement refinement(contacts, request);
  const double top = request.heaviest_N;
  if (const auto failure = refinement.add_point(top))
    return SolveFailure{.why = "at a contact force of " + newtons(top) + ": " + failure->why, .limit = failure->limit};

  // 1. The points to begin with: what a fit solves in any case, and two powers of two below.
  std::string stopped;
  bool limit = false;
  double lighter = top / descent;
  for (const double given : request.given_N)
    if (given == request.given_N.front() || given == request.given_N.back()) {
      if (const auto failure = refinement.add_point(given))
        limit = limit || failure->limit;
      else
        lighter = std::min(lighter, std::exp2(std::floor(std::log2(given) - 0.5)));
    }
  for (int k = 0; k < 2 && stopped.empty(); ++k, lighter /= descent)
    if (const auto failure = refinement.add_point(lighter)) {
      stopped = newtons(lighter) + " could not be solved: " + failure->why;
      limit = limit || failure->limit;
    }
  if (refinement.size() < 3)
    return SolveFailure{.why = "only " + std::to_string(refinement.size()) + " contact forces up to " + newtons(top) +
                               " could be solved, three are needed; " + stopped,
                        .limit = limit};

  // 2. Down to where the rigid limit takes over: the curve so far must foretell a contact half as heavy as its
  // lightest.
  refinement.refine();
  std::optional<Disagreement> joint;
  while (stopped.empty()) {
    const FilmCurve foreteller = refinement.curve();
    const double half = refinement.lightest_N() / 2;
    std::string why = "too many points";
    if (!refinement.solved(half, &why)) {
      stopped = newtons(half) + " could not be solved: " + why;
      break;
    }
    joint = largest_below(refinement.joint(foreteller, half));
    if (joint->against(request) <= 1) {
      stopped = "the rigid limit foretells " + newtons(half) + " within the bounds";
      break;
    }
    joint.reset();
    lighter = refinement.lightest_N() / descent;  // the half is then the middle of a gap
    if (const auto not_added = refinement.add_point(lighter)) {
      if (const auto again = refinement.add_point(half)) throw std::logic_error("film curve: a solved contact is lost");
      stopped = newtons(lighter) + " could not be solved: " + not_added->why;
    }
    refinement.refine();
  }
  refinement.refine_where_points_are_not_foretold();
  FilmCurve curve = refinement.curve();
  if (joint) {
    joint = largest_below(refinement.joint(curve, curve.lightest_N() / 2));
  } else {
    // No lighter contact to compare with: of the curve without its lightest octaves, at its lightest point.
    const double from_N = descent * curve.lightest_N() * (1 - 1e-12);
    const bool enough =
        std::count_if(curve.forces_N().begin(), curve.forces_N().end(), [&](double f) { return f >= from_N; }) >= 3;
    if (enough) joint = largest_below(refinement.joint(refinement.curve(from_N), curve.lightest_N()));
  }
  constexpr double unknown = std::numeric_limits<double>::infinity();
  curve.joint_error = joint ? joint->film() : unknown;
  curve.joint_force_error = joint ? joint->force : unknown;
  curve.lightest_because = stopped;
  return curve;
}

}  // namespace ehd::bearing
