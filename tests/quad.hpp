// SPDX-License-Identifier: GPL-3.0-or-later
// What rounding does is measured by running the same template with 34 digits. cpp_bin_float and not float128: it needs
// no compiler's extension and no library, and is only half as fast.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <limits>

namespace ehd::testing {

using Quad = boost::multiprecision::cpp_bin_float_quad;

/// An error in any type, as large as it would be in double: one eps of Scalar becomes one of double, so that
/// Tolerance::round_off holds for both.
template <class Scalar>
double as_in_double(const Scalar& error) {
  using std::abs;
  return static_cast<double>(abs(error) / std::numeric_limits<Scalar>::epsilon()) *
         std::numeric_limits<double>::epsilon();
}

}  // namespace ehd::testing
