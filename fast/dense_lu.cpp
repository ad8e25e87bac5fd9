// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/dense_lu.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ehd::fast {

template <class Scalar>
void DenseLuOf<Scalar>::resize(int size) {
  if (size == size_) return;
  size_ = size;
  stride_ = (size + block - 1) / block * block;
  rows_.setZero(static_cast<Eigen::Index>(size + together) * stride_);
  lower_.resize(static_cast<Eigen::Index>(size + together) * stride_);
  inverse_pivot_.resize(size);
  padded_.setZero(stride_);
  exchanged_.resize(static_cast<std::size_t>(size));
}

template <class Scalar>
int DenseLuOf<Scalar>::largest_below(int k) {
  int largest = k;
  const Scalar* entry = row(k) + k;
  double size = size_of(*entry);
  for (int i = k + 1; i < size_; ++i) {
    entry += stride_;
    const double other = size_of(*entry);
    if (other > size) {
      size = other;
      largest = i;
    }
  }
  return largest;
}

/// Subtracts multiples of row k from the rows below, a few rows at once. The first block may hold columns up to k:
/// nobody reads them again.
template <class Scalar>
void DenseLuOf<Scalar>::eliminate(int k) {
  const Scalar* const pivot_row = row(k);
  Scalar* const factors = multipliers(k);
  const Scalar minus_inverse = -inverse_pivot_[k];
  const int first = (k + 1) / block * block, stride = stride_;
  for (int i = k + 1; i < size_; i += together) {
    Scalar* rows[together];
    Scalar factor[together];
    for (int r = 0; r < together; ++r) {
      rows[r] = row(i + r);
      factors[i + r] = factor[r] = times(rows[r][k], minus_inverse);
    }
    for (int j = first; j < stride; j += block) {
      const Block pivot = BlockOf(pivot_row + j);
      for (int r = 0; r < together; ++r) BlockAt(rows[r] + j) += factor[r] * pivot;
    }
  }
}

template <class Scalar>
bool DenseLuOf<Scalar>::factorise() {
  for (int i = 0; i < size_; ++i) std::fill(row(i) + size_, row(i) + stride_, Scalar(0));
  for (int k = 0; k < size_; ++k) {
    const int other = largest_below(k);
    exchanged_[static_cast<std::size_t>(k)] = other;
    if (other != k) std::swap_ranges(row(k) + k, row(k) + size_, row(other) + k);
    Scalar* const pivot_row = row(k);
    // A number that is not finite reaches a pivot: every later row takes it over, as it is or as NaN.
    const double size = size_of(pivot_row[k]);
    if (!(size > 0) || !std::isfinite(size)) return false;
    inverse_pivot_[k] = inverse_of(pivot_row[k]);
    eliminate(k);
    std::fill(pivot_row + static_cast<std::ptrdiff_t>((k + 1) / block) * block, pivot_row + k + 1,
              Scalar(0));  // solve() goes over whole blocks
  }
  return true;
}

template <class Scalar>
void DenseLuOf<Scalar>::solve(ArrayOf<Scalar>& x) {
  Scalar* const y = padded_.data();
  std::copy_n(x.data(), size_, y);
  for (int k = 0; k < size_; ++k) {
    std::swap(y[k], y[exchanged_[static_cast<std::size_t>(k)]]);
    const Scalar* const factors = multipliers(k);
    for (int i = k + 1; i < size_; ++i) y[i] += times(factors[i], y[k]);
  }
  for (int k = size_ - 1; k >= 0; --k) {
    const Scalar* const pivot_row = row(k);
    Block sum = Block::Zero();
    for (int j = (k + 1) / block * block; j < stride_; j += block) sum += BlockOf(pivot_row + j) * BlockOf(y + j);
    y[k] = times(y[k] - sum.sum(), inverse_pivot_[k]);
  }
  std::copy_n(y, size_, x.data());
}

template class DenseLuOf<double>;
template class DenseLuOf<Complex>;

}  // namespace ehd::fast
