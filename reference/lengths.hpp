// SPDX-License-Identifier: GPL-3.0-or-later
// The lengths of a contact that follow from its central film H (Hertz units), and first guesses by them. Starts and
// grids use them; no result does.
#pragma once

#include "contact/array.hpp"

namespace ehd::reference {

/// l = max(1, sqrt(2 H)): the length that counts, Hertz' half-width or the film's own at light loads.
[[nodiscard]] double contact_length(double central_film);
/// Width of the inlet zone in units of l: min(H, 1)^(2/3).
[[nodiscard]] double inlet_zone(double central_film);

/// X_a of a flooded grid in units of l; the truncation that is left is below 1e-6 of the film (README.md, section 5).
inline constexpr double farthest_inlet = -4000;

/// Cells of a grid in the inlet zone of a film: the zone begins at X = -l and is l min(H_cen, 1)^(2/3) wide.
[[nodiscard]] double inlet_cells(const Array& nodes, double central_film);
/// Fewer cells than this in the inlet zone cannot see it.
inline constexpr double fewest_inlet_cells = 1.5;

/// Starts from scratch: central films over the expected one.
inline constexpr double start_films[] = {1.0, 2.0, 0.5, 4.0};
/// First guess of X* - 1 over the width of the inlet zone; of X* over sqrt(2 H) at light loads.
inline constexpr double exit_per_inlet_zone = 0.45, exit_per_film_length = 0.5;

}  // namespace ehd::reference
