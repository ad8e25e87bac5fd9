// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/banded.hpp"

#include <cmath>

namespace ehd::fast {

namespace {

/// A pivot below this share of the upper part of its row counts as zero.
constexpr double smallest_pivot = 1e-14;

}  // namespace

bool Banded::factorise() {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Row& r = rows_[i];
    // Eliminate columns i-3, i-2, i-1 with the finished rows, whose own diagonal stands at index 3.
    for (std::size_t k = 0; k < lower; ++k) {
      if (i + k < lower) continue;
      const Row& pivot = rows_[i + k - lower];
      const double factor = r[k] * pivot[lower];  // the diagonal is kept inverted
      r[k] = factor;
      for (std::size_t m = 1; m <= upper; ++m) r[k + m] -= factor * pivot[lower + m];
    }
    const double size = std::abs(r[lower]) + std::abs(r[lower + 1]) + std::abs(r[lower + 2]);
    if (!(std::abs(r[lower]) > smallest_pivot * size)) return false;
    r[lower] = 1 / r[lower];
  }
  return true;
}

void Banded::solve(Array& x) const {
  const auto n = static_cast<Eigen::Index>(rows_.size());
  for (Eigen::Index i = 0; i < n; ++i) {
    const Row& r = rows_[static_cast<std::size_t>(i)];
    double sum = x[i];
    for (int k = 0; k < lower; ++k) {
      const Eigen::Index j = i - lower + k;
      if (j >= 0) sum -= r[static_cast<std::size_t>(k)] * x[j];
    }
    x[i] = sum;
  }
  for (Eigen::Index i = n - 1; i >= 0; --i) {
    const Row& r = rows_[static_cast<std::size_t>(i)];
    double sum = x[i];
    for (std::size_t m = 1; m <= upper; ++m) {
      const Eigen::Index j = i + static_cast<Eigen::Index>(m);
      if (j < n) sum -= r[lower + m] * x[j];
    }
    x[i] = sum * r[lower];
  }
}

}  // namespace ehd::fast
