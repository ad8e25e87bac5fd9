// SPDX-License-Identifier: GPL-3.0-or-later
// What the claims motion/* do not judge: limits, absent damping, and errors.
#include "bearing/dynamics.hpp"

#include <cmath>
#include <limits>

#include "tests/bearing/synthetic.hpp"
#include "tests/check.hpp"

namespace ehd::bearing {

using verification::Tolerance;

BOOST_AUTO_TEST_SUITE(dynamics)

// Exact: at omega = 0 two springs with dampers in series.
BOOST_AUTO_TEST_CASE(without_a_frequency_the_damping_is_its_limit) {
  const ContactMotion inner{.stiffness_N_per_m = 3e9, .damping_N_s_per_m = 1200},
      outer{.stiffness_N_per_m = 2e9, .damping_N_s_per_m = 900};
  const RingMotion ring = ring_motion({{30, inner, outer}}, 0.019, 0);
  const double k = 3e9 * 2e9 / 5e9, c = (1200 * 4.0 + 900 * 9.0) / 25;
  const Tolerance rounding = Tolerance::round_off(32);
  EHD_CHECK(error(ring.stiffness_N_per_m[0][0], 0.75 * k), rounding);
  EHD_CHECK(error(ring.stiffness_N_per_m[0][1], std::sqrt(0.1875) * k), rounding);
  BOOST_TEST(ring.stiffness_N_per_m[1][0] == ring.stiffness_N_per_m[0][1]);
  BOOST_REQUIRE(ring.damping_N_s_per_m.has_value());
  EHD_CHECK(error((*ring.damping_N_s_per_m)[1][1], 0.25 * c), rounding);
}

BOOST_AUTO_TEST_CASE(an_unloaded_roller_gives_nothing_and_a_dry_one_no_damping) {
  const ContactMotion dry{.stiffness_N_per_m = 1e9};
  const RingMotion ring = ring_motion({{0, dry, dry}, {180, {}, dry}}, 0.02, 10);
  EHD_CHECK(error(ring.stiffness_N_per_m[0][0], 5e8), Tolerance::asymptotic(1e-8, "m omega^2/K"));
  BOOST_TEST(!ring.damping_N_s_per_m.has_value());
  BOOST_TEST(!ring.damping_error.has_value());
  BOOST_TEST(ring.error == 0);
}

// A shift of each contact by its error moves the ring by no more than the stated error, to first order by just that.
BOOST_AUTO_TEST_CASE(errors_of_contacts_become_the_error_of_the_ring) {
  const ContactMotion inner{3e9, 1200, 3e6, 12}, outer{2e9, 900, 1e6, 0};
  const double omega = 6000;
  const RingMotion ring = ring_motion({{0, inner, outer}}, 0.019, omega);
  const ContactMotion stiffer{3.003e9, 1212}, outer_stiffer{2.001e9, 900};
  const RingMotion moved = ring_motion({{0, stiffer, outer_stiffer}}, 0.019, omega);
  const double stiffness = moved.stiffness_N_per_m[0][0] / ring.stiffness_N_per_m[0][0] - 1;
  const double damping = std::abs((*moved.damping_N_s_per_m)[0][0] / (*ring.damping_N_s_per_m)[0][0] - 1);
  EHD_CHECK(error(ring.error, stiffness), Tolerance::asymptotic(0.01, "the squares of errors of 1e-3"));
  EHD_CHECK(damping / *ring.damping_error, Tolerance::stated());
}

// Invariant: the datum's compliance has no damping, and a longer datum softens.
BOOST_AUTO_TEST_CASE(a_longer_datum_softens) {
  const RacewayContact contact = synthetic::contact();
  const Kappa kappa{.stiffness = 4.1, .damping = 0.3, .stiffness_error = 0.004, .damping_error = 0.003};
  const ContactMotion at_l = contact_motion(contact, 3000, contact.length_m, 0, kappa);
  const double film = contact.length_m * contact.reduced_modulus_Pa / 4;
  EHD_CHECK(error(at_l.stiffness_N_per_m, film * 4.1), Tolerance::round_off(32));
  EHD_CHECK(error(at_l.stiffness_error, film * 0.004), Tolerance::round_off(32, 1e4));
  const ContactMotion longer = contact_motion(contact, 3000, 10 * contact.length_m, 0, kappa);
  BOOST_TEST(longer.stiffness_N_per_m < at_l.stiffness_N_per_m);
  const double slack = 4 * std::log(10.0) / (std::acos(-1) * contact.reduced_modulus_Pa * contact.length_m);
  EHD_CHECK(error(1 / longer.stiffness_N_per_m, 1 / at_l.stiffness_N_per_m + slack), Tolerance::round_off(64));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::bearing
