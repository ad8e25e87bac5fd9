// SPDX-License-Identifier: GPL-3.0-or-later
// The quadrature of integrals over the far inlet, in t = x_a/x of (0, 1).
#pragma once

#include <Eigen/Core>

namespace ehd::fast {

/// Gauss-Legendre points and weights on (0, 1), and the matrix of integrals from 0 to each point of the Lagrange
/// polynomials through the points.
struct TailRule {
  /// 8 and 16 points give the same film to 1e-9 of H_cen.
  static constexpr int points = 12;
  Eigen::Matrix<double, points, 1> t, w;
  Eigen::Matrix<double, points, points> up_to;
};

/// Made once.
[[nodiscard]] const TailRule& tail_rule();

}  // namespace ehd::fast
