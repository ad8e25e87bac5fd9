// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/dense_lu.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ehd::fast {

void DenseLu::resize(int size) {
  if (size == size_) return;
  size_ = size;
  stride_ = (size + block - 1) / block * block;
  rows_.setZero(static_cast<Eigen::Index>(size + together) * stride_);
  lower_.resize(static_cast<Eigen::Index>(size + together) * stride_);
  inverse_pivot_.resize(size);
  padded_.setZero(stride_);
  exchanged_.resize(static_cast<std::size_t>(size));
}

int DenseLu::largest_below(int k) {
  int largest = k;
  const double* entry = row(k) + k;
  double size = std::abs(*entry);
  for (int i = k + 1; i < size_; ++i) {
    entry += stride_;
    const double other = std::abs(*entry);
    if (other > size) {
      size = other;
      largest = i;
    }
  }
  return largest;
}

/// Subtracts multiples of row k from the rows below, a few rows at once. The first block may hold columns up to k:
/// nobody reads them again.
void DenseLu::eliminate(int k) {
  const double* const pivot_row = row(k);
  double* const factors = multipliers(k);
  const double minus_inverse = -inverse_pivot_[k];
  const int first = (k + 1) / block * block, stride = stride_;
  for (int i = k + 1; i < size_; i += together) {
    double* rows[together];
    double factor[together];
    for (int r = 0; r < together; ++r) {
      rows[r] = row(i + r);
      factors[i + r] = factor[r] = rows[r][k] * minus_inverse;
    }
    for (int j = first; j < stride; j += block) {
      const Block pivot = BlockOf(pivot_row + j);
      for (int r = 0; r < together; ++r) BlockAt(rows[r] + j) += factor[r] * pivot;
    }
  }
}

bool DenseLu::factorise() {
  for (int i = 0; i < size_; ++i) std::fill(row(i) + size_, row(i) + stride_, 0.0);
  for (int k = 0; k < size_; ++k) {
    const int other = largest_below(k);
    exchanged_[static_cast<std::size_t>(k)] = other;
    if (other != k) std::swap_ranges(row(k) + k, row(k) + size_, row(other) + k);
    double* const pivot_row = row(k);
    // A number that is not finite reaches a pivot: every later row takes it over, as it is or as NaN.
    if (!(std::abs(pivot_row[k]) > 0) || !std::isfinite(pivot_row[k])) return false;
    inverse_pivot_[k] = 1 / pivot_row[k];
    eliminate(k);
    std::fill(pivot_row + static_cast<std::ptrdiff_t>((k + 1) / block) * block, pivot_row + k + 1,
              0.0);  // solve() goes over whole blocks
  }
  return true;
}

void DenseLu::solve(Array& x) {
  double* const y = padded_.data();
  std::copy_n(x.data(), size_, y);
  for (int k = 0; k < size_; ++k) {
    std::swap(y[k], y[exchanged_[static_cast<std::size_t>(k)]]);
    const double* const factors = multipliers(k);
    for (int i = k + 1; i < size_; ++i) y[i] += factors[i] * y[k];
  }
  for (int k = size_ - 1; k >= 0; --k) {
    const double* const pivot_row = row(k);
    Block sum = Block::Zero();
    for (int j = (k + 1) / block * block; j < stride_; j += block) sum += BlockOf(pivot_row + j) * BlockOf(y + j);
    y[k] = (y[k] - sum.sum()) * inverse_pivot_[k];
  }
  std::copy_n(y, size_, x.data());
}

}  // namespace ehd::fast
