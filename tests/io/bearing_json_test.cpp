// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bearing_json.hpp"

#include <nlohmann/json.hpp>

#include "tests/check.hpp"
#include "tests/made_bearing.hpp"

using namespace ehd;
using namespace ehd::verification;

BOOST_AUTO_TEST_SUITE(bearing_json)

BOOST_AUTO_TEST_CASE(a_curve_has_each_of_its_errors) {
  const bearing::RacewayContact contact{.length_m = 0.1,
                                        .reduced_radius_m = 2e-3,
                                        .reduced_modulus_Pa = 2.3e11,
                                        .speed_sum_m_per_s = 13,
                                        .viscosity_Pa_s = 0.02};
  bearing::CurveErrors errors;
  errors.interpolation = 1e-3, errors.interpolation_force = 2e-4;
  errors.joint = 4e-4, errors.joint_force = 5e-4;
  errors.solver_offset_film = 3e-5;
  const bearing::FilmCurve curve(contact, {100, 400, 1600}, {3e-7, 2e-7, 1.5e-7}, {2e-7, 1.5e-7, 1e-7}, errors);
  BearingResult result;
  result.law = bearing::Law::ehd;
  result.curve = bearing::BothRaceways<bearing::FilmCurve>{curve, curve};
  const Json written = to_json(result)["curve"]["outer"];
  BOOST_TEST(written["interpolation_error"] == errors.interpolation);
  BOOST_TEST(written["joint_error"] == errors.joint);
  BOOST_TEST(written["joint_force_error"] == errors.joint_force);
  BOOST_TEST(written["force_error"] == errors.joint_force);  // the larger one
  BOOST_TEST(written["solver_error"] == errors.solver_offset_film);
}

BOOST_AUTO_TEST_SUITE_END()
