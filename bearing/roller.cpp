// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/roller.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ehd::bearing {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double smallest = std::numeric_limits<double>::min();

/// The first bracket starts from this force where nothing is known of the roller [N].
constexpr double start_N = 1;
/// The upper end of the bracket grows by this factor, up to a force that no bearing carries [N].
constexpr double growth = 4, end_of_growth_N = 1e300;
/// Newton may take at most this factor off the force in one step. Beyond, the bracket is halved in the logarithm.
constexpr double largest_fall = 16;
/// Never reached in practice: bisection of the logarithms ends far earlier.
constexpr int most_iterations = 400;

}  // namespace

RollerBalance::RollerBalance(const LawPair& laws, double centrifugal_N)
    : laws_(laws),
      centrifugal_N_(centrifugal_N),
      inner_begins_m_(begins_at(laws.inner)),
      outer_alone_m_(approach(laws.outer, centrifugal_N)),
      begins_(std::isfinite(inner_begins_m_ + outer_alone_m_)) {}

double RollerBalance::excess_m(double f) const {
  if (!begins_) return approach(laws_.inner, f) + approach(laws_.outer, f + centrifugal_N_);
  return f > 0 ? rise(laws_.inner, 0, f) + rise(laws_.outer, centrifugal_N_, f) : 0;
}

RollerState RollerBalance::at(double s, double guess_N) const {
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

double RollerBalance::error_N(const RollerState& roller, double s) const {
  const double forces = std::abs(roller.outer.force_N - roller.inner.force_N - centrifugal_N_);
  if (roller.at_jump || roller.inner.force_N == 0) return forces;
  return forces + std::abs(excess_m(roller.inner.force_N) - s) * roller.stiffness_N_per_m;
}

double RollerBalance::compliance_at(double f) const {
  return compliance(laws_.inner, f) + compliance(laws_.outer, f + centrifugal_N_);
}

/// Newton in a bracket.
double RollerBalance::solve(double s, double guess_N) const {
  double low = 0, high = guess_N > 0 ? guess_N : std::max(centrifugal_N_, start_N);
  while (!(excess_m(high) >= s) && high < end_of_growth_N) {
    low = high;
    high *= growth;
  }
  double f = high;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const double r = excess_m(f) - s;
    if (r == 0) return f;
    (r < 0 ? low : high) = f;
    double next = f - r / compliance_at(f);
    if (!(next > low && next < high) || next < f / largest_fall)
      next = low > 0 ? std::sqrt(low * high) : high / largest_fall;
    if (std::abs(next - f) <= epsilon * f || next < smallest) return next;
    f = next;
  }
  return f;
}

RollerState balance_roller(const LawPair& laws, double centrifugal_N, double total_approach_m, double guess_N) {
  const RollerBalance roller(laws, centrifugal_N);
  return roller.at(total_approach_m - roller.origin_m(), guess_N);
}

}  // namespace ehd::bearing
