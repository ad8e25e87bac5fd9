// SPDX-License-Identifier: GPL-3.0-or-later
// First iterates, and the lengths that a grid must see.
#pragma once

#include "contact/nondimensional.hpp"
#include "fast/grid.hpp"
#include "fast/state.hpp"

namespace ehd::fast {

/// Lengths that follow from a film height, in Hertz half-widths.
struct Lengths {
  double film = 0;   ///< H_cen, expected
  double scale = 1;  ///< l = max(1, sqrt(2 H_cen)): where the pressure lives
  double inlet = 1;  ///< width of the inlet zone, min(1, H_cen)^(2/3) l
};
[[nodiscard]] Lengths lengths_from_film(double film);
/// The expected film at X = 0 (Hertz units) below which the first iterate and the first grids are those of a thin film:
/// the deflection's error on a coarse grid, some 5e-5 on 64 intervals, is many times such a film.
constexpr double thin_film = 5e-6;
/// The same lubricant in another contact. Laws are written for pressures in units of p_H, which changes with the
/// groups.
template <class Contact>  // Problem or Setting
void move_to(Contact& contact, const MoesGroups& moes) {
  const double alpha_p_H = contact.groups.alpha_p_H;
  contact.groups = groups_from(moes);
  if (!(alpha_p_H > 0)) return;
  const double unit = contact.groups.alpha_p_H / alpha_p_H;
  contact.viscosity = in_units_of(contact.viscosity, unit);
  contact.density = in_units_of(contact.density, unit);
}

/// By Moes' film formula.
[[nodiscard]] Lengths expected_lengths(const Groups& groups);

enum class Shape { hertz, martin };
/// The likelier of the two for a film: Martin's where the film is thicker than half b^2/R.
[[nodiscard]] inline Shape likely_shape(double film) { return film > 0.5 ? Shape::martin : Shape::hertz; }
/// X* of the first iterate.
[[nodiscard]] double first_exit(Shape shape, double film);

/// Hertz's pressure, or the pressure of a rigid cylinder (Martin) of film `film`, its size scaled to the load: P on
/// the grid's nodes, X*, and H_0 such that the film at X = 0 is `film`.
[[nodiscard]] State first_iterate(const Setting& setting, Shape shape, double film, Grid& grid);

/// The tail that goes with a film at X = 0.
[[nodiscard]] InletTail first_tail(const Setting& setting, double film);

/// H_0 with which the pressure of `state` (without a tail) leaves the film `film` at X = 0, and at least 0.3 of it
/// everywhere.
[[nodiscard]] double offset_for(double film, const Setting& setting, const State& state, Grid& grid);

}  // namespace ehd::fast
