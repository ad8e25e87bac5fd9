// SPDX-License-Identifier: GPL-3.0-or-later
// An independent check of a bearing balance, by bisection.
#pragma once

#include "bearing/equilibrium.hpp"

namespace ehd::verification {

/// Computes every roller's forces again, by bisection of its own scalar equation at the returned position of the ring,
/// and adds them up over the ring. Of bearing/ only the laws are used (approach, rise, begins_at), which have tests of
/// their own; the position of the ring is computed with 34 digits. Returns the largest of
/// - the difference of a roller's force from the returned one, and of the sum of the forces from the load along it (in
///   the plane form across it too), relative to the larger of F_r and the sum of the outer contacts' forces;
/// - the relative difference between the displacement and the position.
/// NaN where the equilibrium does not belong to the geometry (number or azimuths of the rollers).
[[nodiscard]] double worst_bisection_error(const bearing::Geometry& geometry, const bearing::LawPair& laws,
                                           const bearing::Loading& loading, bearing::Form form,
                                           const bearing::Equilibrium& equilibrium);

}  // namespace ehd::verification
