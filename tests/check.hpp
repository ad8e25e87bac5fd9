// SPDX-License-Identifier: GPL-3.0-or-later
// The one wrapper that tests decide with: error <= tolerance, so that NaN cannot pass, and the tolerance's reason is
// printed beside a failure.
#pragma once

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "verification/tolerance.hpp"

namespace ehd::testing {
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
}  // namespace ehd::testing

namespace ehd {

/// |value - truth|/|truth|, absolute where the truth is 0.
inline double error(double value, double truth) {
  return truth == 0 ? std::abs(value) : std::abs(value - truth) / std::abs(truth);
}

#define EHD_CHECK(error_expression, tolerance_expression)                                                             \
  do {                                                                                                                \
    const double measured_error_ = (error_expression);                                                                \
    const ::ehd::verification::Tolerance tolerance_ = (tolerance_expression);                                         \
    BOOST_CHECK_MESSAGE(measured_error_ <= tolerance_.value(), #error_expression << " = " << measured_error_ << " > " \
                                                                                 << tolerance_.value() << " ("        \
                                                                                 << tolerance_.reason() << ")");      \
  } while (false)

}  // namespace ehd
