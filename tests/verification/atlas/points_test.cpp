// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/atlas/points.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <set>
#include <string>

#include "tests/check.hpp"
#include "tests/verification/atlas/made_atlas.hpp"
#include "verification/atlas/atlas.hpp"

using namespace ehd;
using namespace ehd::verification;

BOOST_AUTO_TEST_SUITE(atlas_points)

using namespace made_atlas;

BOOST_AUTO_TEST_CASE(the_points_are_those_that_were_asked_for) {
  const auto points = verification::atlas_points();
  BOOST_TEST(points.size() == 351u);
  std::set<std::string> ids;
  std::set<double> M, L;
  for (const AtlasPoint& point : points) {
    ids.insert(point.id());
    M.insert(point.M);
    L.insert(point.L);
    BOOST_TEST((point.L == 0) == (point.laws == AtlasLaws::isoviscous));
    if (const auto* cut = std::get_if<TruncatedAt>(&point.inlet)) {
      BOOST_TEST(cut->x == -4);
      BOOST_TEST(point.M >= 2);
    }
    BOOST_TEST(point.usual_tolerance() <= (point.laws == AtlasLaws::barus ? 4e-7 : 4e-10));  // for 6 and 9 digits
  }
  BOOST_TEST(ids.size() == points.size());
  BOOST_TEST(*M.begin() == 0.05);
  BOOST_TEST(*M.rbegin() == 5000);
  BOOST_TEST(*L.begin() == 0);
  BOOST_TEST(*L.rbegin() == 30);
  for (const AtlasLaws laws : {AtlasLaws::barus, AtlasLaws::roelands}) {
    const auto count = [&](bool flooded) {
      return std::count_if(points.begin(), points.end(), [&](const AtlasPoint& point) {
        return point.laws == laws && std::holds_alternative<Flooded>(point.inlet) == flooded;
      });
    };
    BOOST_TEST(count(true) == 96);
    BOOST_TEST(count(false) == 66);
  }
  for (const char* id :
       {"atlas-roelands-m20-l10-flooded", "atlas-barus-m2-l2.5-cut4", "atlas-isoviscous-m0.05-l0-flooded"})
    BOOST_TEST(ids.contains(id), id);
}

BOOST_AUTO_TEST_CASE(points_above_4_GPa_are_marked_as_numerical_tests) {
  // p_H = L sqrt(M/2pi)/alpha: 0.811 GPa at (20, 10), 4.04 GPa at (500, 10)
  const AtlasPoint light{AtlasLaws::barus, 20, 10, Flooded{}}, heavy{AtlasLaws::roelands, 500, 10, Flooded{}},
      rigid{AtlasLaws::isoviscous, 5000, 0, Flooded{}};
  EHD_CHECK(error(light.hertz_pressure_Pa(), 10 * std::sqrt(20 / (2 * M_PI)) / 2.2e-8), Tolerance::round_off(8));
  BOOST_TEST(!light.numerical_test());
  BOOST_TEST(light.title().find("numerical test") == std::string::npos);
  BOOST_TEST(heavy.numerical_test() == (heavy.hertz_pressure_Pa() > 4e9));
  BOOST_TEST(heavy.numerical_test());
  BOOST_TEST(heavy.title().find("(a numerical test: p_H = 4.1 GPa)") != std::string::npos, heavy.title());
  BOOST_TEST(!rigid.numerical_test());
  const auto row = atlas_row(heavy, record_of(heavy));
  const auto column = [](const std::string& name) {
    const auto& names = atlas_columns();
    const auto at = std::find(names.begin(), names.end(), name);
    BOOST_REQUIRE(at != names.end());
    return static_cast<std::size_t>(at - names.begin());
  };
  BOOST_TEST(row[column("numerical_test")] == "yes");
  BOOST_TEST(row[column("p_H_GPa")] == "4.055");
  const auto of_rigid = atlas_row(rigid, record_of(rigid));
  BOOST_TEST(of_rigid[column("p_H_GPa")] == "");  // M alone fixes no pressure
  BOOST_TEST(of_rigid[column("P_spike")] == "");
  BOOST_TEST(of_rigid[column("X_spike")] == "");
}

BOOST_AUTO_TEST_SUITE_END()
