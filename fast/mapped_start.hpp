// SPDX-License-Identifier: GPL-3.0-or-later
// How `fast` begins: ways to make the final map and a first iterate on that map, the usual way and the retries.
#pragma once

#include <optional>

#include "contact/solution.hpp"
#include "fast/extrapolation.hpp"
#include "fast/remap.hpp"
#include "fast/run.hpp"

namespace ehd::fast {

/// Intervals of the first grid on the final map.
constexpr int first_mapped_nodes = 64;

/// A way to begin.
struct Recipe {
  MapRecipe map;
  bool remaps;  ///< further maps are made from solutions; else the first map is the final one
  int first;    ///< intervals of the first solution
  /// Every grid on the way has so many times the usual intervals. A film below the errors of a coarse grid's deflection
  /// is not found on that grid.
  int fineness = 1;
};
/// In the order of trial. The first is right nearly always, the others are retries.
constexpr Recipe recipes[] = {
    {.map = {.narrowest = 0.005, .cells = 0.5, .robust_wedge = false}, .remaps = true, .first = 64},
    {.map = {.narrowest = 0.1, .cells = 1, .robust_wedge = false}, .remaps = true, .first = 64},
    {.map = {.narrowest = 0.1, .cells = 1, .robust_wedge = true}, .remaps = true, .first = 64},
    {.map = {.narrowest = 0.5, .cells = 1, .robust_wedge = false}, .remaps = false, .first = 64},
    {.map = {.narrowest = 0.1, .cells = 1, .robust_wedge = true}, .remaps = true, .first = 128}};

/// The finenesses beyond 1, in the order of trial: first of all where the film is thin (start.hpp), else as a last
/// resort. Measured at 180 contacts (Barus and Roelands, M of 1e4..1e6, L of 0..100): 1 alone solves all up to M = 2e4,
/// 2 most up to 3e5, 4 and 8 the rest.
constexpr int finer_grids[] = {2, 4, 8, 16};

/// How good a map is made: from the first solution alone, from one more, or from three more.
enum class Care { least, little, full };
/// How many maps are made for this tolerance.
[[nodiscard]] Care care_for(const Request& request, const Groups& groups);

/// Of the map that `start` makes.
[[nodiscard]] MapFit map_fit(const Recipe& recipe, Care care);

/// Newton on the grid of run.state; where an interpolated pressure has closed the film, once more with the film at X =
/// 0 restored to `film`; where a sharpening spike stops Newton, with a floor under the fluidity. run.state: the start,
/// then the solution.
[[nodiscard]] Attempt solve_on(Run& run, double film, const Target& target);

/// Makes the final map, and run.state on that map: from nothing, or from the solution `from` of a neighbouring problem
/// (with full care alone). The solution that the map was made from; empty where Newton failed.
[[nodiscard]] std::optional<Known> start(Run& run, const Recipe& recipe, const Solution* from, Care care);

}  // namespace ehd::fast
