// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/build_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "bearing/curve_points.hpp"
#include "contact/text.hpp"

namespace ehd::bearing {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Ratio of neighbouring forces on the way down, before gaps are split.
constexpr double descent = 4;
/// A point is predicted over twice the gap. The error of a fourth-order spline falls to a sixteenth where the gap is
/// halved; half of that gain is counted on.
constexpr double gain_of_half_the_gap = 8;
/// Fewer points than this do not predict one another.
constexpr std::size_t fewest_points_to_predict_one = 5;
/// A curve has at least this many points.
constexpr std::size_t fewest_points = 3;
/// Relative, for comparing ratios of forces that were computed in different ways.
constexpr double rounding_of_a_gap = 1e-9, rounding_of_a_force = 1e-12;

std::string newtons(double force_N) { return plain(force_N, 4) + " N"; }

/// The larger of both disagreements over its bound; above 1 it is beyond the bound. Infinite where a number is not
/// finite.
double against(const CurveRequest& request, const Disagreement& here) {
  const double ratio = std::max(here.force / request.force_bound, here.minimum / request.film_bound);
  return std::isfinite(here.force) && std::isfinite(here.minimum) ? ratio : infinity;
}

/// Whether a curve has the errors that were asked for.
bool within(const CurveRequest& request, const CurveErrors& errors) {
  return std::max(errors.interpolation_force, errors.joint_force) <= request.force_bound &&
         std::max(errors.interpolation, errors.joint) <= request.film_bound;
}

Disagreement over_half_the_gap(const Disagreement& over_the_gap) {
  constexpr double gain = gain_of_half_the_gap;
  return {.force = over_the_gap.force / gain,
          .offset = over_the_gap.offset / gain,
          .minimum = over_the_gap.minimum / gain,
          .rolling = over_the_gap.rolling / gain};
}

/// The largest disagreements that were met, and the force whose disagreement is furthest beyond the bounds.
struct Worst {
  double film = 0, force = 0, rolling = 0;
  double ratio = 1;
  std::optional<double> at_N = {};

  void meet(const Disagreement& here) {
    film = std::max(film, here.film());
    force = std::max(force, here.force);
    rolling = std::max(rolling, here.rolling);
  }
  void propose(double force_N, double ratio_there) {
    if (!(ratio_there > ratio)) return;
    ratio = ratio_there;
    at_N = force_N;
  }
};

/// The points of a curve, and the extra solves that its gaps are judged by.
class Refinement {
 public:
  Refinement(const SolvableContact& contacts, CurveRequest request) : points_(contacts), request_(std::move(request)) {}

  /// Solves a point of the curve, or says why it cannot.
  [[nodiscard]] std::optional<SolveFailure> add_point(double force_N) {
    if (auto failure = points_.add(force_N)) {
      met_limit_ = met_limit_ || failure->limit;
      return failure;
    }
    nodes_.insert(force_N);
    return std::nullopt;
  }
  /// A contact that was wanted ran out of iterations or time.
  [[nodiscard]] bool met_limit() const { return met_limit_; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] double lightest_N() const { return *nodes_.begin(); }

  /// Splits the gap whose extra solve disagrees most, until all agree.
  void split_gaps() {
    while (true) {
      worst_ = judge_gaps();
      if (!worst_.at_N) return;
      nodes_.insert(*worst_.at_N);
    }
  }

  /// An extra solve shows no error where the error changes its sign. So each point is also predicted from the others.
  /// Where the prediction fails, both neighbouring gaps are split. Extra solves are points from here on.
  void split_beside_points_that_others_do_not_predict() {
    nodes_.insert(extras_.begin(), extras_.end());
    extras_.clear();
    const Worst of_gaps{.film = worst_.film, .force = worst_.force, .rolling = worst_.rolling};
    std::set<double> left;  // points whose gaps cannot be split any more
    while (true) {
      worst_ = judge_points(of_gaps, left);
      if (!worst_.at_N) return;
      left.insert(*worst_.at_N);
      if (split_beside(*worst_.at_N)) left.erase(*worst_.at_N);
    }
  }

