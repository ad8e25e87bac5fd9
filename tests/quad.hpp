// SPDX-License-Identifier: GPL-3.0-or-later
// What rounding does is measured by running the same template with 34 digits: float128 of libquadmath where the
// compiler is gcc, elsewhere the same format in software.
#pragma once

#include <limits>

#include "verification/quad.hpp"

namespace ehd::testing {

using verification::Quad;

/// An error in any type, as large as it would be in double: one eps of Scalar becomes one of double, so that
/// Tolerance::round_off holds for both.
template <class Scalar>
double as_in_double(const Scalar& error) {
  using std::abs;
  return static_cast<double>(abs(error) / std::numeric_limits<Scalar>::epsilon()) *
         std::numeric_limits<double>::epsilon();
}

}  // namespace ehd::testing
