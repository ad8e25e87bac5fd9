// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/equilibrium.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace ehd::bearing {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double infinity = std::numeric_limits<double>::infinity();
/// Of cos psi: a roller this close to 90 degrees multiplies the load by more than a million.
constexpr double grazing = 1e-6;

std::string text(const char* format, double first, double second) {
  char buffer[240];
  std::snprintf(buffer, sizeof buffer, format, first, second);
  return buffer;
}

/// A sum that keeps what additions round away (Neumaier).
class CarefulSum {
 public:
  void add(double term) {
    const double next = sum_ + term;
    lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }
  [[nodiscard]] double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0, lost_ = 0;
};

/// One roller between its raceways, over the excess s of the total approach over the one at which it begins to carry:
///   r(f_i) = [delta_i(f_i) - delta_i(0)] + [delta_o(f_i + F_c) - delta_o(F_c)] - s = 0, increasing in f_i,
/// the brackets without cancellation. Where a film begins nowhere, s is the total approach itself.
class RollerBalance {
 public:
  RollerBalance(const LawPair& laws, double centrifugal_N)
      : laws_(laws),
        centrifugal_N_(centrifugal_N),
        inner_begins_m_(begins_at(laws.inner)),
        outer_alone_m_(approach(laws.outer, centrifugal_N)),
        begins_(std::isfinite(inner_begins_m_ + outer_alone_m_)) {}

  /// The total approach from which s counts.
  [[nodiscard]] double origin_m() const { return begins_ ? inner_begins_m_ + outer_alone_m_ : 0; }
  [[nodiscard]] bool begins() const { return begins_; }

  [[nodiscard]] double excess_m(double f) const {
    if (!begins_) return approach(laws_.inner, f) + approach(laws_.outer, f + centrifugal_N_);
    return f > 0 ? rise(laws_.inner, 0, f) + rise(laws_.outer, centrifugal_N_, f) : 0;
  }

  [[nodiscard]] RollerState at(double s, double guess_N) const {
    RollerState roller;
    if (begins_ && s <= 0) {
      roller.outer = {centrifugal_N_, outer_alone_m_};
      roller.inner = {0, inner_begins_m_ + s};
      return roller;
    }
    const double f = solve(s, guess_N);
    roller.inner = {f, approach(laws_.inner, f)};
    roller.outer = {f + centrifugal_N_, s + origin_m() - roller.inner.approach_m};
    const double slope = compliance_at(f);
    roller.stiffness_N_per_m = slope > 0 ? 1 / slope : 0;
    return roller;
  }

  /// What the forces miss of their own balance [N]: the approach that they leave over, times the stiffness.
  [[nodiscard]] double error_N(const RollerState& roller, double s) const {
    const double forces = std::abs(roller.outer.force_N - roller.inner.force_N - centrifugal_N_);
    if (roller.at_jump || roller.inner.force_N == 0) return forces;
    return forces + std::abs(excess_m(roller.inner.force_N) - s) * roller.stiffness_N_per_m;
  }

 private:
  [[nodiscard]] double compliance_at(double f) const {
    return compliance(laws_.inner, f) + compliance(laws_.outer, f + centrifugal_N_);
  }

  [[nodiscard]] double solve(double s, double guess_N) const {
    double low = 0, high = guess_N > 0 ? guess_N : std::max(centrifugal_N_, 1.0);
    while (!(excess_m(high) >= s) && high < 1e300) {
      low = high;
      high *= 4;
    }
    double f = high;
    for (int iteration = 0; iteration < 400; ++iteration) {
      const double r = excess_m(f) - s;
      if (r == 0) return f;
      (r < 0 ? low : high) = f;
      double next = f - r / compliance_at(f);
      if (!(next > low && next < high) || next < f / 16) next = low > 0 ? std::sqrt(low * high) : high / 16;
      if (std::abs(next - f) <= epsilon * f || next < std::numeric_limits<double>::min()) return next;
      f = next;
    }
    return f;
  }

