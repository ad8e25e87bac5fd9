// SPDX-License-Identifier: GPL-3.0-or-later
// From a state that Newton's method finds at once to the physics: the fluidity 1/eta gets a floor delta, which is
// lowered from 1e-2 to 0 while the mesh follows the solution at every step. README.md, section 4.
#pragma once

#include <optional>
#include <vector>

#include "reference/hp/newton.hpp"

namespace ehd::reference::hp {

/// What a mesh must resolve.
struct Resolution {
  double film = 1e-3;   ///< relative error that one element may cause in the film
  double spike = 3e-3;  ///< last Legendre coefficients of the pressure, in p_H, wherever they are
  double defect = 0.05;  ///< of the flux between collocation points, relative
};

/// A solved state with the mesh that resolves it.
struct Resolved {
  std::shared_ptr<const Collocation<double>> equations;
  NewtonRun run;
  double floor = 0;
  double excess = 0;  ///< largest, in units of what is allowed: <= 1 where the mesh resolves it
};

struct HomotopyLimits {
  int largest_intervals = 3000;
  double shortest_element = 4e-15;
};

/// How far each element is from what is allowed: > 1 is to be split.
[[nodiscard]] std::vector<double> excess_of(const Collocation<double>& equations, const NewtonRun& run,
                                            const Problem& problem, const Resolution& resolution);

/// Solves at `floor` from `from` (its mesh, its state), adapting the mesh until it resolves; empty where Newton's method
/// or the adaption gives up.
[[nodiscard]] std::optional<Resolved> resolved_at(const Problem& problem, const Resolved& from, double floor,
                                                  const Resolution& resolution, const NewtonLimits& newton_limits,
                                                  const HomotopyLimits& limits, Meter& meter);

}  // namespace ehd::reference::hp
