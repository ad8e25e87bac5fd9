// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/approach_formulas.hpp"

#include "bearing/force_law.hpp"
#include "contact/approach.hpp"
#include "tests/check.hpp"

namespace ehd::bearing {

using verification::Tolerance;

namespace {

RollerContact printed_example() {
  return {.force_N = 10e3,
          .length_m = 0.030,
          .roller_diameter_m = 0.020,
          .pitch_diameter_m = 0.060,
          .modulus_Pa = 2.031e11,
          .poisson = 0.3,
          .ring_thickness_m = 0.006};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(approach_formulas)

// Published: Teutsch & Sauer 2004, table 1, evaluated at D=20 l=30 d_m=60 t=6 mm, E=2.031e5 MPa, Q=10 kN; micrometre.
BOOST_AUTO_TEST_CASE(approaches_of_the_printed_table) {
  const RollerContact contact = printed_example();
  const auto micrometre = [](double metre) { return 1e6 * metre; };
  using enum Raceway;
  EHD_CHECK(error(micrometre(palmgren_approach_m(contact)), 10.061), Tolerance::published_digits("10.061"));
  EHD_CHECK(error(micrometre(kunert_approach_m(contact)), 11.269), Tolerance::published_digits("11.269"));
  EHD_CHECK(error(micrometre(lundberg_approach_m(contact, inner)), 12.231), Tolerance::published_digits("12.231"));
  EHD_CHECK(error(micrometre(lundberg_approach_m(contact, outer)), 11.572), Tolerance::published_digits("11.572"));
  EHD_CHECK(error(micrometre(tripp_approach_m(contact, inner)), 10.217), Tolerance::published_digits("10.217"));
  EHD_CHECK(error(micrometre(tripp_approach_m(contact, outer)), 8.026), Tolerance::published_digits("8.026"));
  EHD_CHECK(error(micrometre(houpert_approach_m(contact, inner)), 10.410), Tolerance::published_digits("10.410"));
  EHD_CHECK(error(micrometre(houpert_approach_m(contact, outer)), 8.733), Tolerance::published_digits("8.733"));
}

// Exact: Lundberg's formula is the log kernel with x_0 = l.
BOOST_AUTO_TEST_CASE(lundberg_is_the_dry_approach_with_the_length_as_datum) {
  const RollerContact contact = printed_example();
  const Geometry geometry{.rollers = 1, .pitch_diameter_m = 0.060, .roller_diameter_m = 0.020};
  for (const Raceway raceway : {Raceway::inner, Raceway::outer}) {
    const Conditions conditions{.load_N_per_m = contact.force_N / contact.length_m,
                                .reduced_radius_m = reduced_radius_m(geometry, raceway),
                                .reduced_modulus_Pa = reduced_modulus_Pa(contact.modulus_Pa, contact.poisson)};
    EHD_CHECK(error(dry_approach_m(conditions, contact.length_m), lundberg_approach_m(contact, raceway)),
              Tolerance::round_off(50));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::bearing
