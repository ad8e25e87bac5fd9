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

inline boost::test_tools::assertion_result memory_can_be_measured(boost::unit_test::test_unit_id) {
  boost::test_tools::assertion_result result(!address_sanitizer);
  result.message() << "AddressSanitizer has its own allocator";
  return result;
}

/// Decorator: BOOST_AUTO_TEST_CASE(name, *needs_measurable_memory()).
inline auto needs_measurable_memory() { return boost::unit_test::precondition(&memory_can_be_measured); }

}  // namespace ehd::testing
