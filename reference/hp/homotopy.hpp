// SPDX-License-Identifier: GPL-3.0-or-later
// The fluidity 1/eta gets a floor delta, with which Newton's method converges. The floor is lowered from 1e-2 to 0, and
// the mesh is adapted at every floor. docs/certified-solver.md, section 4.
#pragma once

#include <optional>
#include <vector>

#include "contact/solution.hpp"
#include "reference/hp/element_newton.hpp"

namespace ehd::reference::hp {

/// What a mesh must resolve.
struct Resolution {
  double film = 1e-3;    ///< relative error that one element may cause in the film
  double spike = 3e-3;   ///< last Legendre coefficients of the pressure, in p_H, wherever they are
  double defect = 0.05;  ///< of the flux between collocation points, relative
};

/// A solved state with the mesh that resolves it.
struct Resolved {
  std::shared_ptr<const Collocation<double>> equations;
  NewtonRun run;
  double floor = 0;
  double excess = 0;  ///< largest, over its allowed value: <= 1 where the mesh resolves it
};

struct HomotopyLimits {
  int largest_intervals = 4000;
  double shortest_element = 4e-15;  ///< in xi: below it, coordinates have no digits left
  /// Films that would still move by less than this, relative, are settled: the first failure then ends the descent.
  double settled = 1e-4;
  NewtonLimits newton = {};
};

/// The error of each element over the allowed one: above 1 the element is to be split.
[[nodiscard]] std::vector<double> excess_of(const Collocation<double>& equations, const NewtonRun& run,
                                            const Problem& problem, const Resolution& resolution);

/// Solves at from.floor on the mesh of `from`, starting from its state, and adapts the mesh until it resolves; empty
/// where Newton's method gives up.
[[nodiscard]] std::optional<Resolved> resolved(const Problem& problem, const Resolved& from,
                                               const Resolution& resolution, const HomotopyLimits& limits,
                                               Meter& meter);

/// Lowers the floor to 0 as far as it goes: every floor at which a solution was resolved, the first being `top`. Known
/// solutions at higher floors tell where the steep layer goes; without them the first mesh does not follow it.
[[nodiscard]] std::vector<Resolved> descent(const Problem& problem, const Resolved& top, const Resolution& resolution,
                                            const HomotopyLimits& limits, Meter& meter,
                                            const std::vector<Resolved>& above = {});

/// Floors to extrapolate from are this many times apart. Closer ones would amplify the noise of their meshes.
inline constexpr double floor_ratio = 3;
/// Their indices: the last floor, and upwards each that is far enough from the one before.
[[nodiscard]] std::vector<std::size_t> floors_apart(const std::vector<Resolved>& floors);
/// Relative change of the flux that is left between the last floor and floor 0; the flux is linear in a small floor. 0
/// where the descent reached 0, infinite where no two floors are apart.
[[nodiscard]] double floor_gap(const std::vector<Resolved>& floors);
/// The same of the central film; NaN where the domain does not hold X = 0.
[[nodiscard]] double central_gap(const Problem& problem, const std::vector<Resolved>& floors);

/// Nodal values, as observe() reads them, with what a flooded contact has before its inlet.
[[nodiscard]] Fields fields_of(const Problem& problem, const Resolved& resolved);

/// The state on another mesh (and with other collocation points), not yet solved there.
[[nodiscard]] Resolved moved_to(const Problem& problem, const Resolved& from, Mesh mesh, Points points);

}  // namespace ehd::reference::hp
