// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/response_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "bearing/martin.hpp"
#include "contact/hertz.hpp"
#include "contact/text.hpp"

namespace ehd::bearing {

namespace {

using Point = ResponseCurve::Point;

/// Relative step of the force for the slope of the lag: its rounding and its curvature err by 1e-11 and 1e-5.
constexpr double lag_slope_step = 1e-5;

template <class Read>
std::vector<double> read_points(const std::vector<Point>& points, const Read& read) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const Point& point : points) values.push_back(read(point));
  return values;
}

std::vector<double> forces_of(const std::vector<Point>& points) {
  return read_points(points, [](const Point& point) { return point.force_N; });
}
std::vector<double> kappa_0s(const std::vector<Point>& points) {
  return read_points(points, [](const Point& point) { return point.response.slow.stiffness; });
}

double size(const Kappa& kappa, double Omega) { return std::hypot(kappa.stiffness, Omega * kappa.damping); }

/// M = f/(l sqrt(eta_0 u_s E' R)).
double lag_scale(const RacewayContact& contact, double force_N) {
  return bearing::lag_scale(force_N / contact.length_m /
                            std::sqrt(contact.viscosity_Pa_s * contact.speed_sum_m_per_s * contact.reduced_modulus_Pa *
                                      contact.reduced_radius_m));
}

/// asinh(lag/s) of slow motion over ln f.
MonotoneSpline lag_spline(const RacewayContact& contact, const std::vector<Point>& points) {
  std::vector<double> log_force, lags;
  for (const auto& [force_N, response] : points) {
    const double kappa_0 = response.slow.stiffness;
    log_force.push_back(std::log(force_N));
    lags.push_back(std::asinh(response.slow.damping / (kappa_0 * kappa_0) / lag_scale(contact, force_N)));
  }
  return {std::move(log_force), std::move(lags), MonotoneSpline::Limit::none};
}

}  // namespace

double lag_scale(double M) {
  constexpr double of_light_contacts = 0.3;
  return of_light_contacts / (1 + M);
}

Kappa unknown_at(const Kappa& slow) {
  Kappa kappa = slow;
  kappa.stiffness_error = kappa.damping_error = unknown_error;
  return kappa;
}

bool is_known(const Kappa& kappa) { return std::isfinite(kappa.stiffness_error + kappa.damping_error); }

double Omega_of(const RacewayContact& contact, double force_N, double omega) {
  return omega * hertz::half_width_m(contact.at(force_N)) / (contact.speed_sum_m_per_s / 2);
}

ResponseCurve::ResponseCurve(RacewayContact contact, std::vector<double> omegas, const std::vector<Point>& points,
                             ResponseErrors errors)
    : contact_(contact),
      omegas_(std::move(omegas)),
      forces_N_(forces_of(points)),
      kappa_0_(contact, forces_N_, kappa_0s(points), martin_kappa_0, "kappa_0"),
      slow_lag_(lag_spline(contact, points)),
      errors_(std::move(errors)) {
  errors_.at.resize(omegas_.size());
  std::vector<double> log_force;
  for (const double force_N : forces_N_) log_force.push_back(std::log(force_N));
  for (std::size_t k = 0; k < omegas_.size(); ++k) {
    const auto departure = [k](const Point& point) {
      return point.response.at.at(k).stiffness / point.response.slow.stiffness - 1;
    };
    const auto damping = [this, k](const Point& point) {
      return point.response.at[k].damping / damping_scale(point.force_N);
    };
    SolverErrors solver;
    for (const auto& [force_N, response] : points)
      solver.meet(relative_errors(force_N, Omega_of(contact_, force_N, omegas_[k]), response.at[k]));
    frequencies_.push_back({MonotoneSpline(log_force, read_points(points, departure), MonotoneSpline::Limit::none),
                            MonotoneSpline(log_force, read_points(points, damping), MonotoneSpline::Limit::none),
                            solver});
  }
  for (const auto& [force_N, response] : points) slow_solver_.meet(relative_errors(force_N, 0, response.slow));
}

ResponseCurve::SolverErrors ResponseCurve::relative_errors(double force_N, double Omega, const Kappa& kappa) const {
  return {.stiffness = kappa.stiffness_error / size(kappa, Omega),
          .damping = kappa.damping_error / damping_scale(force_N)};
}

void ResponseCurve::SolverErrors::meet(const SolverErrors& other) {
  stiffness = std::max(stiffness, other.stiffness);
  damping = std::max(damping, other.damping);
}

