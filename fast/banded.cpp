// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/banded.hpp"

#include <cmath>

namespace ehd::fast {

namespace {

/// A pivot below this share of the upper part of its row counts as zero.
constexpr double smallest_pivot = 1e-14;

}  // namespace

bool Banded::factorise() {
  const int n = rows();
  for (int i = 0; i < n; ++i) {
    Row& r = rows_[static_cast<std::size_t>(i)];
    // Eliminate columns i-3, i-2, i-1 with the finished rows, whose own diagonal stands at index 3.
    for (int k = 0; k < lower; ++k) {
      const int j = i - lower + k;
      if (j < 0) continue;
      const Row& pivot = rows_[static_cast<std::size_t>(j)];
      const double factor = r[static_cast<std::size_t>(k)] * pivot[lower];  // diagonal is kept inverted
      r[static_cast<std::size_t>(k)] = factor;
      for (int m = 1; m <= upper; ++m)
        r[static_cast<std::size_t>(k + m)] -= factor * pivot[static_cast<std::size_t>(lower + m)];
    }
    const double size = std::abs(r[lower]) + std::abs(r[lower + 1]) + std::abs(r[lower + 2]);
    if (!(std::abs(r[lower]) > smallest_pivot * size)) return false;
    r[lower] = 1 / r[lower];
  }
  return true;
}

void Banded::solve(Array& x) const {
  const int n = static_cast<int>(rows_.size());
  for (int i = 0; i < n; ++i) {
    const Row& r = rows_[static_cast<std::size_t>(i)];
    double sum = x[i];
    for (int k = 0; k < lower; ++k) {
      const int j = i - lower + k;
      if (j >= 0) sum -= r[static_cast<std::size_t>(k)] * x[j];
    }
    x[i] = sum;
  }
  for (int i = n - 1; i >= 0; --i) {
    const Row& r = rows_[static_cast<std::size_t>(i)];
    double sum = x[i];
    for (int m = 1; m <= upper; ++m) {
      if (i + m < n) sum -= r[static_cast<std::size_t>(lower + m)] * x[i + m];
    }
    x[i] = sum * r[lower];
  }
}

}  // namespace ehd::fast
