// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/ring_search.hpp"

#include <algorithm>
#include <cmath>

namespace ehd::bearing {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Stribeck's factor: the largest roller force is about this times the load over the number of rollers.
constexpr double stribeck = 4.08;

// ---- The search along a line
/// Never reached in practice: halving ends far earlier.
constexpr int most_iterations_on_a_line = 400;
/// The bracket must shrink to `shrinks_to` of its width in every `stall_period` iterations, else it is halved.
constexpr int stall_period = 4;
constexpr double shrinks_to = 1.0 / 16;
/// A bracket narrower than this is a point. Near zero a relative width means nothing.
constexpr double narrowest = 1e-30;
/// Factor by which the search goes further out where there is no bracket yet.
constexpr double reach_growth = 2;
/// A roller stands on the jump of its law where its force at the bracket's ends differs by more than this part of it.
constexpr double jump_of_a_roller = 1e-6;
/// The search along the load goes at least so far out in its first step [m].
constexpr double smallest_first_reach_m = 1e-9;

// ---- Newton in the plane
/// Never reached in practice: `patience` ends far earlier.
constexpr int most_iterations_in_the_plane = 200;
/// A step that leaves more than this part of the smallest miss so far counts as one without gain.
constexpr double gain = 0.9;
/// The search ends after more than so many steps in a row without gain: near rounding, and anywhere else (at a jump no
/// displacement balances).
constexpr int patience_at_rounding = 2, patience = 30;
/// Near rounding: the miss is at most so many times epsilon of the forces.
constexpr double near_rounding = 1e3;
/// Newton's step along a direction without stiffness is at least this long [m].
constexpr double smallest_reach_m = 1e-6;

bool jump_at_either(const LawPair& laws) { return jumps(laws.inner) || jumps(laws.outer); }

/// The result of a search along the line from + t direction, for the place where the force along it equals the load's
/// component. The miss_N of its places is this difference of forces times |direction|.
struct Crossing {
  Place best;           ///< of all t that were tried, the one with the least miss along the line
  bool jumped = false;  ///< the bracket closed to nothing, and the force jumps there
  Place low, high;      ///< the bracket's ends, where it closed
};

struct Line {
  Vector2 from = {}, direction = {};
  double low = -infinity;  ///< t at which the force is known to be too small
  double start = 0;        ///< t of the first try
  double reach = 0;        ///< how far t goes at first where there is no bracket
  double enough_N = 0;     ///< the miss at which to stop, times |direction|; rounding always ends the search
};

/// Newton with the exact slope; outwards in doubled steps where there is no bracket yet, halving where a step leaves
/// the bracket or stalls.
Crossing cross(Ring& ring, Vector2 load_N, const Line& line) {
  Crossing crossing;
  double low = line.low, high = infinity, t = line.start, reach = line.reach, width_before = infinity;
  for (int iteration = 0; iteration < most_iterations_on_a_line; ++iteration) {
    Place place;
    place.v = line.from + t * line.direction;
    place.state = ring.at(place.v);
    const double signed_miss = dot(place.state.force_N - load_N, line.direction);
    const double slope = dot(line.direction, place.state.stiffness_N_per_m * line.direction);
    place.miss_N = std::abs(signed_miss);
    if (!std::isfinite(signed_miss)) {
      crossing.best = place;
      return crossing;
    }
    const double rounding_N = epsilon * std::max(norm(load_N), place.state.total_N) * norm(line.direction);
    if (place.miss_N < crossing.best.miss_N) crossing.best = place;
    if (crossing.best.miss_N <= std::max(line.enough_N, rounding_N)) break;
    (signed_miss < 0 ? low : high) = t;
    (signed_miss < 0 ? crossing.low : crossing.high) = place;
    const double width = high - low;
    if (std::isfinite(width) && (width <= epsilon * std::max(std::abs(low), std::abs(high)) || width < narrowest)) {
      crossing.jumped = crossing.low.state.groups.size() == crossing.high.state.groups.size();
      break;
    }
    double next = t - signed_miss / slope;
    const bool look = iteration % stall_period == stall_period - 1;
    const bool stalls = look && width > width_before * shrinks_to;
    if (look) width_before = width;
    if (!std::isfinite(high) || !std::isfinite(low)) {
      if (!(std::abs(next - t) <= reach)) next = signed_miss < 0 ? t + reach : t - reach;
      reach *= reach_growth;
    } else if (stalls || !(next > low && next < high)) {
      next = low + width / 2;
    }
    if (next == t || next == low || next == high) break;
    t = next;
  }
  return crossing;
}

/// A law that is cut at delta = 0 jumps by dF there (force_law.hpp). Rollers on the jump share what the others leave of
/// the load.
Place share_the_jump(const Ring& ring, Vector2 load_N, double centrifugal_N, const Crossing& crossing) {
  const double below = crossing.low.state.force_N.x, above = crossing.high.state.force_N.x;
  const double share = (load_N.x - below) / (above - below);
  Place place = crossing.high;
  for (std::size_t g = 0; g < ring.groups().size(); ++g) {
    RollerState& roller = place.state.groups[g];
    const double less = crossing.low.state.groups[g].inner.force_N, more = roller.inner.force_N;
    roller.inner.force_N = less + share * (more - less);
    roller.outer.force_N = roller.inner.force_N + centrifugal_N;
    roller.at_jump = more - less > jump_of_a_roller * more;
  }
  ring.sum(place.state);
  place.miss_N = std::abs(place.state.force_N.x - load_N.x);
  return place;
}

/// Stribeck's estimate of the largest roller force.
double estimate_N(const Ring& ring, double load_N) {
  return stribeck * load_N / static_cast<double>(ring.azimuths().size());
}

/// The place where the two rollers beside the load would carry it alone, each with at most Stribeck's estimate. The
/// middle where v counts from there.
Vector2 start_in_the_plane(const Ring& ring, double load_N) {
  if (!ring.counts_from_touch()) return {};
  const double a = ring.first_deg(), b = ring.second_deg(), between = sine_of_degrees(b - a);
  const Vector2 forces = load_N / between * Vector2{sine_of_degrees(b), -sine_of_degrees(a)};
  const double part = std::min(1.0, estimate_N(ring, load_N) / std::max(forces.x, forces.y));
  const double first = ring.roller().excess_m(part * forces.x), second = ring.roller().excess_m(part * forces.y);
  return Vector2{first * sine_of_degrees(b) - second * sine_of_degrees(a),
                 second * cosine_of_degrees(a) - first * cosine_of_degrees(b)} /
         between;
}

/// Newton's step, in each principal direction of the stiffness no longer than `reach`. Where a direction has no
/// stiffness (one roller carries, or none) the ring goes that far along it, and the search along the step goes on.
Vector2 newton_step(const Symmetric2& stiffness, Vector2 missing_N, double reach) {
  const Principal of = principal(stiffness);
  Vector2 step;
  for (std::size_t k = 0; k < of.axes.size(); ++k) {
    const double force = dot(of.axes[k], missing_N);
    if (force == 0) continue;
    step = step + force / std::max(of.values[k], std::abs(force) / reach) * of.axes[k];
  }
  return step;
}

}  // namespace

