// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/uniform_start.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ehd::fast {

namespace {

/// The mild contact that the way begins at: M within these bounds, L at most this.
constexpr double lightest_M = 2, heaviest_M = 20, largest_L = 5;
/// A step grows by this factor after a success and is halved after a failure, down to the smallest.
constexpr double growth = 1.5, smallest_step = 1.0 / 64;
/// Newton's target on the way.
constexpr double residual_on_the_way = 1e-4;

/// The way from the mild contact, t = 0, to the given one, t = 1: M geometrically, L linearly.
Setting between(const Setting& target, double t) {
  const Groups& groups = target.groups;
  const double M0 = std::clamp(groups.M, lightest_M, heaviest_M), L0 = std::min(groups.L, largest_L);
  Setting setting = target;
  move_to(setting, {.M = std::pow(M0, 1 - t) * std::pow(groups.M, t), .L = (1 - t) * L0 + t * groups.L});
  return setting;
}

State mild_start(Run& run, int n) {
  const Lengths mild = expected_lengths(run.setting.groups);
  return first_iterate(run.setting, likely_shape(mild.film), mild.film, run.workspace.grids.of(n));
}

}  // namespace

Attempt continuation(Run& run, int n, const Target& target) {
  const Setting setting = run.setting;
  double reached = -1, step = 1;
  State state;
  Attempt attempt;
  while (reached < 1 && step > smallest_step && !run.limit_reached) {
    const double t = reached < 0 ? 0 : std::min(1.0, reached + step);
    run.setting = t < 1 ? between(setting, t) : setting;
    State trial = reached < 0 ? mild_start(run, n) : state;
    attempt = newton_on(run, trial, t < 1 ? Target{.residual = residual_on_the_way} : target);
    if (attempt.succeeded) {
      state = std::move(trial);
      reached = t;
      step *= growth;
    } else {
      if (reached < 0) break;
      step /= 2;
    }
  }
  run.setting = setting;
  attempt.succeeded = reached >= 1;
  if (attempt.succeeded) run.state = std::move(state);
  return attempt;
}

}  // namespace ehd::fast