  /// The curve through the points and extra solves at `down_to_N` and above.
  [[nodiscard]] FilmCurve curve(double down_to_N = 0, CurveErrors errors = {}) const {
    std::set<double> all = nodes_;
    all.insert(extras_.begin(), extras_.end());
    all.erase(all.begin(), all.lower_bound(down_to_N));
    return points_.curve(all, std::move(errors));
  }
  /// The curve's errors, without those below the lightest point.
  [[nodiscard]] CurveErrors errors() const {
    CurveErrors errors;
    errors.interpolation = worst_.film;
    errors.interpolation_force = worst_.force;
    errors.rolling = worst_.rolling;
    points_.put_solver_errors(errors);
    return errors;
  }
  /// The error below `lightest_N` of the curve that ends there, judged by the lighter contact solved at `force_N`.
  [[nodiscard]] Disagreement continuation(double lightest_N, double force_N) const {
    std::set<double> with_it = nodes_;
    with_it.insert(extras_.begin(), extras_.end());
    with_it.insert(force_N);
    with_it.erase(with_it.begin(), with_it.find(force_N));
    return points_.continuation(curve(lightest_N), points_.curve(with_it), force_N);
  }
  /// Solves a contact that is no point yet, or remembers it. False where it cannot be solved or there are too many.
  [[nodiscard]] bool solved(double force_N, std::string* why = nullptr) {
    if (points_.has(force_N)) return true;
    if (failed_.contains(force_N) || points_.size() >= static_cast<std::size_t>(request_.most_points)) return false;
    if (const auto failure = points_.add(force_N)) {
      if (why) *why = failure->why;
      met_limit_ = met_limit_ || failure->limit;
      failed_.insert(force_N);
      return false;
    }
    return true;
  }

 private:
  [[nodiscard]] Worst judge_gaps() {
    const FilmCurve curve = points_.curve(nodes_);
    Worst worst;
    extras_.clear();
    for (auto low = nodes_.begin(), high = std::next(low); high != nodes_.end(); ++low, ++high) {
      const double between = extra_between(*low, *high);
      if (!solved(between)) {
        worst.film = worst.force = worst.rolling = infinity;  // nothing was checked in this gap
        continue;
      }
      extras_.insert(between);
      const Disagreement here = points_.disagreement(curve, between);
      worst.meet(here);
      if (is_smallest(*high / *low)) continue;
      // One extra solve says nothing of a gap this wide: beside a bend the error may change its sign just there.
      const bool wide = *high / *low > request_.widest_gap * (1 + rounding_of_a_gap);
      worst.propose(between, wide ? infinity : against(request_, here));
    }
    return worst;
  }

  [[nodiscard]] Worst judge_points(Worst worst, const std::set<double>& left) const {
    if (nodes_.size() < fewest_points_to_predict_one) return worst;
    for (auto at = std::next(nodes_.begin()); std::next(at) != nodes_.end(); ++at) {
      std::set<double> others = nodes_;
      others.erase(*at);
      const Disagreement here = over_half_the_gap(points_.disagreement(points_.curve(others), *at));
      worst.meet(here);
      if (!left.contains(*at)) worst.propose(*at, against(request_, here));
    }
    return worst;
  }

  /// False where neither gap beside the point can be split.
  [[nodiscard]] bool split_beside(double point) {
    const auto at = nodes_.find(point);
    const double below = *std::prev(at), above = *std::next(at);
    bool any = false;
    for (const double middle : {extra_between(below, point), extra_between(point, above)}) {
      const double gap = middle < point ? point / below : above / point;
      if (is_smallest(gap) || !solved(middle)) continue;
      nodes_.insert(middle);
      any = true;
    }
    return any;
  }

  [[nodiscard]] bool is_smallest(double gap) const { return std::sqrt(gap) < request_.smallest_gap; }

  /// The middle of a gap, or the given force in the gap that is nearest to it.
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

