// SPDX-License-Identifier: GPL-3.0-or-later
// A balance looked at by other means than those that found it.
#pragma once

#include "bearing/equilibrium.hpp"

namespace ehd::verification {

/// Every roller's forces once more, by plain bisection of its own scalar equation at the position that is returned, and
/// the sums over the ring from them. Of bearing/ it uses the laws alone (approach, rise, begins_at), which have tests
/// of their own; where the ring stands is worked out in 34 digits. Returns the largest of: a roller's force less the
/// returned one, what the forces miss of the load along it (and across it in the plane form), both relative to the
/// larger of F_r and the sum of the outer contacts' forces; and the relative difference between the displacement and
/// the position. NaN where the equilibrium does not belong to the geometry (number or azimuths of the rollers).
[[nodiscard]] double worst_bisection_error(const bearing::Geometry& geometry, const bearing::LawPair& laws,
                                           const bearing::Loading& loading, bearing::Form form,
                                           const bearing::Equilibrium& equilibrium);

}  // namespace ehd::verification
