// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/chebyshev.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ehd {

namespace {

/// T_j(points_i).
MatrixOf<double> basis_at(const std::vector<double>& points) {
  const auto count = static_cast<Eigen::Index>(points.size());
  MatrixOf<double> basis(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const ChebyshevBasis at(static_cast<int>(count) - 1, points[static_cast<std::size_t>(i)]);
    for (Eigen::Index j = 0; j < count; ++j) basis(i, j) = at.value[j];
  }
  return basis;
}

}  // namespace

std::vector<double> leja_points(std::size_t count) {
  // Candidates crowd at the ends as Leja points do. Twenty for each point leave the product of distances within a
  // few percent of its maximum.
  const std::size_t cells = 20 * std::max<std::size_t>(count, 2);
  std::vector<double> candidates(cells + 1), log_product(cells + 1, 0.0), points;
  for (std::size_t k = 0; k <= cells; ++k)
    candidates[k] = std::sin(std::numbers::pi * (0.5 - static_cast<double>(k) / static_cast<double>(cells)));
  std::size_t next = 0;  // the point 1
  while (points.size() < count) {
    points.push_back(candidates[next]);
    for (std::size_t k = 0; k <= cells; ++k) log_product[k] += std::log(std::abs(candidates[k] - points.back()));
    next = static_cast<std::size_t>(std::max_element(log_product.begin(), log_product.end()) - log_product.begin());
  }
  return points;
}

MatrixOf<double> chebyshev_coefficients(const MatrixOf<double>& values, const std::vector<double>& x,
                                        const std::vector<double>& y) {
  // V_x C V_y^T = F
  const MatrixOf<double> of_columns = basis_at(x).partialPivLu().solve(values);
  return basis_at(y).partialPivLu().solve(of_columns.transpose()).transpose();
}

ChebyshevBasis::ChebyshevBasis(int highest, double t) : degree(highest) {
  value[0] = 1;
  slope[0] = 0;
  if (degree == 0) return;
  value[1] = t;
  slope[1] = 1;
  for (int k = 1; k < degree; ++k) {
    value[k + 1] = 2 * t * value[k] - value[k - 1];
    slope[k + 1] = 2 * value[k] + 2 * t * slope[k] - slope[k - 1];
  }
}

ValueWithSlope chebyshev_sum(const std::vector<double>& coefficients, const ChebyshevBasis& at) {
  ValueWithSlope sum;
  for (std::size_t j = 0; j < coefficients.size(); ++j) {
    sum.value += coefficients[j] * at.value[j];
    sum.slope += coefficients[j] * at.slope[j];
  }
  return sum;
}

ValueWithSlopes chebyshev_sum(const std::vector<double>& coefficients, const ChebyshevBasis& x,
                              const ChebyshevBasis& y) {
  ValueWithSlopes sum;
  const double* c = coefficients.data();
  for (int i = 0; i <= x.degree; ++i) {
    double value = 0, slope = 0;
    for (int j = 0; j <= y.degree; ++j, ++c) {
      value += *c * y.value[j];
      slope += *c * y.slope[j];
    }
    sum.value += x.value[i] * value;
    sum.by_x += x.slope[i] * value;
    sum.by_y += x.value[i] * slope;
  }
  return sum;
}

}  // namespace ehd