Place balance_along_the_load(Ring& ring, const LawPair& laws, const Loading& loading) {
  const Vector2 load_N{loading.radial_N, 0};
  const double largest_cosine = cosine_of_degrees(ring.second_deg());
  const double excess = ring.roller().excess_m(estimate_N(ring, loading.radial_N));
  const double start = (excess + (ring.counts_from_touch() ? 0 : ring.gap_m())) / largest_cosine;
  const Crossing crossing = cross(
      ring, load_N, {.direction = {1, 0}, .start = start, .reach = std::max(std::abs(start), smallest_first_reach_m)});
  if (crossing.jumped && jump_at_either(laws) && crossing.best.miss_N > largest_balance_error * loading.radial_N)
    return share_the_jump(ring, load_N, loading.centrifugal_N, crossing);
  return crossing.best;
}

Place balance_in_the_plane(Ring& ring, const Loading& loading) {
  const Vector2 load_N{loading.radial_N, 0};
  Place here;
  here.v = start_in_the_plane(ring, loading.radial_N);
  here.state = ring.at(here.v);
  Place best;
  int without_gain = 0;
  for (int iteration = 0; iteration < most_iterations_in_the_plane; ++iteration) {
    const Vector2 missing_N = load_N - here.state.force_N;
    if (!is_finite(missing_N)) return best;
    here.miss_N = std::max(std::abs(missing_N.x), std::abs(missing_N.y));
    const double rounding_N = epsilon * std::max(loading.radial_N, here.state.total_N);
    without_gain = here.miss_N < gain * best.miss_N ? 0 : without_gain + 1;
    if (here.miss_N < best.miss_N) best = here;
    if (best.miss_N <= rounding_N || without_gain > patience ||
        (without_gain > patience_at_rounding && best.miss_N <= near_rounding * rounding_N))
      break;
    const double reach = std::max({std::abs(ring.gap_m()), norm(here.v), smallest_reach_m});
    const Vector2 step = newton_step(here.state.stiffness_N_per_m, missing_N, reach);
    const double pull_N = dot(missing_N, step);
    if (!(pull_N > 0)) break;
    here = cross(ring, load_N,
                 {.from = here.v, .direction = step, .low = 0, .start = 1, .reach = 1, .enough_N = pull_N / 2})
               .best;
  }
  return best;
}

}  // namespace ehd::bearing