  CurvePoints points_;
  CurveRequest request_;
  std::set<double> nodes_, extras_, failed_;
  Worst worst_;
  bool met_limit_ = false;
};

/// Where the solved points end.
struct LightEnd {
  std::string because = {};     ///< empty while the curve may still go down
  bool at_rigid_limit = false;  ///< Martin's films take over within the bounds
};

/// The first points: the lightest and the heaviest contact of the fit, which are solved anyway, and two lighter ones.
LightEnd add_first_points(Refinement& refinement, const CurveRequest& request) {
  LightEnd end;
  double lighter = request.heaviest_N / descent;
  for (const double given : request.given_N)
    if (given == request.given_N.front() || given == request.given_N.back()) {
      if (!refinement.add_point(given)) lighter = std::min(lighter, std::exp2(std::floor(std::log2(given) - 0.5)));
    }
  for (int k = 0; k < 2 && end.because.empty(); ++k, lighter /= descent)
    if (const auto failure = refinement.add_point(lighter))
      end.because = newtons(lighter) + " could not be solved: " + failure->why;
  return end;
}

/// Down to where the curve's continuation below its lightest force is within the bounds, judged by a contact of half
/// that force.
void descend(Refinement& refinement, const CurveRequest& request, LightEnd& end) {
  while (end.because.empty()) {
    const double half = refinement.lightest_N() / 2;
    std::string why = "too many points";
    if (!refinement.solved(half, &why)) {
      end.because = newtons(half) + " could not be solved: " + why;
      return;
    }
    if (against(request, refinement.continuation(refinement.lightest_N(), half)) <= 1) {
      end.because = fmt::format("below {} the rigid-roller formula is used; it was checked at {}",
                                newtons(refinement.lightest_N()), newtons(half));
      end.at_rigid_limit = true;
      return;
    }
    const double lighter = refinement.lightest_N() / descent;  // the half is then the middle of a gap
    if (const auto not_added = refinement.add_point(lighter)) {
      if (refinement.add_point(half)) throw std::logic_error("film curve: a solved contact is lost");
      end.because = newtons(lighter) + " could not be solved: " + not_added->why;
    }
    refinement.split_gaps();
  }
}

/// The error of the films below the lightest point (CurveErrors::joint); absent where too few points are left.
std::optional<Disagreement> error_below(const Refinement& refinement, bool at_rigid_limit) {
  const FilmCurve curve = refinement.curve();
  if (at_rigid_limit) return refinement.continuation(curve.lightest_N(), curve.lightest_N() / 2);
  const double from_N = descent * curve.lightest_N() * (1 - rounding_of_a_force);
  const auto enough = std::count_if(curve.forces_N().begin(), curve.forces_N().end(),
                                    [&](double f) { return f >= from_N; }) >= static_cast<long>(fewest_points);
  if (!enough) return std::nullopt;
  return refinement.continuation(from_N, curve.lightest_N());
}

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

std::variant<FilmCurve, SolveFailure> build_curve(const SolvableContact& contacts, const CurveRequest& asked) {
  const CurveRequest request = as_met(asked);
  Refinement refinement(contacts, request);
  const double top = request.heaviest_N;
  if (const auto failure = refinement.add_point(top))
    return SolveFailure{.why = fmt::format("at a contact force of {}: {}", newtons(top), failure->why),
                        .limit = failure->limit};
  LightEnd end = add_first_points(refinement, request);
  if (refinement.size() < fewest_points)
    return SolveFailure{.why = fmt::format("only {} contact forces up to {} could be solved, three are needed; {}",
                                           refinement.size(), newtons(top), end.because),
                        .limit = refinement.met_limit()};

  refinement.split_gaps();
  descend(refinement, request, end);
  refinement.split_beside_points_that_others_do_not_predict();

  CurveErrors errors = refinement.errors();
  const std::optional<Disagreement> below = error_below(refinement, end.at_rigid_limit);
  errors.joint = below ? below->film() : infinity;
  errors.joint_force = below ? below->force : infinity;
  errors.rolling = below ? std::max(errors.rolling, below->rolling) : infinity;
  errors.lightest_because = end.because;
  errors.cut_short = refinement.met_limit() && !within(request, errors);
  return refinement.curve(0, std::move(errors));
}

}  // namespace ehd::bearing