double ResponseCurve::damping_scale(double force_N) const {
  const double kappa_0 = kappa_0_.at(force_N).value;
  return std::hypot(slow_lag(force_N), lag_scale(contact_, force_N)) * kappa_0 * kappa_0;
}

double ResponseCurve::inside(const MonotoneSpline& spline, double force_N) const {
  return spline.at(std::clamp(std::log(force_N), spline.first(), spline.last())).value;
}

double ResponseCurve::lag_inside(double force_N) const {
  return lag_scale(contact_, force_N) * std::sinh(inside(slow_lag_, force_N));
}

/// Below the lightest point as in ContinuedSpline. The joint's value and slope come from the spline of asinh(lag/s).
double ResponseCurve::slow_lag(double force_N) const {
  const double lightest_N = forces_N_.front();
  if (force_N >= lightest_N) return lag_inside(force_N);
  const ValueAndExponent at_joint = martin_lag(contact_, lightest_N), here = martin_lag(contact_, force_N);
  const double joint = lag_inside(lightest_N);
  const double exponent = std::log(lag_inside(lightest_N * (1 + lag_slope_step)) / joint) / std::log1p(lag_slope_step);
  const double v = std::log(joint / at_joint.value), d = exponent - at_joint.exponent;
  const double c = (d - 1.5 * v) / 1.5, a = v - c, t15 = std::pow(force_N / lightest_N, 1.5);
  return here.value * std::exp(a * t15 + c * t15 * t15);
}

Kappa ResponseCurve::with_errors(double force_N, double omega, Kappa kappa, const SolverErrors& solver,
                                 const ReadingErrors& reading) const {
  const bool below = force_N < forces_N_.front();
  kappa.stiffness_error = (solver.stiffness + (below ? reading.stiffness_below : reading.stiffness)) *
                          size(kappa, Omega_of(contact_, force_N, omega));
  kappa.damping_error = (solver.damping + (below ? reading.damping_below : reading.damping)) * damping_scale(force_N);
  return kappa;
}

double ResponseCurve::slow_damping(double force_N) const {
  const double kappa_0 = kappa_0_.at(force_N).value;
  return slow_lag(force_N) * kappa_0 * kappa_0;
}

Kappa ResponseCurve::slow(double force_N) const {
  return with_errors(force_N, 0, {.stiffness = kappa_0_.at(force_N).value, .damping = slow_damping(force_N)},
                     slow_solver_, errors_.slow);
}

Kappa ResponseCurve::at(double force_N, std::size_t k) const {
  const Frequency& fast = frequencies_.at(k);
  const double kappa_0 = kappa_0_.at(force_N).value, lightest_N = forces_N_.front();
  double departure = inside(fast.departure, force_N), damping = inside(fast.damping, force_N) * damping_scale(force_N);
  if (force_N < lightest_N) {
    const double part = force_N / lightest_N;
    const double at_joint = inside(fast.damping, lightest_N) * damping_scale(lightest_N) / slow_damping(lightest_N);
    departure *= part;
    damping = slow_damping(force_N) * (1 + part * (at_joint - 1));
  }
  return with_errors(force_N, omegas_[k], {.stiffness = kappa_0 * (1 + departure), .damping = damping}, fast.solver,
                     errors_.at[k]);
}

namespace {

/// The error below the lightest point is stated as this times the disagreement at half the lightest force: as for films
/// (curve_points.cpp).
constexpr double safety_of_response_continuation = 2;

/// Extra solves become points. The error of a fourth-order spline falls to a sixteenth where the gap is halved; half of
/// that gain is counted on, as for films.
constexpr double gain_of_half_the_response_gap = 8;

/// How far a curve is off at a solved contact, relative as in ReadingErrors.
struct OffReading {
  double stiffness = 0, damping = 0;
  [[nodiscard]] double larger() const { return std::max(stiffness, damping); }
  void meet(const OffReading& other) {
    stiffness = std::max(stiffness, other.stiffness);
    damping = std::max(damping, other.damping);
  }
};

/// The same in slow motion, and at each frequency of the curve.
struct OffResponse {
  OffReading slow;
  std::vector<OffReading> at;
  [[nodiscard]] double larger() const {
    double largest = slow.larger();
    for (const OffReading& one : at) largest = std::max(largest, one.larger());
    return largest;
  }
  void meet(const OffResponse& other) {
    slow.meet(other.slow);
    for (std::size_t k = 0; k < at.size(); ++k) at[k].meet(other.at[k]);
  }
};

OffResponse off(const ResponseCurve& curve, const Point& solved) {
  const auto compare = [&](const Kappa& read, const Kappa& truth, double Omega) {
    return OffReading{.stiffness = std::abs(read.stiffness - truth.stiffness) / size(truth, Omega),
                      .damping = std::abs(read.damping - truth.damping) / curve.damping_scale(solved.force_N)};
  };
  OffResponse found{.slow = compare(curve.slow(solved.force_N), solved.response.slow, 0), .at = {}};
  for (std::size_t k = 0; k < curve.omegas().size(); ++k)
    found.at.push_back(compare(curve.at(solved.force_N, k), solved.response.at[k],
                               Omega_of(curve.contact(), solved.force_N, curve.omegas()[k])));
  return found;
}

/// Solved contacts on their way to a curve.
class ResponsePoints {
 public:
  ResponsePoints(const RespondingContact& contacts, const ResponseCurveRequest& request)
      : contacts_(contacts), request_(request), answered_(request.omegas.size(), true) {}

