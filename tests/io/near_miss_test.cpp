// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/near_miss.hpp"

#include "tests/check.hpp"

using namespace ehd;

BOOST_AUTO_TEST_SUITE(near_miss)

BOOST_AUTO_TEST_CASE(the_nearest_name_is_named_and_a_far_one_is_not) {
  const std::vector<std::string> names{"pitch_diameter_m", "roller_diameter_m", "clearance_m", "radial_load_N", "M"};
  BOOST_TEST(ehd::near_miss("pitch_diameter_mm", names) == "pitch_diameter_m");
  BOOST_TEST(ehd::near_miss("clearence_m", names) == "clearance_m");
  BOOST_TEST(ehd::near_miss("clear", names) == "clearance_m");   // the beginning
  BOOST_TEST(ehd::near_miss("load", names) == "radial_load_N");  // a part
  BOOST_TEST(ehd::near_miss("oad", names) == "");                // too short a part
  BOOST_TEST(ehd::near_miss("Q", names) == "");
  BOOST_TEST(ehd::near_miss("viscosity", names) == "");
  BOOST_TEST(did_you_mean("clearence_m", names) == "did you mean clearance_m? ");
  BOOST_TEST(did_you_mean("viscosity", names) == "");
}

BOOST_AUTO_TEST_SUITE_END()
