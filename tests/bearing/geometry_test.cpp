// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/geometry.hpp"

#include <algorithm>
#include <cmath>

#include "tests/check.hpp"

namespace ehd::bearing {

using verification::Tolerance;

namespace {

Geometry needle_bearing() {
  return {.rollers = 22,
          .pitch_diameter_m = 0.053,
          .roller_diameter_m = 0.005,
          .length_m = 0.122,
          .clearance_m = 2.5e-6,
          .density_kg_per_m3 = 7850};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(geometry)

// Radii, moduli, speeds and centrifugal forces are judged by the claims bearing/kinematics/* and
// bearing/centrifugal-209 (verification/claims).

BOOST_AUTO_TEST_CASE(a_ring_without_a_cage_is_full_when_its_rollers_touch) {
  BOOST_TEST(most_rollers(2, 1) == 6);  // a hexagon of centres
  BOOST_TEST(most_rollers(2, 1 + 1e-6) == 5);
  BOOST_TEST(most_rollers(0.065, 0.010) == 20);
}

// Invariant.
BOOST_AUTO_TEST_CASE(rollers_at_mirrored_azimuths_form_one_group) {
  Geometry bearing = needle_bearing();
  const auto groups_of = [&](double first_azimuth_deg) {
    bearing.first_azimuth_deg = first_azimuth_deg;
    return mirror_groups(azimuths_deg(bearing));
  };
  BOOST_TEST(groups_of(0).size() == 12u);           // 0, 10 pairs, 180
  BOOST_TEST(groups_of(180.0 / 22).size() == 11u);  // 11 pairs
  BOOST_TEST(groups_of(360.0 / 22).size() == 12u);  // roller 22 on the load line
  BOOST_TEST(groups_of(3.0).size() == 22u);         // no symmetry
  std::size_t members = 0;
  for (const RollerGroup& group : groups_of(0)) members += group.members.size();
  BOOST_TEST(members == 22u);
}

// Exact: a symmetric cage is symmetric to the bit, wherever its first roller is counted from.
BOOST_AUTO_TEST_CASE(a_symmetric_cage_is_mirrored_to_the_bit) {
  for (const int rollers : {3, 7, 13, 22, 113, 400})
    for (const int half_pitches : {0, 1, 2, 5, -3}) {
      Geometry bearing = needle_bearing();
      bearing.rollers = rollers;
      bearing.first_azimuth_deg = half_pitches * 180.0 / rollers;
      const auto azimuths = azimuths_deg(bearing);
      BOOST_TEST(symmetric_to_load(azimuths));
      for (const double psi : azimuths) {
        BOOST_TEST((psi == 0 || psi == 180 || std::find(azimuths.begin(), azimuths.end(), -psi) != azimuths.end()));
        BOOST_TEST(cosine_of_degrees(psi) == cosine_of_degrees(-psi));
        BOOST_TEST(sine_of_degrees(psi) == -sine_of_degrees(-psi));
      }
      bearing.first_azimuth_deg += 1e-9;
      BOOST_TEST(!symmetric_to_load(azimuths_deg(bearing)));
    }
}

// Exact values, and the library's functions elsewhere.
BOOST_AUTO_TEST_CASE(sines_and_cosines_of_degrees) {
  BOOST_TEST(cosine_of_degrees(90) == 0);
  BOOST_TEST(sine_of_degrees(-90) == -1);
  BOOST_TEST(sine_of_degrees(180) == 0);
  BOOST_TEST(cosine_of_degrees(-120) == -0.5);
  BOOST_TEST(sine_of_degrees(150) == 0.5);
  for (const double psi : {-171.3, -95.0, -1e-7, 12.5, 88.0, 133.7}) {
    EHD_CHECK(error(cosine_of_degrees(psi), std::cos(psi * std::acos(-1) / 180)), Tolerance::round_off(20));
    EHD_CHECK(error(sine_of_degrees(psi), std::sin(psi * std::acos(-1) / 180)), Tolerance::round_off(20));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::bearing
