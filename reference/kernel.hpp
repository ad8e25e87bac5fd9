// SPDX-License-Identifier: GPL-3.0-or-later
// The log kernel on piecewise-linear functions, integrated exactly, on any monotone grid.
#pragma once

#include <Eigen/Core>

#include "contact/array.hpp"

namespace ehd::reference {

/// Int_-1^1 ln|v - t| dt and Int_-1^1 t ln|v - t| dt. Absolute error below 1e-14 (1 + ln|v|) for every finite v:
/// closed forms near the element, series in 1/v beyond |v| = 5, where the closed forms cancel.
struct LogMoments {
  double zeroth = 0;
  double first = 0;
};
[[nodiscard]] LogMoments log_moments(double v);

/// K_ij = Int hat_j(s) ln|s_i - s| ds for the hat functions of the strictly decreasing nodes s (n+1 x n+1).
[[nodiscard]] Eigen::MatrixXd log_kernel(const Array& nodes);

/// Int hat_j(s) ds: the trapezoid weights of the strictly decreasing nodes.
[[nodiscard]] Array hat_integrals(const Array& nodes);

}  // namespace ehd::reference
