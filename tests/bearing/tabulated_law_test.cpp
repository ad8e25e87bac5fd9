// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/tabulated_law.hpp"

#include <cmath>
#include <memory>

#include "bearing/build_curve.hpp"
#include "tests/bearing/synthetic.hpp"
#include "tests/check.hpp"

namespace ehd::bearing {

using verification::Tolerance;

namespace {

CurveLaw synthetic_law() {
  const SolvableContact contacts = synthetic::contacts();
  return {std::make_shared<const FilmCurve>(std::get<FilmCurve>(build_curve(contacts, {.heaviest_N = 8000}))), 0.03};
}
double made_damping(double force_N) { return 1e5 * std::pow(force_N, -0.5) - 900; }  // negative at heavy loads

}  // namespace

BOOST_AUTO_TEST_SUITE(tabulated_law)

BOOST_AUTO_TEST_CASE(the_errors_between_the_knots_are_those_that_are_stated) {
  const CurveLaw law = synthetic_law();
  const TabulatedLaw table = tabulate(law, 20, 8000, 32, made_damping);
  BOOST_TEST(table.approach_m.size() == 32u);
  BOOST_TEST(!table.at(table.approach_m.front() - 1e-9).has_value());
  BOOST_TEST(!table.at(table.approach_m.back() + 1e-9).has_value());
  BOOST_TEST(!table.at(testing::not_a_number).has_value());
  TableErrors found{.damping = 0};
  for (double f = 20; f <= 8000; f *= 1.011) {
    const double approach = law.approach(f);
    const auto at = table.at(approach);
    BOOST_REQUIRE(at.has_value());
    found.force = std::max(found.force, error(at->force_N, f));
    found.stiffness = std::max(found.stiffness, error(at->stiffness_N_per_m, law.stiffness(approach)));
    found.film = std::max(found.film, error(at->film_minimum_m, law.curve().minimum_film(f).value));
    BOOST_TEST(std::abs(*at->damping_N_s_per_m - made_damping(f)) < 10);
  }
  const Tolerance seen = Tolerance::calibrated(1.1, "nine looks in a gap miss a tenth of a parabola's top at most");
  EHD_CHECK(found.force / table.errors.force, seen);
  EHD_CHECK(found.stiffness / table.errors.stiffness, seen);
  EHD_CHECK(found.film / table.errors.film, seen);
  EHD_CHECK(table.errors.force, Tolerance::required(1e-3, "32 knots are enough for a law known to 1e-3"));
}

// Order: twice the knots, a sixteenth of the error of the force and an eighth of that of its slope.
BOOST_AUTO_TEST_CASE(errors_fall_with_the_fourth_and_third_power_of_the_gap) {
  const CurveLaw law = synthetic_law();
  const TableErrors coarse = tabulate(law, 20, 8000, 17, {}).errors, fine = tabulate(law, 20, 8000, 33, {}).errors;
  BOOST_TEST(!coarse.damping.has_value());
  EHD_CHECK(error(std::log2(coarse.force / fine.force), 4), Tolerance::calibrated(0.25, "two grids, 16 and 32 gaps"));
  EHD_CHECK(error(std::log2(coarse.stiffness / fine.stiffness), 3), Tolerance::calibrated(0.35, "likewise"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::bearing
