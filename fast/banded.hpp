// SPDX-License-Identifier: GPL-3.0-or-later
// LU without pivoting of a real or complex matrix with three lower and two upper diagonals: the smoother's system.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "contact/array.hpp"
#include "fast/scalar.hpp"

namespace ehd::fast {

/// Row i holds columns i-3 .. i+2 in entries 0..5. Entries outside the matrix must be finite; they are ignored.
template <class Scalar>
class BandedOf {
 public:
  static constexpr int lower = 3, upper = 2, width = lower + upper + 1;
  using Row = std::array<Scalar, width>;

  void resize(int rows) { rows_.resize(static_cast<std::size_t>(rows)); }
  [[nodiscard]] int rows() const { return static_cast<int>(rows_.size()); }
  [[nodiscard]] Row& row(int i) { return rows_[static_cast<std::size_t>(i)]; }

  /// Factorises in place, row by row. A row needs the one before, so a processor waits. Two factorisations that take
  /// turns need little more time than one.
  class Factorisation {
   public:
    explicit Factorisation(BandedOf& matrix)
        : row_(matrix.rows_.data()), end_(matrix.rows_.data() + matrix.rows_.size()) {}
    /// The next row. False where there is none, or where its pivot vanishes against the row.
    bool next();
    /// No pivot has vanished so far.
    [[nodiscard]] bool succeeded() const { return succeeded_; }

   private:
    Row* row_;
    const Row* end_;
    Row third_{}, second_{}, last_{};  ///< the rows before row_; before the first one they are 0, which changes nothing
    bool succeeded_ = true;
  };
  /// All rows. False where a pivot vanishes (the caller then skips this level).
  [[nodiscard]] bool factorise();
  /// Solves in place; needs a factorisation of all rows that succeeded.
  void solve(ArrayOf<Scalar>& x) const;

 private:
  /// A pivot below this share of the upper part of its row counts as zero.
  static constexpr double smallest_pivot = 1e-14;

  std::vector<Row> rows_;
};
using Banded = BandedOf<double>;

// A finished row holds its multipliers, the inverse of its pivot, and its upper part divided by the pivot. Rows are
// copied, so that the compiler knows that they do not overlap.
template <class Scalar>
inline bool BandedOf<Scalar>::Factorisation::next() {
  if (row_ == end_ || !succeeded_) return false;
  Row r = *row_;
  const auto subtract = [&r](std::size_t k, const Row& pivot) {
    for (std::size_t m = 1; m <= upper; ++m) r[k + m] -= times(r[k], pivot[lower + m]);
    r[k] = times(r[k], pivot[lower]);
  };
  subtract(0, third_);
  subtract(1, second_);
  subtract(2, last_);
  const double size = size_of(r[lower]) + size_of(r[lower + 1]) + size_of(r[lower + 2]);
  succeeded_ = size_of(r[lower]) > smallest_pivot * size;
  r[lower] = inverse_of(r[lower]);
  for (std::size_t m = 1; m <= upper; ++m) r[lower + m] = times(r[lower + m], r[lower]);
  third_ = second_;
  second_ = last_;
  last_ = *row_ = r;
  ++row_;
  return succeeded_;
}

}  // namespace ehd::fast
