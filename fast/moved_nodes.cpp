// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/moved_nodes.hpp"

#include <limits>

#include "fast/discretisation.hpp"

namespace ehd::fast {

namespace {

/// As a_i of squeeze.hpp: Sum_(j > i) dw_j (rho H)_j + (rho H)_f dX_f, where the exit stays.
void add_squeeze(const NodeFields& nodes, const Array& slope, MovedNodes& moved) {
  const int n = nodes.n;
  const Array mass = nodes.density.value * nodes.H;
  Array content = nodes.length / n * slope * mass;
  content[0] /= 2;
  content[n] /= 2;
  moved.squeeze.resize(n);
  double sum = 0;
  for (int i = n - 1; i >= 0; --i) {
    sum += content[i + 1];
    moved.squeeze[i] = sum + nodes.length * (moved.place[i] + moved.place[i + 1]) / 2 * (mass[i] + mass[i + 1]) / 2;
  }
  moved.inflow = sum + content[0];
}

MovedNodes not_known(int n) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Array nodes = Array::Constant(n + 1, nan), faces = Array::Constant(n, nan);
  return {.error = {.flux = faces, .load = nan}, .place = nodes, .film = nodes, .squeeze = faces};
}

}  // namespace

MovedNodes moved_nodes(const Setting& setting, const State& state, Grid& own, Grid& forward, Grid& back, double step,
                       Counters& counters) {
  Discretisation at[3];  // here, forward, back
  Grid* const grids[] = {&own, &forward, &back};
  for (int k = 0; k < 3; ++k) {
    State copy = state;
    if (!at[k].evaluate(setting, copy, *grids[k], counters)) return not_known(own.n);
  }
  const auto& [here, ahead, behind] = at;
  const auto slope_of = [step](const auto& more, const auto& less) { return (more - less) / (2 * step); };
  const Array slope = slope_of(forward.slope, back.slope);
  const double length = here.nodes.length;
  MovedNodes found;
  found.error.flux = slope_of(ahead.error.flux, behind.error.flux);
  found.error.load = slope_of(ahead.error.load, behind.error.load);
  found.place = slope_of(forward.place, back.place);
  found.film = slope_of(ahead.nodes.H, behind.nodes.H);
  found.moment =
      length / own.n * (state.P * (slope * here.nodes.places(setting.inlet) + own.slope * length * found.place)).sum();
  add_squeeze(here.nodes, slope, found);
  return found;
}

}  // namespace ehd::fast
