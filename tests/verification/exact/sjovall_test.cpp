// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/exact/sjovall.hpp"

#include <cmath>

#include "bearing/equilibrium.hpp"
#include "tests/check.hpp"

namespace ehd::verification {

using exact::SjovallIntegral;

BOOST_AUTO_TEST_SUITE(exact_sjovall)

// Tabulated values are judged by the claims sjovall/ of `ehd verify`, not here.

// Exact: n = 1 has a closed form at eps = 1/2 and eps = 1, (1/2 pi) Int cos^2 over the half circle and so on.
BOOST_AUTO_TEST_CASE(the_linear_law_has_closed_forms) {
  EHD_CHECK(error(SjovallIntegral{1.0}(0.5), 0.25), Tolerance::required(1e-12, "promised by the header"));
  EHD_CHECK(error(SjovallIntegral{1.0}(1.0), 0.25), Tolerance::required(1e-12, "promised by the header"));
  EHD_CHECK(error(SjovallIntegral{1.0}(4.0), 1.0 / 16), Tolerance::required(1e-12, "promised by the header"));
}

BOOST_AUTO_TEST_CASE(an_empty_load_zone_is_refused) {
  BOOST_CHECK_THROW((void)SjovallIntegral{}(0), std::domain_error);
}

// Limit: F_r/(Z Q_max) of the equilibrium tends to J_r(eps) as rollers are added, at every size of load zone.
BOOST_AUTO_TEST_CASE(many_rollers_share_the_load_as_sjovall_says) {
  const double length_m = 0.012, load_N = 9e3;
  const bearing::PowerLaw law = bearing::palmgren_law(length_m);
  for (const double clearance_m : {-8e-6, 0.0, 5e-6, 40e-6}) {
    int judged = 0;
    for (const int rollers : {51, 101, 201, 401}) {
      const bearing::Geometry geometry{.rollers = rollers,
                                       .pitch_diameter_m = 0.07,
                                       .roller_diameter_m = 0.009,
                                       .length_m = length_m,
                                       .clearance_m = clearance_m};
      const auto balanced = bearing::balance(geometry, {law, law}, {.radial_N = load_N * rollers / 51});
      BOOST_REQUIRE(std::holds_alternative<bearing::Equilibrium>(balanced));
      const auto& ring = std::get<bearing::Equilibrium>(balanced);
      const double eps = exact::load_zone_parameter(ring.displacement_m, clearance_m);
      const double share = load_N * rollers / 51 / (rollers * ring.rollers[0].inner.force_N);
      // The trapezoid sum of a function with a corner of power n errs by Z^-(n+1).
      EHD_CHECK(error(share, SjovallIntegral{}(eps)),
                Tolerance::asymptotic(10.0 / (rollers * rollers), "order Z^-2, corner of the load zone"));
      ++judged;
    }
    BOOST_TEST(judged == 4);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::verification