  /// Solves a contact and keeps it, or says why not.
  [[nodiscard]] std::optional<SolveFailure> add(double force_N) {
    if (solved_.contains(force_N)) return std::nullopt;
    ResponseResult result = contacts_.at(force_N, asked());
    if (auto* failure = std::get_if<SolveFailure>(&result))
      return SolveFailure{
          .why = fmt::format("response at a contact force of {} N: {}", plain(force_N, 4), failure->why),
          .limit = failure->limit};
    auto& response = std::get<SolvedResponse>(result);
    const bool lightest = force_N <= request_.lightest_N;
    if (!(response.slow.stiffness > 0) || (lightest && !(response.slow.damping > 0)))
      return SolveFailure{
          .why = fmt::format("at a contact force of {} N kappa_0 = {} and kappa_1 = {}; a curve over the force needs a "
                             "positive kappa_0, and a positive kappa_1 where it goes over to a rigid cylinder",
                             plain(force_N, 4), plain(response.slow.stiffness), plain(response.slow.damping))};
    keep(force_N, response);
    return std::nullopt;
  }
  [[nodiscard]] std::optional<SolveFailure> add(const std::vector<double>& forces_N) {
    if (!request_.omegas.empty())
      if (auto failure = add(forces_N.back())) return failure;
    for (const double force_N : forces_N)
      if (auto failure = add(force_N)) return failure;
    return std::nullopt;
  }
  [[nodiscard]] Point at(double force_N) const {
    SolvedResponse response = solved_.at(force_N);
    for (std::size_t k = 0; k < answered_.size(); ++k)
      if (!answered_[k]) response.at[k] = unknown_at(response.slow);
    return {force_N, std::move(response)};
  }
  [[nodiscard]] std::size_t size() const { return solved_.size(); }
  [[nodiscard]] ResponseCurve curve(const std::vector<double>& forces_N, const ResponseErrors& errors = {}) const {
    std::vector<Point> points;
    points.reserve(forces_N.size());
    for (const double force_N : forces_N) points.push_back(at(force_N));
    return {contacts_.contact, request_.omegas, points, errors};
  }

 private:
  /// Frequencies that every contact up to now has answered.
  [[nodiscard]] std::vector<double> asked() const {
    std::vector<double> omegas;
    for (std::size_t k = 0; k < answered_.size(); ++k)
      if (answered_[k]) omegas.push_back(request_.omegas[k]);
    return omegas;
  }
  /// `response` is that at asked().
  void keep(double force_N, const SolvedResponse& response) {
    SolvedResponse& kept = solved_[force_N];
    kept.slow = response.slow;
    std::size_t next = 0;
    for (std::size_t k = 0; k < answered_.size(); ++k) {
      kept.at.push_back(answered_[k] ? response.at.at(next++) : unknown_at(response.slow));
      answered_[k] = is_known(kept.at.back());
    }
  }

