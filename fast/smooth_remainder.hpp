// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the logarithmic kernel on mapped nodes that is not Toeplitz:
//   ln|phi_i - phi_j| = ln|s_i - s_j| + Lambda_ij,  Lambda_ij = ln((phi_i - phi_j)/(s_i - s_j)), Lambda_ii = ln phi'_i,
// Lambda is smooth in both indices. So it is kept as a small symmetric table at equal steps of s. A product uses
// p-point Lagrange interpolation out of the table and its transpose into it.
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

/// Lagrange interpolation from a table of so many cells to n + 1 nodes: the same for every map.
struct RemainderRule {
  static constexpr int points = 8;
  using Weights = Eigen::Array<double, points, 1>;

  int n = 0, cells = 0;
  std::vector<int> base, pattern;  ///< of each node: first table node, and which weights
  std::vector<Weights, Eigen::aligned_allocator<Weights>> weights;

  static RemainderRule of(int n, int cells);
  [[nodiscard]] const Weights& at(int i) const {
    return weights[static_cast<std::size_t>(pattern[static_cast<std::size_t>(i)])];
  }
  [[nodiscard]] int first(int i) const { return base[static_cast<std::size_t>(i)]; }
};

/// The product with Lambda on n + 1 nodes. Where n equals the table's cells, the table is used as it is. Where n is a
/// multiple of them, many nodes share their interpolation weights, else each node has its own.
class SmoothRemainder {
 public:
  static constexpr int points = RemainderRule::points;

  /// The table itself, on as many nodes.
  explicit SmoothRemainder(std::shared_ptr<const RemainderTable> table);
  /// On the nodes of the rule, which has as many cells as the table.
  SmoothRemainder(std::shared_ptr<const RemainderTable> table, std::shared_ptr<const RemainderRule> rule);

  /// y_i += Sum_j Lambda_ij x_j, sizes n + 1.
  void add(const Array& x, Array& y) const;
  /// Lambda_ij as the product uses it.
  [[nodiscard]] double entry(int i, int j) const;
  /// Adds Lambda_i0, …, Lambda_in.
  void add_row(int i, double* row) const;

 private:
  int n_ = 0;
  std::shared_ptr<const RemainderTable> table_;
  std::shared_ptr<const RemainderRule> rule_;  ///< none: the nodes are those of the table
  mutable Eigen::VectorXd in_, out_;
};

}  // namespace ehd::fast
