// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of memory are left out under AddressSanitizer: its allocator holds more than it is asked for, and ends the
// process where there is none. Boost.Test names what is left out.
#pragma once

#include <boost/test/unit_test.hpp>

namespace ehd::testing {

#if defined(__SANITIZE_ADDRESS__)  // gcc
inline constexpr bool address_sanitizer = true;
#elif defined(__has_feature)
inline constexpr bool address_sanitizer = __has_feature(address_sanitizer);  // clang
#else
inline constexpr bool address_sanitizer = false;
#endif

/// Decorator: BOOST_AUTO_TEST_CASE(name, *memory_is_measurable()).
inline auto memory_is_measurable() { return boost::unit_test::enable_if<!address_sanitizer>(); }

}  // namespace ehd::testing
