// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/oil_grade.hpp"

#include <string>

#include "tests/check.hpp"

using namespace ehd;
using namespace ehd::verification;

BOOST_AUTO_TEST_SUITE(oil_grade)

BOOST_AUTO_TEST_CASE(a_grade_is_its_number_but_for_the_four_thinnest) {
  BOOST_TEST(iso_viscosity_grades().size() == 20u);
  BOOST_TEST(midpoint_of_grade_mm2_per_s(68).value() == 68);
  BOOST_TEST(midpoint_of_grade_mm2_per_s(2).value() == 2.2);
  BOOST_TEST(midpoint_of_grade_mm2_per_s(7).value() == 6.8);
  BOOST_TEST(!midpoint_of_grade_mm2_per_s(70).has_value());
}

BOOST_AUTO_TEST_CASE(no_index_is_defined_below_2_mm2_per_s_at_100_C) {
  BOOST_TEST(!viscosity_index(5, 1.99).has_value());
  BOOST_TEST(viscosity_index(5, 2).has_value());
  BOOST_TEST(!viscosity_100C_mm2_per_s(4.6, 95).has_value());
  BOOST_TEST(viscosity_100C_mm2_per_s(6.8, 95).value() >= 2);
}

BOOST_AUTO_TEST_CASE(a_higher_index_means_more_viscosity_at_100_C) {
  double before = 0;
  for (const double index : {0.0, 60.0, 95.0, 100.0, 101.0, 200.0}) {
    const double hot = viscosity_100C_mm2_per_s(100, index).value();
    BOOST_TEST(hot > before);
    before = hot;
  }
}

BOOST_AUTO_TEST_CASE(viscosities_outside_the_range_of_D341_are_absent) {
  BOOST_TEST(!viscosity_at_mm2_per_s(3200, 60, -50).has_value());
  BOOST_TEST(!viscosity_at_mm2_per_s(0.5, 0.25, 150).has_value());
  BOOST_TEST(viscosity_at_mm2_per_s(68, 8.5, 60).has_value());
}

BOOST_AUTO_TEST_CASE(density_is_the_stated_one_at_15_C_and_falls_by_the_printed_coefficient) {
  BOOST_TEST(oil_density_kg_per_m3(870, 15) == 870);
  // alpha_15 = 0.6278/870 per kelvin; over one kelvin the second order is 1.3 alpha^2 = 7e-7.
  const double fall = 1 - oil_density_kg_per_m3(870, 16) / 870;
  EHD_CHECK(error(fall, 0.6278 / 870), Tolerance::asymptotic(1e-3, "second order of the expansion over one kelvin"));
}

BOOST_AUTO_TEST_CASE(woosters_estimate_at_1_and_10_mPa_s) {
  EHD_CHECK(error(wooster_alpha_per_Pa(1e-3).value(), 0.6e-8), Tolerance::round_off(10));
  EHD_CHECK(error(wooster_alpha_per_Pa(1e-2).value(), 1.565e-8), Tolerance::round_off(10));
  BOOST_TEST(!wooster_alpha_per_Pa(2e-4).has_value());
}

BOOST_AUTO_TEST_CASE(notes_name_the_standards_and_the_estimate_only_where_it_was_made) {
  GradedOil oil{.iso_vg = 68,
                .viscosity_40C_mm2_per_s = 68,
                .viscosity_100C_mm2_per_s = 8.53,
                .viscosity_index = 95,
                .temperature_C = 60,
                .density_15C_kg_per_m3 = 870,
                .viscosity_mm2_per_s = 28.4,
                .density_kg_per_m3 = 841.5,
                .viscosity_Pa_s = 0.0239};
  const auto stated = notes_of(oil, {"more"});
  BOOST_REQUIRE(stated.size() == 2u);
  BOOST_TEST(stated.back() == "more");
  for (const char* phrase : {"ISO VG 68", "D341", "D2270", "D1250", "0.0239 Pa s"})
    BOOST_CHECK_MESSAGE(stated.front().find(phrase) != std::string::npos, phrase << ": " << stated.front());
  oil.estimated_alpha_per_Pa = 1.93e-8;
  BOOST_REQUIRE(notes_of(oil).size() == 2u);
  BOOST_TEST(notes_of(oil).back().find("Wooster") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
