// SPDX-License-Identifier: GPL-3.0-or-later
// Maps for the mapped grid: the first from Moes' film, each next one from the solution before.
#pragma once

#include "contact/array.hpp"
#include "contact/solution.hpp"
#include "fast/run.hpp"

namespace ehd::fast {

/// How a map and its wedge are made.
struct MapRecipe {
  double narrowest;   ///< w_sp >= narrowest d l
  double cells;       ///< w_sp >= this many cells at the spike
  bool robust_wedge;  ///< full upwinding at the spike, k = -1
};

/// What a solution, on any nodes, tells the next map.
struct Known {
  Array X, P;
  double film = 0;  ///< H at the node nearest to X = 0
};
[[nodiscard]] Known known_of(const Fields& fields);
/// What the solution that Newton ended on last tells the next map.
[[nodiscard]] Known known_now(const Run& run);
/// H at the node nearest to X = 0 of that solution.
[[nodiscard]] double film_now(const Run& run);

/// From now on the grids of the run use the map that follows from Moes' film formula.
void use_first_map(Run& run, const MapRecipe& recipe, Tables tables);
/// A solution on n intervals of the present map: pressure by cubic interpolation, H_0 such that the film at X = 0 is
/// kept.
[[nodiscard]] State on_present_map(Run& run, const Known& known, const InletTail& tail, int n);
/// From now on the grids are those of the map that a solution asks for. Returns the solution on n intervals of that
/// map.
[[nodiscard]] State on_new_map(Run& run, const Known& known, const InletTail& tail, const MapRecipe& recipe,
                               Tables tables, int n);

}  // namespace ehd::fast
