// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/banded.hpp"

#include <algorithm>
#include <cmath>

namespace ehd::fast {

namespace {

/// A pivot below this share of the upper part of its row counts as zero.
constexpr double smallest_pivot = 1e-14;

}  // namespace

bool Banded::factorise() {
  Row* const rows = rows_.data();
  // Row i, with the finished rows i-3+first .. i-1, whose own diagonal stands at index 3.
  const auto eliminate = [rows](std::size_t i, std::size_t first) {
    Row& r = rows[i];
    for (std::size_t k = first; k < lower; ++k) {
      const Row& pivot = rows[i + k - lower];
      const double factor = r[k] * pivot[lower];  // the diagonal is kept inverted
      r[k] = factor;
      for (std::size_t m = 1; m <= upper; ++m) r[k + m] -= factor * pivot[lower + m];
    }
    const double size = std::abs(r[lower]) + std::abs(r[lower + 1]) + std::abs(r[lower + 2]);
    if (!(std::abs(r[lower]) > smallest_pivot * size)) return false;
    r[lower] = 1 / r[lower];
    return true;
  };
  const std::size_t n = rows_.size(), beside = std::min<std::size_t>(lower, n);
  for (std::size_t i = 0; i < beside; ++i) {
    if (!eliminate(i, lower - i)) return false;
  }
  for (std::size_t i = beside; i < n; ++i) {
    if (!eliminate(i, 0)) return false;
  }
  return true;
}

void Banded::solve(Array& x) const {
  const Row* const rows = rows_.data();
  double* const at = x.data();
  const auto forward = [rows, at](std::size_t i, std::size_t first) {
    double sum = at[i];
    for (std::size_t k = first; k < lower; ++k) sum -= rows[i][k] * at[i + k - lower];
    at[i] = sum;
  };
  const auto backward = [rows, at](std::size_t i, std::size_t last) {
    double sum = at[i];
    for (std::size_t m = 1; m <= last; ++m) sum -= rows[i][lower + m] * at[i + m];
    at[i] = sum * rows[i][lower];
  };
  const std::size_t n = rows_.size();
  const std::size_t beside = std::min<std::size_t>(lower, n), inside = n > upper ? n - upper : 0;
  for (std::size_t i = 0; i < beside; ++i) forward(i, lower - i);
  for (std::size_t i = beside; i < n; ++i) forward(i, 0);
  for (std::size_t i = n; i-- > inside;) backward(i, n - 1 - i);
  for (std::size_t i = inside; i-- > 0;) backward(i, upper);
}

}  // namespace ehd::fast
