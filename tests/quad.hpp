// SPDX-License-Identifier: GPL-3.0-or-later
// Rounding is measured by running the same template with 34 digits: float128 of libquadmath where the compiler is gcc,
// elsewhere the same format in software.
#pragma once

#include <boost/mpl/list.hpp>
#include <limits>

#include "verification/quad.hpp"

namespace ehd::testing {

using verification::Quad;
using Scalars = boost::mpl::list<double, Quad>;

/// An error in any type, as large as it would be in double: one eps of Scalar becomes one of double, so that
/// Tolerance::round_off holds for both.
template <class Scalar>
double as_in_double(const Scalar& error) {
  using std::abs;
  return static_cast<double>(abs(error) / std::numeric_limits<Scalar>::epsilon()) *
         std::numeric_limits<double>::epsilon();
}

template <class Scalar>
Scalar power(const Scalar& t, int k) {
  Scalar value(1);
  for (int i = 0; i < k; ++i) value *= t;
  return value;
}

}  // namespace ehd::testing