  const LawPair& laws_;
  double centrifugal_N_, inner_begins_m_, outer_alone_m_;
  bool begins_;
};

/// The rollers at one position of the ring.
struct RingState {
  std::vector<RollerState> groups;
  Vector2d force_N = Vector2d::Zero();  ///< Sum f_i (cos psi, sin psi)
  Matrix2d stiffness_N_per_m = Matrix2d::Zero();
  double total_N = 0;  ///< Sum f_i
};

/// Rollers over the displacement v of the ring from a reference. Where a dry ring has room, the reference is where the
/// directions a and b just touch, those of the rollers beside the load line. With c the gap in the middle, the excess
/// of a roller there is, without a difference of nearly equal numbers,
///   c [cos(psi - (a+b)/2)/cos((b-a)/2) - 1] = -2 c sin((psi-a)/2) sin((psi-b)/2)/cos((b-a)/2),
/// to which v adds v_x cos psi + v_y sin psi. Else the reference is the middle.
class Ring {
 public:
  struct Group {
    Vector2d direction;  ///< (cos psi, sin psi); across the load 0 in the radial form
    double excess_m;     ///< at the reference
    std::vector<int> members;
  };

  Ring(const Geometry& geometry, const LawPair& laws, const Loading& loading, Form form)
      : azimuths_(azimuths_deg(geometry)),
        roller_(laws, loading.centrifugal_N),
        gap_m_(geometry.clearance_m / 2 + roller_.origin_m()) {
    plane_ = form == Form::plane && !symmetric_to_load(azimuths_);
    if (plane_) {
      for (int j = 0; j < static_cast<int>(azimuths_.size()); ++j)
        add_group(azimuths_[static_cast<std::size_t>(j)], {j});
    } else {
      for (const RollerGroup& group : mirror_groups(azimuths_)) add_group(group.azimuth_deg, group.members);
    }
    find_directions_beside_the_load();
    counts_from_touch_ = roller_.begins() && gap_m_ > 0 && loading.radial_N > 0 && can_carry();
    for (std::size_t g = 0; g < groups_.size(); ++g)
      groups_[g].excess_m = counts_from_touch_ ? excess_at_touch_m(azimuth_of_[g]) : -gap_m_;
    guess_N_.assign(groups_.size(), 0.0);
  }

  [[nodiscard]] bool plane() const { return plane_; }
  [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }
  [[nodiscard]] const std::vector<double>& azimuths() const { return azimuths_; }
  [[nodiscard]] const RollerBalance& roller() const { return roller_; }
  [[nodiscard]] bool counts_from_touch() const { return counts_from_touch_; }
  [[nodiscard]] double gap_m() const { return gap_m_; }
  [[nodiscard]] double first_deg() const { return first_deg_; }
  [[nodiscard]] double second_deg() const { return second_deg_; }
  [[nodiscard]] int evaluations() const { return evaluations_; }
  /// The load lies between two directions that are less than a half turn apart.
  [[nodiscard]] bool can_carry() const { return half_cosine() > grazing; }

  [[nodiscard]] Vector2d displacement_m(const Vector2d& v) const {
    if (!counts_from_touch_) return v;
    const double middle = (first_deg_ + second_deg_) / 2;  // exactly 0 for a mirrored pair
    return v + gap_m_ / half_cosine() * Vector2d(cosine_of_degrees(middle), sine_of_degrees(middle));
  }

  [[nodiscard]] double excess_m(const Group& group, const Vector2d& v) const {
    return group.excess_m + group.direction.dot(v);
  }

