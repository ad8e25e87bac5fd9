// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials in Chebyshev form, f(x, y) = sum of c_ij T_i(x) T_j(y) on the square -1 <= x, y <= 1, and the points at
// which they are made.
#pragma once

#include <cstddef>
#include <vector>

#include "contact/legendre.hpp"

namespace ehd {

/// Leja points: 1, -1, 0, and then the point of [-1, 1] whose product of distances to all points before it is largest.
/// Interpolation there is nearly as good as at Chebyshev's nodes, and a sequence that grows keeps all its points.
/// Source: L. Reichel, BIT 30 (1990) 332.
[[nodiscard]] std::vector<double> leja_points(std::size_t count);

/// c_ij of the polynomial through values(i, j) at (x_i, y_j). As many points as values; distinct points.
[[nodiscard]] MatrixOf<double> chebyshev_coefficients(const MatrixOf<double>& values, const std::vector<double>& x,
                                                      const std::vector<double>& y);

/// A value with its two derivatives.
struct ValueWithSlopes {
  double value = 0;
  double by_x = 0;
  double by_y = 0;
};

/// T_0 … T_degree at t with their derivatives.
class ChebyshevBasis {
 public:
  static constexpr int highest_degree = 63;
  /// 0 <= degree <= highest_degree.
  ChebyshevBasis(int degree, double t);

  int degree;
  double value[highest_degree + 1] = {};
  double slope[highest_degree + 1] = {};
};

struct ValueWithSlope {
  double value = 0;
  double slope = 0;
};
/// The sum over T_j; at least one coefficient, at most as many as the basis has.
[[nodiscard]] ValueWithSlope chebyshev_sum(const std::vector<double>& coefficients, const ChebyshevBasis& at);

/// The sum over T_i(x) T_j(y); `coefficients`: c_ij row by row, i over the degrees of x.
[[nodiscard]] ValueWithSlopes chebyshev_sum(const std::vector<double>& coefficients, const ChebyshevBasis& x,
                                            const ChebyshevBasis& y);

}  // namespace ehd
