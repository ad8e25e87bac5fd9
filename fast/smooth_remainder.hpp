// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the logarithmic kernel on mapped nodes that is not Toeplitz:
//   ln|phi_i - phi_j| = ln|s_i - s_j| + Lambda_ij,  Lambda_ij = ln((phi_i - phi_j)/(s_i - s_j)), Lambda_ii = ln phi'_i,
// which is smooth in both indices: a small symmetric table at equal steps of s, p-point Lagrange interpolation out of
// it and its transpose into it.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "contact/array.hpp"

namespace ehd::fast {

/// The table for one map: Lambda at the (cells + 1)^2 pairs of nodes i/cells.
struct RemainderTable {
  int cells = 0;
  Eigen::MatrixXd values;

  /// `place`: phi at i/cells; `slope`: phi' there.
  static RemainderTable of(const Array& place, const Array& slope);
};

/// The product with Lambda on n + 1 nodes. Direct where n equals the table's cells, else n must be a multiple of them
/// or any other number (then interpolation weights are kept node by node).
class SmoothRemainder {
 public:
  static constexpr int points = 8;  ///< of the interpolation

  SmoothRemainder() = default;
  SmoothRemainder(int n, std::shared_ptr<const RemainderTable> table);

  /// y_i += Sum_j Lambda_ij x_j, sizes n + 1.
  void add(const Array& x, Array& y) const;
  /// Lambda_ij as the product uses it.
  [[nodiscard]] double entry(int i, int j) const;
  /// Adds Lambda_i0, …, Lambda_in.
  void add_row(int i, double* row) const;

 private:
  using Weights = Eigen::Array<double, points, 1>;
  [[nodiscard]] const Weights& weights(int i) const {
    return weights_[static_cast<std::size_t>(pattern_[static_cast<std::size_t>(i)])];
  }

  int n_ = 0;
  bool direct_ = true;
  std::shared_ptr<const RemainderTable> table_;
  std::vector<int> base_, pattern_;  ///< of each node: first table node, and which weights
  std::vector<Weights, Eigen::aligned_allocator<Weights>> weights_;
  mutable Eigen::VectorXd in_, out_;
};

}  // namespace ehd::fast
