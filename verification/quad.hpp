// SPDX-License-Identifier: GPL-3.0-or-later
// 34 digits: float128 of libquadmath where the compiler is gcc, elsewhere the same format in software. Only for
// templates that measure what rounding does.
#pragma once

#if defined(__GNUC__) && !defined(__clang__)
#include <boost/multiprecision/float128.hpp>
#else
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif
#include <boost/multiprecision/eigen.hpp>

namespace ehd::verification {

#if defined(__GNUC__) && !defined(__clang__)
using Quad = boost::multiprecision::float128;
#else
using Quad = boost::multiprecision::cpp_bin_float_quad;
#endif

}  // namespace ehd::verification
