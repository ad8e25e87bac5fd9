// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/bearing_check.hpp"

#include <cmath>
#include <utility>
#include <variant>

#include "tests/check.hpp"

namespace ehd::verification {

using bearing::Equilibrium;
using bearing::Form;

namespace {

struct Balanced {
  bearing::Geometry geometry;
  bearing::LawPair laws;
  bearing::Loading loading;
  Equilibrium ring;
};

/// Room, an asymmetric cage and thrown rollers: five rollers carry.
Balanced balanced(Form form) {
  const bearing::Geometry geometry{.rollers = 13,
                                   .pitch_diameter_m = 0.071,
                                   .roller_diameter_m = 0.009,
                                   .length_m = 0.013,
                                   .clearance_m = 12e-6,
                                   .density_kg_per_m3 = 7800,
                                   .first_azimuth_deg = 4.7};
  const bearing::LawPair laws{bearing::palmgren_law(0.013), bearing::iso_law(0.013)};
  const bearing::Loading loading{.radial_N = 6.1e3, .centrifugal_N = 77};
  const auto result = bearing::balance(geometry, laws, loading, form);
  BOOST_REQUIRE(std::holds_alternative<Equilibrium>(result));
  return {geometry, laws, loading, std::get<Equilibrium>(result)};
}

double error_of(const Balanced& one, Form form) {
  return worst_bisection_error(one.geometry, one.laws, one.loading, form, one.ring);
}

const Tolerance promised = Tolerance::required(bearing::largest_balance_error, "what a balance promises");

}  // namespace

BOOST_AUTO_TEST_SUITE(studies_bearing_check)

// A check that cannot fail is none: what is broken by 1e-9 is seen as that.
BOOST_AUTO_TEST_CASE(a_broken_equilibrium_is_seen) {
  for (const Form form : {Form::plane, Form::radial}) {
    const Balanced whole = balanced(form);
    EHD_CHECK(error_of(whole, form), promised);
    const auto after = [&](auto&& breaks) {
      Balanced broken = whole;
      breaks(broken);
      return error_of(broken, form);
    };
    const double part = 1e-9;
    BOOST_TEST(after([&](Balanced& b) { b.ring.rollers[0].inner.force_N *= 1 + part; }) > part / 20);
    BOOST_TEST(after([&](Balanced& b) { b.ring.rollers[6].outer.force_N += part * 6e3; }) > part / 20);
    BOOST_TEST(after([&](Balanced& b) { b.ring.position.beyond_x_m *= 1 + part; }) > part / 20);
    BOOST_TEST(after([&](Balanced& b) { b.ring.displacement_m *= 1 + part; }) > part / 20);
    BOOST_TEST(after([&](Balanced& b) { b.loading.radial_N *= 1 + part; }) > part / 20);
    BOOST_TEST(after([&](Balanced& b) { b.loading.centrifugal_N *= 1 + part; }) > part / 1e3);
    BOOST_TEST(after([&](Balanced& b) { std::swap(b.ring.rollers[0], b.ring.rollers[1]); }) > 1e-3);
    BOOST_TEST(after([&](Balanced& b) { b.geometry.clearance_m = -b.geometry.clearance_m; }) > 1e-3);
    BOOST_TEST(std::isnan(after([&](Balanced& b) { b.geometry.first_azimuth_deg += 1e-6; })));
    BOOST_TEST(std::isnan(after([&](Balanced& b) { b.ring.rollers.pop_back(); })));
  }
  // The radial form leaves a force across, which is no balance in the plane.
  BOOST_TEST(error_of(balanced(Form::radial), Form::plane) > 1e-6);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::verification
