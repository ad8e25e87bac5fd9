// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/film_panel.hpp"

#include <cmath>

#include "tests/check.hpp"
#include "workflow/film_table_bend.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

PanelShape curved(PanelMap map) {
  return {.L_low = 2, .L_high = 15, .low = {0.1, 0.03}, .high = {0.8, -0.2, 0.07}, .map = map};
}
constexpr PanelMap maps[] = {PanelMap::even, PanelMap::root_low, PanelMap::root_high};
constexpr double places[] = {-0.8, -0.4, 0.1, 0.8};

}  // namespace

BOOST_AUTO_TEST_SUITE(film_panel)

BOOST_AUTO_TEST_CASE(a_contact_is_found_at_its_place) {
  for (const PanelMap map : maps)
    for (const double x : places)
      for (const double y : places) {
        const MoesGroups at = contact_at(curved(map), x, y);
        const PanelPlace place = place_in(curved(map), at);
        EHD_CHECK(std::abs(place.x - x), Tolerance::round_off(50, 20));
        EHD_CHECK(std::abs(place.y - y), Tolerance::round_off(50, 20));
        BOOST_TEST(holds(curved(map), at));
      }
}

BOOST_AUTO_TEST_CASE(the_edges_are_at_x_of_plus_and_minus_one) {
  for (const PanelMap map : maps)
    for (const double y : places) {
      const PanelShape panel = curved(map);
      const double low = 0.1 + 0.03 * y, high = 0.8 - 0.2 * y + 0.07 * (2 * y * y - 1);
      EHD_CHECK(error(contact_at(panel, -1, y).M, std::exp(low)), Tolerance::round_off(50, 1));
      EHD_CHECK(error(contact_at(panel, 1, y).M, std::exp(high)), Tolerance::round_off(50, 1));
      BOOST_TEST(!holds(panel, {std::exp(high) * 1.0001, contact_at(panel, 0, y).L}));
    }
  BOOST_TEST(!holds(curved(PanelMap::even), {1.5, 1.99}));
  BOOST_TEST(!holds(curved(PanelMap::even), {1.5, 15.01}));
}

BOOST_AUTO_TEST_CASE(derivatives_of_a_place_agree_with_differences) {
  constexpr double step = 1e-6;
  for (const PanelMap map : maps)
    for (const double x : places)
      for (const double y : places) {
        const PanelShape panel = curved(map);
        const MoesGroups at = contact_at(panel, x, y);
        const PanelPlace place = place_in(panel, at);
        const PanelPlace right = place_in(panel, {at.M + step, at.L}), left = place_in(panel, {at.M - step, at.L});
        const PanelPlace up = place_in(panel, {at.M, at.L + step}), down = place_in(panel, {at.M, at.L - step});
        // The third derivative at a root of 0.1 is below 1e6.
        const Tolerance small = Tolerance::asymptotic(1e6 * step * step + 1e-14 / step, "step^2, and rounding/step");
        EHD_CHECK(std::abs(place.x_by_M - (right.x - left.x) / (2 * step)), small);
        EHD_CHECK(std::abs(place.x_by_L - (up.x - down.x) / (2 * step)), small);
        EHD_CHECK(std::abs(place.y_by_L - (up.y - down.y) / (2 * step)), small);
      }
}

BOOST_AUTO_TEST_CASE(beyond_the_edge_of_a_root_a_contact_counts_as_at_the_edge) {
  for (const PanelMap map : {PanelMap::root_low, PanelMap::root_high}) {
    const bool high = map == PanelMap::root_high;
    const MoesGroups edge = contact_at(curved(map), high ? 1 : -1, 0.3);
    const PanelPlace place = place_in(curved(map), {edge.M * (high ? 1.01 : 0.99), edge.L});
    BOOST_TEST(place.x == (high ? 1 : -1));
    BOOST_TEST(std::isfinite(place.x_by_M));
    BOOST_TEST(std::isfinite(place.x_by_L));
  }
}

BOOST_AUTO_TEST_CASE(the_halves_of_a_panel_have_its_edges) {
  const PanelShape whole = curved(PanelMap::root_high);
  const auto in_L = halves({.shape = whole}, true);  // curved: in L all the same
  BOOST_REQUIRE(in_L.size() == 2u);
  BOOST_TEST(in_L[0].shape.L_high == in_L[1].shape.L_low);
  for (const PanelPlan& half : in_L)
    for (const double y : places) {
      const MoesGroups at = contact_at(half.shape, 0.4, y);
      EHD_CHECK(std::abs(place_in(whole, at).x - 0.4), Tolerance::round_off(100, 20));
    }
  const PanelShape straight{.L_low = 2, .L_high = 15, .low = {0.0}, .high = {1.0}};
  const auto in_M = halves({.shape = straight}, true);
  BOOST_TEST(in_M[0].shape.high.front() == 0.5);
  BOOST_TEST(in_M[1].shape.low.front() == 0.5);
}

BOOST_AUTO_TEST_SUITE_END()
