// SPDX-License-Identifier: GPL-3.0-or-later
// The steep fall of the pressure behind a narrow spike, on its way to other nodes.
//
// Where the spike is narrow, the pressure falls within a cell or two, and the flux varies as exp(-alpha P). A cubic
// through the fall swings: behind it the pressure comes out too low, and Newton's method raises it by 1/alpha a step.
// The cubic also spreads the fall over more cells than the solution has, and Newton's method steepens it by a cell in
// some four steps. At L = 30 that took up to 28 steps on every grid. So the fall becomes a jump with the same integral:
// a node at the jump takes the mean over its own cell. And no new node is below both of its old neighbours.
// At 100 contacts (M of 0.05..5000, L of 15..30, both laws, flooded and cut) the products to 1e-4 and 1e-5 take .57 and
// .73 of the points that they took with cubics.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "contact/array.hpp"

namespace ehd::fast {

/// The node from which the pressure P at the places X falls to its steepest fall.
[[nodiscard]] Eigen::Index peak_before_fall(const Array& X, const Array& P);

struct SteepFall {
  Eigen::Index top = 0, bottom = 0;  ///< its first and last node
  double P_top = 0, P_bottom = 0;    ///< the pressure there
  double jump = 0;                   ///< X of the jump
  /// It covers the cell from this node to the next.
  [[nodiscard]] bool covers(Eigen::Index cell) const { return cell >= top && cell < bottom; }
  /// The mean of the pressure with the jump, over `width` about X.
  [[nodiscard]] double mean(double X, double width) const;
};

/// The fall of P at the places X. Empty where it takes more than a few cells.
[[nodiscard]] std::optional<SteepFall> steep_fall(const Array& X, const Array& P);

}  // namespace ehd::fast
