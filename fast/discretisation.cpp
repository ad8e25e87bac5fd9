// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/discretisation.hpp"

#include <numbers>

namespace ehd::fast {

using std::numbers::pi;

bool Discretisation::evaluate(const Setting& setting, State& state, Grid& on, Counters& counters) {
  {
    const InStage stage(counters, Stage::product);
    on.product(state.P, nodes.product, nodes.product_integral);
  }
  counters.count_product(on.n);
  return evaluate_with_product(setting, state, on, counters);
}

bool Discretisation::evaluate_with_product(const Setting& setting, State& state, Grid& on, Counters& counters) {
  const InStage stage(counters, Stage::residual);
  if (!nodes.evaluate_film(setting, state, on)) return false;
  counters.clock.change_to(Stage::laws);
  nodes.evaluate_laws(setting, state.P, counters);
  counters.clock.change_to(Stage::residual);
  faces.evaluate(setting, nodes, state.P);

  oil = (nodes.density.value * nodes.H).head(on.n).max(nodes.exit_flux());
  error.load = nodes.length * nodes.integral + state.tail.load - pi / 2;
  error.flux = faces.flux - nodes.exit_flux();
  if (setting.sources) {
    const auto& balance = setting.sources->balance;
    const double at_exit = balance(state.exit).first;
    const Array& place = on.place;
    for (int i = 0; i < on.n; ++i)
      error.flux[i] += balance(setting.inlet + nodes.length * (place[i] + place[i + 1]) / 2).first - at_exit;
    error.load -= pi / 2 * setting.sources->load;
  }
  if (!error.flux.allFinite()) return false;
  rounding = faces.rounding(nodes, state.P, oil);
  return true;
}

InletTail Discretisation::tail_of(const Setting& setting, const State& state) const {
  if (!setting.with_tail) return {};
  const double far = -setting.inlet;
  const double moment = nodes.length / nodes.n * (state.P * nodes.grid->slope * nodes.places(setting.inlet)).sum();
  return inlet_tail(far, nodes.H[0] - far * far / 2, moment, nodes.exit_flux(), setting.groups.lambda,
                    ambient_slope(setting.viscosity));
}

}  // namespace ehd::fast
