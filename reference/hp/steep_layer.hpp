// SPDX-License-Identifier: GPL-3.0-or-later
// The layer where the pressure falls steepest, and how it moves when the floor of the fluidity falls.
//
// Behind the core, the film opens at some X_0: rho H - C grows like X - X_0. So Reynolds' equation of Barus oil,
//   e^(-alpha P) P' = lambda (rho H - C)/(rho H^3),
// makes the fluidity e^(-alpha P) grow like (X - X_0)^2. A floor delta cuts this off where the fluidity reaches delta:
//   X - X_0 = k delta^q,  q = 1/2.
// Other laws of viscosity have other powers. So q, k and X_0 are fitted to three floors.
#pragma once

#include <optional>
#include <vector>

#include "reference/hp/homotopy.hpp"

namespace ehd::reference::hp {

/// Where the pressure falls steepest, at one floor of the fluidity.
struct SteepPlace {
  double floor = 0, X = 0;
};

/// The mean of X with the weight max(0, -P')^4.
[[nodiscard]] SteepPlace steep_place(const Resolved& solved);
/// At the floors that are apart (floors_apart()), at most three, falling.
[[nodiscard]] std::vector<SteepPlace> places_apart(const std::vector<Resolved>& floors);

/// X = end + reach (delta/delta_c)^power, with delta_c the lowest floor that is known.
struct LayerPath {
  double end = 0, reach = 0, power = 0;
};

/// The path through the last three places, floors falling; through two places with the power 1/2. Empty with fewer
/// places, where the layer stands still, and where no power between 0.3 and 2 fits: there is no single layer then.
[[nodiscard]] std::optional<LayerPath> path_of(const std::vector<SteepPlace>& places);

/// path_of(); where no power fits, the layer goes on once more as in the larger of its last two steps. Empty with fewer
/// than two places.
[[nodiscard]] std::optional<LayerPath> expected_path(const std::vector<SteepPlace>& places);
/// At this floor the layer is so near to X = 0 that the central film is not linear in the floor.
[[nodiscard]] bool is_at_centre(const LayerPath& path, const SteepPlace& place);
/// The same at the last of `places`; false with fewer than two.
[[nodiscard]] bool is_at_centre(const std::vector<SteepPlace>& places);
/// There, the distance in X within which the film changes by more than the central film errs at the last floor.
[[nodiscard]] double unsettled_distance(const LayerPath& path);

/// The mesh of `last`, moved as the path says for the lower floor `floor` > 0, with the same pressure at each node.
/// Breakpoints near the end of the path come nearer to it by the factor (floor/last.floor)^power; far away they stay.
/// Empty where an element would become shorter than `shortest`, in xi.
[[nodiscard]] std::optional<Resolved> followed(const Problem& problem, const Resolved& last, const LayerPath& path,
                                               double floor, double shortest);

}  // namespace ehd::reference::hp
