// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>

namespace ehd::bearing {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// r(f_i) = delta_i(f_i) + delta_o(f_i + F_c) - d, increasing.
struct Residual {
  const LawPair& laws;
  double centrifugal_N, total_m;

  [[nodiscard]] double at(double f) const {
    return approach(laws.inner, f) + approach(laws.outer, f + centrifugal_N) - total_m;
  }
  [[nodiscard]] double slope(double f) const {
    return compliance(laws.inner, f) + compliance(laws.outer, f + centrifugal_N);
  }
};

double solve_inner_force(const Residual& residual, double guess_N) {
  double low = 0, high = guess_N > 0 ? guess_N : std::max(residual.centrifugal_N, 1.0);
  while (!(residual.at(high) >= 0) && high < 1e300) {
    low = high;
    high *= 4;
  }
  double f = high;
  for (int iteration = 0; iteration < 400; ++iteration) {
    const double r = residual.at(f);
    if (r == 0) return f;
    (r < 0 ? low : high) = f;
    double next = f - r / residual.slope(f);
    if (!(next > low && next < high) || next < f / 16) next = low > 0 ? std::sqrt(low * high) : high / 16;
    if (std::abs(next - f) <= epsilon * f || next < std::numeric_limits<double>::min()) return next;
    f = next;
  }
  return f;
}

/// The groups of mirrored rollers at one position of the ring.
struct RingState {
  std::vector<RollerState> groups;
  double sum_N = 0;              ///< Sum f_i cos psi
  double stiffness_N_per_m = 0;  ///< its derivative to the approach of the most loaded roller
  double total_N = 0;            ///< Sum f_i
};

class Ring {
 public:
  Ring(const Geometry& geometry, const LawPair& laws, const Loading& loading)
      : azimuths_(azimuths_deg(geometry)),
        groups_(mirror_groups(azimuths_)),
        half_clearance_m_(geometry.clearance_m / 2),
        laws_(laws),
        loading_(loading),
        guess_N_(groups_.size(), 0.0) {
    for (const RollerGroup& group : groups_) largest_cosine_ = std::max(largest_cosine_, group.cosine);
  }

  [[nodiscard]] const std::vector<RollerGroup>& groups() const { return groups_; }
  [[nodiscard]] const std::vector<double>& azimuths() const { return azimuths_; }
  [[nodiscard]] double largest_cosine() const { return largest_cosine_; }
  [[nodiscard]] long balanced() const { return balanced_; }

  /// delta_r from the approach e of the most loaded roller, e = delta_r cos psi* - P_d/2.
  [[nodiscard]] double displacement_m(double e) const { return (e + half_clearance_m_) / largest_cosine_; }
  [[nodiscard]] double approach_of_displacement(double displacement_m) const {
    return displacement_m * largest_cosine_ - half_clearance_m_;
  }

  /// delta_r cos psi - P_d/2, written so that the most loaded roller has exactly e: no clearance is subtracted from a
  /// displacement that is nearly as large.
  [[nodiscard]] double total_approach_m(const RollerGroup& group, double e) const {
    const double ratio = group.cosine / largest_cosine_;
    return e * ratio + half_clearance_m_ * (ratio - 1);
  }

  [[nodiscard]] RingState at(double e) {
    RingState state;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      const RollerGroup& group = groups_[g];
      const RollerState roller = balance_roller(laws_, loading_.centrifugal_N, total_approach_m(group, e), guess_N_[g]);
      ++balanced_;
      guess_N_[g] = roller.inner.force_N;
      add(state, group, roller);
    }
    return state;
  }

  void add(RingState& state, const RollerGroup& group, const RollerState& roller) const {
    const auto count = static_cast<double>(group.members.size());
    state.sum_N += count * roller.inner.force_N * group.cosine;
    state.total_N += count * roller.inner.force_N;
    state.stiffness_N_per_m += count * roller.stiffness_N_per_m * group.cosine * group.cosine / largest_cosine_;
    state.groups.push_back(roller);
  }

 private:
  std::vector<double> azimuths_;
  std::vector<RollerGroup> groups_;
  double half_clearance_m_;
  const LawPair& laws_;
  Loading loading_;
  double largest_cosine_ = -1;
  std::vector<double> guess_N_;
  long balanced_ = 0;
};

bool jumps(const ForceLaw& law) {
  const auto* line = std::get_if<LinearLaw>(&law);
  return line && line->unloading == Unloading::at_zero_approach;
}

/// Largest error of a roller's own balance [N]: the approach that its forces leave over, times its stiffness.
double roller_error_N(const LawPair& laws, const RollerState& roller, double centrifugal_N, double total_m) {
  const double forces = std::abs(roller.outer.force_N - roller.inner.force_N - centrifugal_N);
  if (roller.at_jump || roller.inner.force_N == 0) return forces;
  const double left_over =
      approach(laws.inner, roller.inner.force_N) + approach(laws.outer, roller.outer.force_N) - total_m;
  return forces + std::abs(left_over) * roller.stiffness_N_per_m;
}

std::string text(const char* format, double first, double second) {
  char buffer[200];
  std::snprintf(buffer, sizeof buffer, format, first, second);
  return buffer;
}

}  // namespace