  const RespondingContact& contacts_;
  const ResponseCurveRequest& request_;
  std::vector<bool> answered_;
  std::map<double, SolvedResponse> solved_;
};

/// Forces that differ by less are one.
constexpr double same_force = 1e-9;

std::vector<double> first_forces(const ResponseCurveRequest& request) {
  const double span = std::log(request.heaviest_N / request.lightest_N);
  const int gaps = std::max(2, static_cast<int>(std::ceil(span / std::log(request.widest_gap) - same_force)));
  std::vector<double> forces;
  forces.reserve(static_cast<std::size_t>(gaps) + 1);
  for (int k = 0; k < gaps; ++k) forces.push_back(request.lightest_N * std::exp(span * k / gaps));
  forces.push_back(request.heaviest_N);
  return forces;
}

/// A curve through all loads takes 30 to 50 points (NA4908). If `few_forces` points or fewer serve the forces that are
/// read, the curve has only these.
constexpr std::size_t few_forces = 30, fewest_points = 3;
/// Two points in ln f above the lightest give the exponents with which the curve continues below. Damping of NA4908
/// (2.5 um) at half the lightest force: 0.1 and 0.3 leave 2 %, 0.25 and 0.6 9 %, these 0.8 %, as much as a curve of 53
/// points.
constexpr double steps_at_joint[] = {0.05, 0.15};

/// The points of a curve that is read at a few forces only; empty where it is read at many.
std::vector<double> forces_to_read(const ResponseCurveRequest& request) {
  std::vector<double> forces = {request.lightest_N};
  for (const double step : steps_at_joint) forces.push_back(std::exp(step) * request.lightest_N);
  for (const double force_N : request.read_at_N)
    if (force_N >= request.lightest_N) forces.push_back(force_N);
  std::erase_if(forces, [&](double force_N) { return force_N > request.heaviest_N; });
  std::sort(forces.begin(), forces.end());
  const auto same = [](double one, double next) { return next < one * (1 + same_force); };
  forces.erase(std::unique(forces.begin(), forces.end(), same), forces.end());
  if (request.read_at_N.empty() || forces.size() > few_forces || forces.size() < fewest_points) return {};
  return forces;
}

/// Judged by a contact of half the lightest force; unknown where that cannot be solved.
OffResponse below_lightest(ResponsePoints& points, const ResponseCurve& curve) {
  const double half_N = curve.forces_N().front() / 2;
  if (!points.add(half_N)) return off(curve, points.at(half_N));
  constexpr double infinite = std::numeric_limits<double>::infinity();
  constexpr OffReading unknown{.stiffness = infinite, .damping = infinite};
  return {.slow = unknown, .at = std::vector<OffReading>(curve.omegas().size(), unknown)};
}

/// Of a curve that is off by `between` at the most between its points, and by `below` at half the lightest force.
ResponseErrors errors_of(const OffResponse& between, const OffResponse& below) {
  const auto of = [](const OffReading& inside, const OffReading& lighter) {
    return ReadingErrors{.stiffness = inside.stiffness / gain_of_half_the_response_gap,
                         .damping = inside.damping / gain_of_half_the_response_gap,
                         .stiffness_below = safety_of_response_continuation * lighter.stiffness,
                         .damping_below = safety_of_response_continuation * lighter.damping};
  };
  ResponseErrors errors{.slow = of(between.slow, below.slow), .at = {}};
  for (std::size_t k = 0; k < below.at.size(); ++k) errors.at.push_back(of(between.at[k], below.at[k]));
  return errors;
}

/// A curve that is exact, in slow motion and at each frequency.
OffResponse nothing_off(const ResponseCurveRequest& request) {
  return {.slow = {}, .at = std::vector<OffReading>(request.omegas.size())};
}

}  // namespace

std::variant<ResponseCurve, SolveFailure> build_response_curve(const RespondingContact& contacts,
                                                               const ResponseCurveRequest& request) {
  ResponsePoints points(contacts, request);
  if (const std::vector<double> forces = forces_to_read(request); !forces.empty()) {
    if (auto failure = points.add(forces)) return *failure;
    const OffResponse below = below_lightest(points, points.curve(forces));
    return points.curve(forces, errors_of(nothing_off(request), below));
  }
  std::vector<double> nodes = first_forces(request);
  if (auto failure = points.add(nodes)) return *failure;
  while (true) {
    const ResponseCurve curve = points.curve(nodes);
    std::vector<double> with_middles, split = nodes;
    OffResponse worst = nothing_off(request);
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
      const double middle = std::sqrt(nodes[k] * nodes[k + 1]);
      with_middles.insert(with_middles.end(), {nodes[k], middle});
      if (auto failure = points.add(middle)) return *failure;
      const OffResponse here = off(curve, points.at(middle));
      worst.meet(here);
      if (here.larger() > request.bound && nodes[k + 1] / nodes[k] > request.smallest_gap) split.push_back(middle);
    }
    with_middles.push_back(nodes.back());
    if (split.size() > nodes.size() && points.size() < static_cast<std::size_t>(request.most_points)) {
      std::sort(split.begin(), split.end());
      nodes = std::move(split);
      continue;
    }
    const OffResponse below = below_lightest(points, points.curve(with_middles));
    return points.curve(with_middles, errors_of(worst, below));
  }
}

}  // namespace ehd::bearing
