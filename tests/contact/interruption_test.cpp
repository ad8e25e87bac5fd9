// SPDX-License-Identifier: GPL-3.0-or-later
// That each solver ends where its caller wants so is tested in tests/bindings/threads_test.cpp.
#include "contact/interruption.hpp"

#include <boost/test/unit_test.hpp>
#include <thread>

using namespace ehd;

BOOST_AUTO_TEST_SUITE(interruption)

BOOST_AUTO_TEST_CASE(nobody_interrupts_where_nobody_can) { BOOST_TEST(!interrupted()); }

BOOST_AUTO_TEST_CASE(the_innermost_caller_is_asked_in_its_own_thread) {
  int asked = 0;
  {
    const Interruptible outer([&asked] { return ++asked > 1; });
    BOOST_TEST(!interrupted());
    BOOST_TEST(interrupted());
    {
      const Interruptible inner([] { return false; });
      BOOST_TEST(!interrupted());
    }
    BOOST_TEST(interrupted());
    std::jthread([] { BOOST_TEST(!interrupted()); }).join();
    BOOST_TEST(asked == 3);
  }
  BOOST_TEST(!interrupted());
}

BOOST_AUTO_TEST_SUITE_END()
