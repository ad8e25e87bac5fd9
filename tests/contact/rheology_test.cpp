// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/check.hpp"
BOOST_AUTO_TEST_SUITE(rheology)
BOOST_AUTO_TEST_CASE(placeholder) { BOOST_TEST(true); }
BOOST_AUTO_TEST_SUITE_END()
