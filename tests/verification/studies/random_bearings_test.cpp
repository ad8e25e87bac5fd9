// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <variant>

#include "bearing/law_table.hpp"
#include "tests/check.hpp"
#include "verification/studies/bearing_check.hpp"
#include "verification/studies/random_bearing.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification {

using bearing::Equilibrium;
using bearing::Form;
using bearing::NoEquilibrium;

namespace {

const Tolerance promised = Tolerance::required(bearing::largest_balance_error, "what a balance promises");

}  // namespace

BOOST_AUTO_TEST_SUITE(studies_random_bearings)

BOOST_AUTO_TEST_CASE(the_same_seed_draws_the_same_bearing) {
  const RandomBearing one = random_bearing(17), again = random_bearing(17), other = random_bearing(18);
  BOOST_TEST(one.geometry.clearance_m == again.geometry.clearance_m);
  BOOST_TEST(one.loading.radial_N == again.loading.radial_N);
  BOOST_TEST(one.geometry.pitch_diameter_m != other.geometry.pitch_diameter_m);
}

// The ranges are reached, and kept.
BOOST_AUTO_TEST_CASE(the_ranges_are_covered) {
  int few = 0, many = 0, preloaded = 0, wide = 0, unloaded = 0, thrown = 0, symmetric = 0;
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    const auto [geometry, speeds, loading, contact] = random_bearing(seed);
    BOOST_REQUIRE((geometry.rollers >= 3 && geometry.rollers <= 400));
    BOOST_REQUIRE((geometry.clearance_m >= -20e-6 && geometry.clearance_m <= 200e-6));
    BOOST_REQUIRE(geometry.roller_diameter_m < geometry.pitch_diameter_m * std::sin(std::acos(-1) / geometry.rollers));
    BOOST_REQUIRE((std::isfinite(loading.radial_N) && loading.radial_N >= 0 && loading.centrifugal_N >= 0));
    few += geometry.rollers == 3;
    many += geometry.rollers >= 390;
    preloaded += geometry.clearance_m < -10e-6;
    wide += geometry.clearance_m > 190e-6;
    unloaded += loading.radial_N == 0;
    thrown += loading.centrifugal_N > loading.radial_N;
    symmetric += bearing::symmetric_to_load(bearing::azimuths_deg(geometry));
  }
  for (const int count : {few, many, preloaded, wide, unloaded, thrown, symmetric}) BOOST_TEST(count > 5);
}

// Invariant: every one of them has a balance by every dry law in either form, and bisection agrees.
BOOST_AUTO_TEST_CASE(random_bearings_balance_by_every_dry_law) {
  const auto dry = laws_of(bearing::Laws::dry);
  double worst = 0, worst_bisection = 0;
  int balances = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const RandomBearing drawn = random_bearing(seed);
    for (const bearing::Law law : dry)
      for (const Form form : {Form::plane, Form::radial})
        BOOST_TEST_CONTEXT("seed " << seed << ", " << to_string(law) << ", " << bearing::to_string(form)) {
          const bearing::LawPair laws = dry_laws(law, drawn.contact);
          const auto result = bearing::balance(drawn.geometry, laws, drawn.loading, form);
          const auto* refused = std::get_if<NoEquilibrium>(&result);
          BOOST_REQUIRE_MESSAGE(!refused, (refused ? refused->why : ""));
          const auto& ring = std::get<Equilibrium>(result);
          const double bisected = worst_bisection_error(drawn.geometry, laws, drawn.loading, form, ring);
          EHD_CHECK(ring.balance_error, promised);
          EHD_CHECK(bisected, promised);
          worst = std::max(worst, ring.balance_error);
          worst_bisection = std::max(worst_bisection, bisected);
          ++balances;
        }
  }
  BOOST_TEST(balances == 300 * static_cast<int>(dry.size()) * 2);
  BOOST_TEST_MESSAGE("worst balance error " << worst << ", by bisection " << worst_bisection);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::verification
