// SPDX-License-Identifier: GPL-3.0-or-later
// LU with row exchanges of a small dense matrix, real or complex: the coarsest grid's system, mostly of 33 unknowns.
// At 33 Eigen's blocked LU takes 2.2 times the instructions, its solution of one right side 3.2 times.
#pragma once

#include <cstddef>
#include <vector>

#include "contact/array.hpp"
#include "fast/scalar.hpp"

namespace ehd::fast {

/// Storage is used again by the next matrix.
template <class Scalar>
class DenseLuOf {
 public:
  /// A square matrix of `size` rows, to be filled in row by row.
  void resize(int size);
  [[nodiscard]] Scalar* row(int i) { return rows_.data() + static_cast<std::ptrdiff_t>(i) * stride_; }

  /// In place. False where the matrix is singular or holds a number that is not finite.
  [[nodiscard]] bool factorise();
  /// x (`size` entries) becomes the solution for the right side x; needs factorise() to have succeeded.
  void solve(ArrayOf<Scalar>& x);

 private:
  /// Rows are padded to whole blocks, and `together` rows of zeros follow the last one: loops have no remainder.
  static constexpr int block = 4, together = 4;
  using Block = Eigen::Array<Scalar, block, 1>;
  using BlockAt = Eigen::Map<Block>;
  using BlockOf = Eigen::Map<const Block>;

  /// -(row i, column k)/pivot k for i > k, in column k of the lower factor.
  [[nodiscard]] Scalar* multipliers(int k) { return lower_.data() + static_cast<std::ptrdiff_t>(k) * stride_; }
  [[nodiscard]] int largest_below(int k);
  void eliminate(int k);

  int size_ = 0, stride_ = 0;
  ArrayOf<Scalar> rows_;           ///< the matrix; after factorise() the upper factor right of the diagonal
  ArrayOf<Scalar> lower_;          ///< the lower factor, column by column
  ArrayOf<Scalar> inverse_pivot_;  ///< 1/diagonal of the upper factor
  ArrayOf<Scalar> padded_;         ///< the solution, padded like a row
  std::vector<int> exchanged_;     ///< row k was exchanged with this one
};
using DenseLu = DenseLuOf<double>;

}  // namespace ehd::fast
