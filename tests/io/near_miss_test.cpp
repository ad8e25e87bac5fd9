// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/near_miss.hpp"

#include "tests/check.hpp"

using namespace ehd;

BOOST_AUTO_TEST_SUITE(near_miss)

BOOST_AUTO_TEST_CASE(the_nearest_name_is_named_and_a_far_one_is_not) {
  const std::vector<std::string> names{"pitch_diameter_m", "roller_diameter_m", "clearance_m", "radial_load_N", "M"};
  BOOST_TEST(ehd::near_miss("pitch_diameter_mm", names) == "pitch_diameter_m");
  BOOST_TEST(ehd::near_miss("clearence_m", names) == "clearance_m");
  BOOST_TEST(ehd::near_miss("clear", names) == "clearance_m");                                          // the beginning
  BOOST_TEST(ehd::near_miss("--tol", {"--L", "--tolerance-central", "--tolerance"}) == "--tolerance");  // not --L
  BOOST_TEST(ehd::near_miss("load", names) == "radial_load_N");                                         // a part
  BOOST_TEST(ehd::near_miss("oad", names) == "");  // too short a part
  BOOST_TEST(ehd::near_miss("Q", names) == "");
  BOOST_TEST(ehd::near_miss("viscosity", names) == "");
  BOOST_TEST(did_you_mean("clearence_m", names) == "did you mean clearance_m? ");
  BOOST_TEST(did_you_mean("viscosity", names) == "");
}

BOOST_AUTO_TEST_CASE(words_between_underscores_count_and_units_alone_do_not) {
  const std::vector<std::string> conditions{"load_N_per_m", "reduced_radius_m", "speed_sum_m_per_s", "viscosity_Pa_s"};
  BOOST_TEST(ehd::near_miss("load_N_m", conditions) == "load_N_per_m");
  BOOST_TEST(ehd::near_miss("speed_m_per_s", conditions) == "speed_sum_m_per_s");
  BOOST_TEST(ehd::near_miss("length_m_per_s", conditions) == "");
  const std::vector<std::string> bearing{"rollers", "pitch_diameter_m", "roller_diameter_m", "length_m"};
  BOOST_TEST(ehd::near_miss("roller_dia_m", bearing) == "roller_diameter_m");
}

BOOST_AUTO_TEST_CASE(a_short_word_counts_where_one_name_alone_has_it) {
  const std::vector<std::string> oil{"viscosity_Pa_s", "iso_vg", "viscosity_40C_mm2_per_s", "temperature_C"};
  BOOST_TEST(ehd::near_miss("vg", oil) == "iso_vg");
  BOOST_TEST(ehd::near_miss("VG", oil) == "iso_vg");
  BOOST_TEST(ehd::near_miss("isovg", oil) == "iso_vg");
  BOOST_TEST(ehd::near_miss("per", {"load_N_per_m", "speed_m_per_s"}) == "");
  BOOST_TEST(ehd::near_miss("C", oil) == "");
  BOOST_TEST(ehd::near_miss("lw", {"films", "law"}) == "law");  // a letter is missing
  BOOST_TEST(ehd::near_miss("lw", {"la", "l", "w"}) == "");
}

BOOST_AUTO_TEST_CASE(two_swapped_letters_are_one_difference) {
  BOOST_TEST(ehd::near_miss("fats", {"reference", "fast"}) == "fast");
  BOOST_TEST(ehd::near_miss("afst", {"reference", "fast"}) == "fast");
  BOOST_TEST(ehd::near_miss("heigth_m", {"height_m", "weight_m"}) == "height_m");
  BOOST_TEST(ehd::near_miss("tsaf", {"reference", "fast"}) == "");
}

BOOST_AUTO_TEST_CASE(capital_letters_are_small_ones) {
  const std::vector<std::string> names{"lambda", "M", "L", "W", "U_mean"};
  BOOST_TEST(ehd::near_miss("l", names) == "L");
  BOOST_TEST(ehd::near_miss("u_mean", names) == "U_mean");
  BOOST_TEST(ehd::near_miss("la", names) == "lambda");
  BOOST_TEST(ehd::near_miss("u", names) == "U_mean");
  BOOST_TEST(ehd::near_miss("LAMB", names) == "lambda");                             // the beginning of a longer word
  BOOST_TEST(ehd::near_miss("EDUCED", {"reduced_radius_m"}) == "reduced_radius_m");  // a part
  BOOST_TEST(ehd::near_miss("Q", names) == "");
}

BOOST_AUTO_TEST_CASE(an_unknown_word_is_refused_with_the_nearest_as_it_is_written) {
  BOOST_TEST(is_unknown("fst", "reference, fast") == "is unknown; did you mean fast? allowed is reference, fast");
  BOOST_TEST(is_unknown("baruss", "\"barus\", \"roelands\"") ==
             "is unknown; did you mean \"barus\"? allowed is \"barus\", \"roelands\"");
  BOOST_TEST(is_unknown("magic", "reference, fast") == "is unknown; allowed is reference, fast");
  BOOST_TEST(is_unknown("", "reference, fast") == "is unknown; allowed is reference, fast");
}

BOOST_AUTO_TEST_SUITE_END()
