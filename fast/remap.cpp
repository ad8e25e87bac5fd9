// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/remap.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "fast/steep_fall.hpp"

namespace ehd::fast {

namespace {

/// Guesses for the first map, in widths of the inlet zone: the exit beyond X = 1, the spike before it, the spike's
/// width.
constexpr double expected_exit = 0.45, expected_spike = 0.45, expected_spike_width = 0.5;
/// Films thicker than this (Hertz units) hardly deform the contact: the exit is then this part of sqrt(2 H_cen).
constexpr double rigid_film = 0.5, rigid_exit = 0.5;
/// Where a solution shows no falling pressure, the spike is expected so many inlet widths before the exit.
constexpr double spike_before_exit = 0.9;

double relative_inlet_width(double film) { return std::pow(std::min(1.0, film), 2.0 / 3); }

MapShape expected_shape(const Run& run) {
  const Lengths& l = run.lengths;
  const double d = relative_inlet_width(l.film);
  return {.inlet = run.setting.inlet,
          .exit = l.film > rigid_film ? rigid_exit * std::sqrt(2 * l.film) : 1 + expected_exit * d,
          .scale = l.scale,
          .inlet_width = d,
          .spike = 1 - expected_spike * d,
          .spike_width = expected_spike_width * d * l.scale};
}

/// The spike is where the pressure falls most steeply. At light load and large L that is before X = 0.
MapShape shape_for(const Known& known, double inlet, const MapRecipe& recipe) {
  const auto& [X, P, film] = known;
  const Lengths l = lengths_from_film(film);
  const double d = relative_inlet_width(film), width = d * l.scale;
  MapShape shape{.inlet = inlet, .exit = X[X.size() - 1], .scale = l.scale, .inlet_width = d};
  shape.spike = shape.exit - spike_before_exit * width;
  shape.spike_width = expected_spike_width * width;
  double steepest = 0;
  for (Eigen::Index i = X.size() - 2; i >= 0; --i) {
    const double cell = X[i + 1] - X[i], fall = (P[i] - P[i + 1]) / cell;
    if (!(fall > steepest)) continue;
    steepest = fall;
    shape.spike = (X[i] + X[i + 1]) / 2;
    shape.spike_width = std::max(recipe.narrowest * width, recipe.cells * cell);
  }
  return shape;
}

/// P at `at` by the cubic through the four nodes about [X_cell, X_(cell+1)].
double cubic(const Array& X, const Array& P, Eigen::Index cell, double at) {
  const Eigen::Index first = std::clamp<Eigen::Index>(cell - 1, 0, X.size() - 4);
  double value = 0;
  for (Eigen::Index j = first; j < first + 4; ++j) {
    double basis = 1;
    for (Eigen::Index k = first; k < first + 4; ++k) {
      if (k != j) basis *= (at - X[k]) / (X[j] - X[k]);
    }
    value += basis * P[j];
  }
  return value;
}

double film_at_centre(const Array& X, const Array& H) {
  Eigen::Index centre = 0;
  X.abs().minCoeff(&centre);
  return H[centre];
}

}  // namespace

Known known_of(const Fields& fields) {
  return {.X = fields.X, .P = fields.P, .film = film_at_centre(fields.X, fields.H)};
}

Known known_now(const Run& run) {
  return {.X = run.workspace.now().nodes.places(run.setting.inlet), .P = run.state.P, .film = film_now(run)};
}

double film_now(const Run& run) {
  const NodeFields& at = run.workspace.now().nodes;
  return film_at_centre(at.places(run.setting.inlet), at.H);
}

void use_first_map(Run& run, const MapRecipe& recipe, Tables tables) {
  const InStage stage(run.counters, Stage::grids);
  run.workspace.grids.use(std::make_shared<const Map>(expected_shape(run)), recipe.robust_wedge, tables);
}

State on_present_map(Run& run, const Known& known, const InletTail& tail, int n) {
  const auto& [X, P, film] = known;
  const double inlet = run.setting.inlet, exit = X[X.size() - 1];
  Grid& grid = grid_of(run, n);
  State state{.P = Array::Zero(n + 1), .offset = 0, .exit = exit, .tail = tail};
  const auto fall = steep_fall(X, P);
  Eigen::Index cell = 0;
  for (int i = 1; i < n; ++i) {
    const double at = inlet + (exit - inlet) * grid.place[i];
    if (at <= X[0]) continue;  // another solution's inlet may begin later: no pressure yet
    while (cell + 2 < X.size() && X[cell + 1] < at) ++cell;
    state.P[i] = fall && fall->covers(cell)
                     ? fall->mean(at, (exit - inlet) * (grid.place[i + 1] - grid.place[i - 1]) / 2)
                     : std::max(cubic(X, P, cell, at), std::min(P[cell], P[cell + 1]));
  }
  state.offset = offset_for(film, run.setting, state, grid);
  return state;
}

State on_new_map(Run& run, const Known& known, const InletTail& tail, const MapRecipe& recipe, Tables tables, int n) {
  {
    const InStage stage(run.counters, Stage::grids);
    const MapShape shape = shape_for(known, run.setting.inlet, recipe);
    run.workspace.grids.use(std::make_shared<const Map>(shape), recipe.robust_wedge, tables);
  }
  return on_present_map(run, known, tail, n);
}

}  // namespace ehd::fast