  [[nodiscard]] RingState at(const Vector2d& v) {
    RingState state;
    ++evaluations_;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      state.groups.push_back(roller_.at(excess_m(groups_[g], v), guess_N_[g]));
      guess_N_[g] = state.groups.back().inner.force_N;
    }
    sum(state);
    return state;
  }

  void sum(RingState& state) const {
    CarefulSum along, across, total;
    state.stiffness_N_per_m.setZero();
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      const auto count = static_cast<double>(groups_[g].members.size());
      const Vector2d& n = groups_[g].direction;
      const double f = count * state.groups[g].inner.force_N;
      along.add(f * n.x());
      across.add(f * n.y());
      total.add(f);
      state.stiffness_N_per_m += count * state.groups[g].stiffness_N_per_m * n * n.transpose();
    }
    state.force_N = {along.value(), across.value()};
    state.total_N = total.value();
  }

 private:
  void add_group(double azimuth, std::vector<int> members) {
    groups_.push_back({{cosine_of_degrees(azimuth), plane_ ? sine_of_degrees(azimuth) : 0.0}, 0, std::move(members)});
    azimuth_of_.push_back(azimuth);
  }

  void find_directions_beside_the_load() {
    if (plane_) {
      first_deg_ = -180;
      second_deg_ = 180;
      for (const double azimuth : azimuths_) {
        if (azimuth <= 0) first_deg_ = std::max(first_deg_, azimuth);
        if (azimuth >= 0) second_deg_ = std::min(second_deg_, azimuth);
      }
    } else {
      // The roller nearest to the load line and its mirror image, whether or not that is a roller.
      second_deg_ = *std::min_element(azimuth_of_.begin(), azimuth_of_.end());
      first_deg_ = -second_deg_;
    }
  }

  [[nodiscard]] double half_cosine() const {
    const double half = (second_deg_ - first_deg_) / 2;
    return half < 180 ? cosine_of_degrees(half) : -1;
  }
  [[nodiscard]] double excess_at_touch_m(double azimuth) const {
    return -2 * gap_m_ * sine_of_degrees((azimuth - first_deg_) / 2) * sine_of_degrees((azimuth - second_deg_) / 2) /
           half_cosine();
  }

  std::vector<double> azimuths_, azimuth_of_;
  RollerBalance roller_;
  double gap_m_;
  bool plane_ = false, counts_from_touch_ = false;
  double first_deg_ = 0, second_deg_ = 0;
  std::vector<Group> groups_;
  std::vector<double> guess_N_;
  int evaluations_ = 0;
};

bool jumps(const ForceLaw& law) {
  const auto* line = std::get_if<LinearLaw>(&law);
  return line && line->unloading == Unloading::at_zero_approach;
}

/// A place of the ring, and what its forces miss of the load there.
struct Place {
  Vector2d v = Vector2d::Zero();
  RingState state;
  double miss_N = infinity;
};

/// The search along one line from a place, v + t direction: where the force along it, less the load's part, is zero.
struct Crossing {
  Place best;           ///< of all t that were tried, the one with the least miss along the line
  bool jumped = false;  ///< the bracket closed to nothing, and the force jumps there
  Place low, high;      ///< the bracket's ends, where it closed
};

/// `enough_N`: the miss at which to stop; rounding always ends it. Newton with the exact slope; outwards in doubled
/// steps where there is no bracket yet, halving where a step leaves it or stalls.
Crossing cross(Ring& ring, const Vector2d& load_N, const Vector2d& from, const Vector2d& direction, double low,
               double t, double reach, double enough_N) {
  Crossing crossing;
  double high = infinity, width_before = infinity;
  for (int iteration = 0; iteration < 400; ++iteration) {
    Place place;
    place.v = from + t * direction;
    place.state = ring.at(place.v);
    const double signed_miss = (place.state.force_N - load_N).dot(direction);
    const double slope = direction.dot(place.state.stiffness_N_per_m * direction);
    place.miss_N = std::abs(signed_miss);
    if (!std::isfinite(signed_miss)) {
      crossing.best = place;
      return crossing;
    }
    const double total = place.state.total_N;
    if (place.miss_N < crossing.best.miss_N) crossing.best = place;
    if (crossing.best.miss_N <= std::max(enough_N, epsilon * std::max(load_N.norm(), total) * direction.norm())) break;
    (signed_miss < 0 ? low : high) = t;
    (signed_miss < 0 ? crossing.low : crossing.high) = place;
    const double width = high - low;
    if (std::isfinite(width) && (width <= epsilon * std::max(std::abs(low), std::abs(high)) || width < 1e-30)) {
      crossing.jumped = crossing.low.state.groups.size() == crossing.high.state.groups.size();
      break;
    }
    double next = t - signed_miss / slope;
    const bool stalls = iteration % 4 == 3 && width > width_before / 16;
    if (iteration % 4 == 3) width_before = width;
    if (!std::isfinite(high) || !std::isfinite(low)) {
      if (!(std::abs(next - t) <= reach)) next = signed_miss < 0 ? t + reach : t - reach;
      reach *= 2;
    } else if (stalls || !(next > low && next < high)) {
      next = low + width / 2;
    }
    if (next == t || next == low || next == high) break;
    t = next;
  }
  return crossing;
}

