// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/approach_formulas.hpp"

#include "bearing/force_law.hpp"
#include "contact/approach.hpp"
#include "tests/check.hpp"

namespace ehd::bearing {

using verification::Tolerance;

namespace {

RollerContact some_contact() {
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

// The printed table is judged by the claims approach/* (verification/claims/literature.cpp).

// Exact: Lundberg's formula is the log kernel with x_0 = l.
BOOST_AUTO_TEST_CASE(lundberg_is_the_dry_approach_with_the_length_as_datum) {
  const RollerContact contact = some_contact();
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
