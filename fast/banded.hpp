// SPDX-License-Identifier: GPL-3.0-or-later
// LU without pivoting of a real or complex matrix with three lower and two upper diagonals: the smoother's system.
#pragma once

#include <array>
#include <vector>

#include "contact/array.hpp"
#include "fast/scalar.hpp"

namespace ehd::fast {

/// Row i holds columns i-3 .. i+2 in entries 0..5. Entries outside the matrix are ignored.
template <class Scalar>
class BandedOf {
 public:
  static constexpr int lower = 3, upper = 2, width = lower + upper + 1;
  using Row = std::array<Scalar, width>;

  void resize(int rows) { rows_.resize(static_cast<std::size_t>(rows)); }
  [[nodiscard]] int rows() const { return static_cast<int>(rows_.size()); }
  [[nodiscard]] Row& row(int i) { return rows_[static_cast<std::size_t>(i)]; }

  /// In place. False where a pivot vanishes against its row (the caller then skips this level).
  [[nodiscard]] bool factorise();
  /// Solves in place; needs factorise() to have succeeded.
  void solve(ArrayOf<Scalar>& x) const;

 private:
  std::vector<Row> rows_;
};
using Banded = BandedOf<double>;

}  // namespace ehd::fast