/// The rollers that sit on the vertical part of a law that lets go at a finite force share what is missing.
Place share_the_jump(const Ring& ring, const Vector2d& load_N, double centrifugal_N, const Crossing& crossing) {
  const double below = crossing.low.state.force_N.x(), above = crossing.high.state.force_N.x();
  const double share = (load_N.x() - below) / (above - below);
  Place place = crossing.high;
  for (std::size_t g = 0; g < ring.groups().size(); ++g) {
    RollerState& roller = place.state.groups[g];
    const double less = crossing.low.state.groups[g].inner.force_N, more = roller.inner.force_N;
    roller.inner.force_N = less + share * (more - less);
    roller.outer.force_N = roller.inner.force_N + centrifugal_N;
    roller.at_jump = more - less > 1e-6 * more;
  }
  ring.sum(place.state);
  place.miss_N = std::abs(place.state.force_N.x() - load_N.x());
  return place;
}

/// Stribeck's estimate of the largest roller force.
double estimate_N(const Ring& ring, double load_N) {
  return 4.08 * load_N / static_cast<double>(ring.azimuths().size());
}

Place balance_along_the_load(Ring& ring, const LawPair& laws, const Loading& loading) {
  const Vector2d load_N(loading.radial_N, 0);
  const double largest_cosine = cosine_of_degrees(ring.second_deg());
  const double excess = ring.roller().excess_m(estimate_N(ring, loading.radial_N));
  const double start = (excess + (ring.counts_from_touch() ? 0 : ring.gap_m())) / largest_cosine;
  const Crossing crossing =
      cross(ring, load_N, Vector2d::Zero(), Vector2d::UnitX(), -infinity, start, std::max(std::abs(start), 1e-9), 0);
  if (crossing.jumped && (jumps(laws.inner) || jumps(laws.outer)) &&
      crossing.best.miss_N > largest_balance_error * loading.radial_N)
    return share_the_jump(ring, load_N, loading.centrifugal_N, crossing);
  return crossing.best;
}

/// Where two rollers beside the load would carry it alone, no deeper than Stribeck's estimate; the middle else.
Vector2d start_in_the_plane(const Ring& ring, double load_N) {
  if (!ring.counts_from_touch()) return Vector2d::Zero();
  const double a = ring.first_deg(), b = ring.second_deg(), between = sine_of_degrees(b - a);
  const Vector2d forces = load_N / between * Vector2d(sine_of_degrees(b), -sine_of_degrees(a));
  const double part = std::min(1.0, estimate_N(ring, load_N) / forces.maxCoeff());
  const double first = ring.roller().excess_m(part * forces.x()), second = ring.roller().excess_m(part * forces.y());
  return Vector2d(first * sine_of_degrees(b) - second * sine_of_degrees(a),
                  second * cosine_of_degrees(a) - first * cosine_of_degrees(b)) /
         between;
}

