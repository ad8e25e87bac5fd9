// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/banded.hpp"

#include <algorithm>

namespace ehd::fast {

namespace {

/// A pivot below this share of the upper part of its row counts as zero.
constexpr double smallest_pivot = 1e-14;

}  // namespace

template <class Scalar>
bool BandedOf<Scalar>::factorise() {
  Row* const rows = rows_.data();
  // Row i, with the finished rows i-3+first .. i-1, whose own diagonal stands at index 3.
  const auto eliminate = [rows](std::size_t i, std::size_t first) {
    Row& r = rows[i];
    for (std::size_t k = first; k < lower; ++k) {
      const Row& pivot = rows[i + k - lower];
      const Scalar factor = times(r[k], pivot[lower]);  // the diagonal is kept inverted
      r[k] = factor;
      for (std::size_t m = 1; m <= upper; ++m) r[k + m] -= times(factor, pivot[lower + m]);
    }
    const double size = size_of(r[lower]) + size_of(r[lower + 1]) + size_of(r[lower + 2]);
    if (!(size_of(r[lower]) > smallest_pivot * size)) return false;
    r[lower] = inverse_of(r[lower]);
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

template <class Scalar>
void BandedOf<Scalar>::solve(ArrayOf<Scalar>& x) const {
  const Row* const rows = rows_.data();
  Scalar* const at = x.data();
  const auto forward = [rows, at](std::size_t i, std::size_t first) {
    Scalar sum = at[i];
    for (std::size_t k = first; k < lower; ++k) sum -= times(rows[i][k], at[i + k - lower]);
    at[i] = sum;
  };
  const auto backward = [rows, at](std::size_t i, std::size_t last) {
    Scalar sum = at[i];
    for (std::size_t m = 1; m <= last; ++m) sum -= times(rows[i][lower + m], at[i + m]);
    at[i] = times(sum, rows[i][lower]);
  };
  const std::size_t n = rows_.size();
  const std::size_t beside = std::min<std::size_t>(lower, n), inside = n > upper ? n - upper : 0;
  for (std::size_t i = 0; i < beside; ++i) forward(i, lower - i);
  for (std::size_t i = beside; i < n; ++i) forward(i, 0);
  for (std::size_t i = n; i-- > inside;) backward(i, n - 1 - i);
  for (std::size_t i = inside; i-- > 0;) backward(i, upper);
}

template class BandedOf<double>;
template class BandedOf<Complex>;

}  // namespace ehd::fast