RollerState balance_roller(const LawPair& laws, double centrifugal_N, double total_approach_m, double guess_N) {
  RollerState roller;
  const double outer_alone_m = approach(laws.outer, centrifugal_N);
  if (total_approach_m <= begins_at(laws.inner) + outer_alone_m) {
    roller.outer = {centrifugal_N, outer_alone_m};
    roller.inner = {0, total_approach_m - outer_alone_m};
    return roller;
  }
  const Residual residual{laws, centrifugal_N, total_approach_m};
  const double f = solve_inner_force(residual, guess_N);
  roller.inner = {f, approach(laws.inner, f)};
  roller.outer = {f + centrifugal_N, total_approach_m - roller.inner.approach_m};
  const double slope = residual.slope(f);
  roller.stiffness_N_per_m = slope > 0 ? 1 / slope : 0;
  return roller;
}

std::variant<Equilibrium, NoEquilibrium> balance(const Geometry& geometry, const LawPair& laws,
                                                 const Loading& loading) {
  Ring ring(geometry, laws, loading);
  const double load = loading.radial_N;
  if (!(load >= 0) || !std::isfinite(load))
    return NoEquilibrium{text("the radial load is %g N; it must be finite and not negative", load, 0)};
  constexpr double grazing = 1e-6;  // a roller this close to 90 degrees multiplies the load by more than a million
  if (load > 0 && ring.largest_cosine() < grazing)
    return NoEquilibrium{"no roller stands on the loaded side, so nothing can carry the load"};

  // 1. A bracket of the approach e of the most loaded roller, from the load that it would carry in Stribeck's estimate.
  Equilibrium result;
  const double estimate_N = 4.08 * std::max(load, 1e-300) / geometry.rollers;
  double e = load > 0 ? approach(laws.inner, estimate_N) + approach(laws.outer, estimate_N + loading.centrifugal_N)
                      : ring.approach_of_displacement(0);
  RingState state = ring.at(e), low_state, high_state;
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  double best_e = e, best_miss = std::numeric_limits<double>::infinity();
  RingState best = state;
  double reach = std::max(std::abs(e), 1e-9);
  bool jumped = false;

  // 2. Newton, exact slope; outwards where there is no bracket yet, halving where a step leaves it or stalls.
  double width_before = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < 400; ++iteration) {
    ++result.newton_iterations;
    const double miss = state.sum_N - load;
    if (!std::isfinite(miss))
      return NoEquilibrium{
          text("roller forces are not finite at a displacement of %g m (load %g N)", ring.displacement_m(e), load)};
    if (std::abs(miss) < best_miss) {
      best_miss = std::abs(miss);
      best_e = e;
      best = state;
    }
    if (best_miss <= epsilon * std::max(load, state.total_N)) break;
    if (miss < 0) {
      low = e;
      low_state = state;
    } else {
      high = e;
      high_state = state;
    }
    const double width = high - low;
    if (std::isfinite(width) && (width <= epsilon * std::max(std::abs(low), std::abs(high)) || width < 1e-30)) {
      jumped = true;
      break;
    }
    double next = e - miss / state.stiffness_N_per_m;
    const bool stalls = iteration % 4 == 3 && width > width_before / 16;
    if (iteration % 4 == 3) width_before = width;
    if (!std::isfinite(width)) {
      if (!(std::abs(next - e) <= reach)) next = miss < 0 ? e + reach : e - reach;
      reach *= 2;
    } else if (stalls || !(next > low && next < high)) {
      next = low + width / 2;
    }
    if (next == e || next == low || next == high) break;
    e = next;
    state = ring.at(e);
  }

  // 3. A law that lets go at a finite force: the rollers that sit on its vertical part share what is missing.
  if (jumped && (jumps(laws.inner) || jumps(laws.outer)) && best_miss > largest_balance_error * load) {
    const double share = (load - low_state.sum_N) / (high_state.sum_N - low_state.sum_N);
    RingState between;
    for (std::size_t g = 0; g < ring.groups().size(); ++g) {
      RollerState roller = high_state.groups[g];
      const double less = low_state.groups[g].inner.force_N, more = roller.inner.force_N;
      roller.inner.force_N = less + share * (more - less);
      roller.outer.force_N = roller.inner.force_N + loading.centrifugal_N;
      roller.at_jump = more - less > 1e-6 * more;
      ring.add(between, ring.groups()[g], roller);
    }
    best = between;
    best_e = high;
    best_miss = std::abs(best.sum_N - load);
  }

  // 4. What is returned balances, or nothing is.
  result.displacement_m = ring.displacement_m(best_e);
  result.azimuths_deg = ring.azimuths();
  result.rollers.resize(result.azimuths_deg.size());
  result.groups = static_cast<int>(ring.groups().size());
  result.rollers_balanced = ring.balanced();
  double worst_N = best_miss;
  for (std::size_t g = 0; g < ring.groups().size(); ++g) {
    const RollerGroup& group = ring.groups()[g];
    worst_N = std::max(
        worst_N, roller_error_N(laws, best.groups[g], loading.centrifugal_N, ring.total_approach_m(group, best_e)));
    for (const int member : group.members) result.rollers[static_cast<std::size_t>(member)] = best.groups[g];
  }
  for (std::size_t j = 0; j < result.rollers.size(); ++j)
    result.lateral_force_N +=
        result.rollers[j].inner.force_N * std::sin(result.azimuths_deg[j] * std::numbers::pi / 180);
  const double scale = std::max(load, best.total_N);
  result.balance_error = scale > 0 ? worst_N / scale : 0;
  if (!(result.balance_error <= largest_balance_error))
    return NoEquilibrium{text("the forces balance only to %g of the larger of load and roller forces, %g N",
                              result.balance_error, scale)};
  return result;
}

}  // namespace ehd::bearing