/// Newton's step, in each principal direction of the stiffness no longer than `reach`: where a direction has no
/// stiffness (one roller carries, or none) the ring goes that far along it, and the search along the step goes on.
Vector2d newton_step(const Matrix2d& stiffness, const Vector2d& missing_N, double reach) {
  const Eigen::SelfAdjointEigenSolver<Matrix2d> principal(stiffness);
  Vector2d step = Vector2d::Zero();
  for (int k = 0; k < 2; ++k) {
    const Vector2d axis = principal.eigenvectors().col(k);
    const double force = axis.dot(missing_N);
    if (force == 0) continue;
    step += force / std::max(principal.eigenvalues()(k), std::abs(force) / reach) * axis;
  }
  return step;
}

Place balance_in_the_plane(Ring& ring, const Loading& loading) {
  const Vector2d load_N(loading.radial_N, 0);
  Place here;
  here.v = start_in_the_plane(ring, loading.radial_N);
  here.state = ring.at(here.v);
  Place best;
  int without_gain = 0;
  for (int iteration = 0; iteration < 200; ++iteration) {
    const Vector2d missing_N = load_N - here.state.force_N;
    here.miss_N = missing_N.lpNorm<Eigen::Infinity>();
    if (!std::isfinite(here.miss_N)) return best;
    const double scale = std::max(loading.radial_N, here.state.total_N);
    without_gain = here.miss_N < 0.9 * best.miss_N ? 0 : without_gain + 1;
    if (here.miss_N < best.miss_N) best = here;
    // At rounding; or near it, and getting nowhere; or stuck at a jump, where no displacement balances.
    constexpr int patience_at_rounding = 2, patience = 30;
    if (best.miss_N <= epsilon * scale || without_gain > patience ||
        (without_gain > patience_at_rounding && best.miss_N <= 1e3 * epsilon * scale))
      break;
    const double reach = std::max({std::abs(ring.gap_m()), here.v.norm(), 1e-6});
    const Vector2d step = newton_step(here.state.stiffness_N_per_m, missing_N, reach);
    const double pull_N = missing_N.dot(step);
    if (!(pull_N > 0)) break;
    here = cross(ring, load_N, here.v, step, 0, 1, 1, pull_N / 2).best;
  }
  return best;
}

}  // namespace

std::string_view to_string(Form form) { return form == Form::plane ? "plane" : "radial"; }

RollerState balance_roller(const LawPair& laws, double centrifugal_N, double total_approach_m, double guess_N) {
  const RollerBalance roller(laws, centrifugal_N);
  return roller.at(total_approach_m - roller.origin_m(), guess_N);
}

