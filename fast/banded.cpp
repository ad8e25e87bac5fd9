// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/banded.hpp"

#include <algorithm>

namespace ehd::fast {

template <class Scalar>
bool BandedOf<Scalar>::factorise() {
  Factorisation rows(*this);
  while (rows.next()) {
  }
  return rows.succeeded();
}

// A row needs the result of the row before. The term with that result comes last: only one product waits for it.
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
    Scalar sum = times(at[i], rows[i][lower]);
    for (std::size_t m = last; m >= 1; --m) sum -= times(rows[i][lower + m], at[i + m]);
    at[i] = sum;
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