std::variant<Equilibrium, NoEquilibrium> balance(const Geometry& geometry, const LawPair& laws, const Loading& loading,
                                                 Form form) {
  const double load = loading.radial_N;
  if (!(load >= 0) || !std::isfinite(load))
    return NoEquilibrium{text("the radial load is %g N; it must be finite and not negative", load, 0)};
  Ring ring(geometry, laws, loading, form);
  if (load > 0 && !ring.can_carry())
    return NoEquilibrium{ring.plane()
                             ? "no two rollers stand less than a half turn apart with the load between them, so "
                               "nothing can carry it"
                             : "no roller stands on the loaded side, so nothing can carry the load"};

  // Without a load equally spaced rollers hold the ring in the middle; where there is room it may stand anywhere near.
  Place place;
  if (load == 0) {
    place.state = ring.at(Vector2d::Zero());
  } else {
    place = ring.plane() ? balance_in_the_plane(ring, loading) : balance_along_the_load(ring, laws, loading);
  }
  Equilibrium result;
  const Vector2d displacement = ring.displacement_m(place.v);
  result.displacement_m = displacement.x();
  result.lateral_displacement_m = displacement.y();
  if (ring.counts_from_touch()) result.position.touching_deg = std::pair{ring.first_deg(), ring.second_deg()};
  result.position.beyond_x_m = place.v.x();
  result.position.beyond_y_m = place.v.y();
  if (place.state.groups.empty() || !place.state.force_N.allFinite())
    return NoEquilibrium{
        text("roller forces are not finite at a displacement of %g m (load %g N)", result.displacement_m, load)};

  // What is returned balances, or nothing is: all rollers, each in its own direction.
  result.azimuths_deg = ring.azimuths();
  result.rollers.resize(result.azimuths_deg.size());
  result.groups = static_cast<int>(ring.groups().size());
  result.newton_iterations = ring.evaluations();
  result.rollers_balanced = static_cast<long>(result.groups) * result.newton_iterations;
  double worst_N = 0;
  for (std::size_t g = 0; g < ring.groups().size(); ++g) {
    const Ring::Group& group = ring.groups()[g];
    worst_N = std::max(worst_N, ring.roller().error_N(place.state.groups[g], ring.excess_m(group, place.v)));
    for (const int member : group.members) result.rollers[static_cast<std::size_t>(member)] = place.state.groups[g];
  }
  CarefulSum along, across, outer;
  for (std::size_t j = 0; j < result.rollers.size(); ++j) {
    const RollerState& roller = result.rollers[j];
    const double cosine = cosine_of_degrees(result.azimuths_deg[j]), sine = sine_of_degrees(result.azimuths_deg[j]);
    along.add(roller.inner.force_N * cosine);
    across.add(roller.inner.force_N * sine);
    outer.add(roller.outer.force_N);
    result.stiffness_N_per_m[0][0] += roller.stiffness_N_per_m * cosine * cosine;
    result.stiffness_N_per_m[0][1] += roller.stiffness_N_per_m * cosine * sine;
    result.stiffness_N_per_m[1][1] += roller.stiffness_N_per_m * sine * sine;
  }
  result.stiffness_N_per_m[1][0] = result.stiffness_N_per_m[0][1];
  result.lateral_force_N = across.value();
  worst_N = std::max(worst_N, std::abs(along.value() - load));
  if (form == Form::plane) worst_N = std::max(worst_N, std::abs(across.value()));
  const double scale = std::max(load, outer.value());
  result.balance_error = scale > 0 ? worst_N / scale : 0;
  if (!(result.balance_error <= largest_balance_error)) {
    const bool jump = ring.plane() && (jumps(laws.inner) || jumps(laws.outer));
    return NoEquilibrium{
        text("the forces balance only to %g of the larger of load and roller forces, %g N", result.balance_error,
             scale) +
        (jump ? "; rollers on the jump of a law that is cut at delta = 0 are balanced in the radial form only" : "")};
  }
  for (const ForceLaw* law : {&laws.inner, &laws.outer}) {
    const auto* logarithm = std::get_if<LogarithmicLaw>(law);
    double largest_N = 0;
    for (const RollerState& roller : result.rollers)
      largest_N = std::max(largest_N, (law == &laws.inner ? roller.inner : roller.outer).force_N);
    if (logarithm && largest_N > logarithm->heaviest_N())
      return NoEquilibrium{
          text("a contact would carry %g N, beyond the domain of its law: the half width must stay below an "
               "eighth of the length in the logarithm, allowed is up to %g N",
               largest_N, logarithm->heaviest_N())};
  }
  return result;
}

std::optional<std::pair<double, double>> load_zone_deg(const Equilibrium& equilibrium, double share) {
  double largest_N = 0;
  for (const RollerState& roller : equilibrium.rollers) largest_N = std::max(largest_N, roller.inner.force_N);
  if (!(largest_N > 0)) return std::nullopt;
  std::pair<double, double> zone{180, -180};
  for (std::size_t j = 0; j < equilibrium.rollers.size(); ++j) {
    const double force_N = equilibrium.rollers[j].inner.force_N;
    if (!(force_N > 0 && force_N >= share * largest_N)) continue;
    zone.first = std::min(zone.first, equilibrium.azimuths_deg[j]);
    zone.second = std::max(zone.second, equilibrium.azimuths_deg[j]);
  }
  return zone;
}

}  // namespace ehd::bearing
