// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/force_law.hpp"

#include <cmath>
#include <stdexcept>

#include "bearing/fit.hpp"
#include "contact/approach.hpp"
#include "tests/bearing/synthetic.hpp"
#include "tests/check.hpp"

namespace ehd::bearing {

using verification::Tolerance;

namespace {

CurveLaw curve_law(double datum_m) {
  SolvedContacts contacts = synthetic::contacts();
  const auto built = build_curve(contacts, {.heaviest_N = 12e3});
  BOOST_REQUIRE(std::holds_alternative<FilmCurve>(built));
  return {std::make_shared<const FilmCurve>(std::get<FilmCurve>(built)), datum_m};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(force_law)

// Exact: the rounded constant itself, in N and mm.
BOOST_AUTO_TEST_CASE(palmgren_law_is_its_printed_constant) {
  const double expected = 8.06e4 * std::pow(30.0, 8.0 / 9.0) * std::pow(0.010, 10.0 / 9.0);
  EHD_CHECK(error(palmgren_law(0.030).force(10e-6), expected), Tolerance::round_off(50));
}

// Exact: two contacts of the `iso` law in series are c_L = 35948 l^(8/9).
BOOST_AUTO_TEST_CASE(two_iso_contacts_in_series_are_the_iso_constant) {
  const double total_mm = 0.013;
  const double expected = 35948 * std::pow(13.6, 8.0 / 9.0) * std::pow(total_mm, 10.0 / 9.0);
  EHD_CHECK(error(iso_law(0.0136).force(1e-3 * total_mm / 2), expected), Tolerance::round_off(50));
}

// Invariant: inverse and slopes of every law.
BOOST_AUTO_TEST_CASE(force_and_approach_are_inverse_and_their_slopes_fit) {
  for (const ForceLaw& law :
       {ForceLaw{palmgren_law(0.05)}, ForceLaw{LinearLaw{.K_N_per_m = 2.9e9, .dF_N = 900}}, ForceLaw{curve_law(0.02)}})
    for (const double f : {3.7, 61.0, 940.0, 7300.0}) {
      const double delta = approach(law, f);
      EHD_CHECK(error(force(law, delta), f), Tolerance::round_off(100, 20));
      EHD_CHECK(error(stiffness(law, delta) * compliance(law, f), 1), Tolerance::round_off(100, 20));
      const double step = 1e-4 * f;
      const double slope = (approach(law, f + step) - approach(law, f - step)) / (2 * step);
      EHD_CHECK(error(compliance(law, f), slope), Tolerance::discretisation(1e-8, 10));  // (step/f)^2
    }
}

// Exact: the default datum meets the `hertz` law at its load.
BOOST_AUTO_TEST_CASE(the_palmgren_datum_meets_the_law_at_its_load) {
  const RacewayContact contact = synthetic::contact();
  const PowerLaw law = palmgren_law(contact.length_m);
  const Conditions conditions = contact.at(9300);
  const double datum = datum_from_dry_approach_m(conditions, law.approach(9300));
  EHD_CHECK(error(dry_approach_m(conditions, datum), law.approach(9300)), Tolerance::round_off(20));
}

BOOST_AUTO_TEST_CASE(a_datum_shorter_than_the_contact_is_refused) {
  SolvedContacts contacts = synthetic::contacts();
  const auto built = build_curve(contacts, {.heaviest_N = 12e3});
  const auto curve = std::make_shared<const FilmCurve>(std::get<FilmCurve>(built));
  BOOST_CHECK_THROW(CurveLaw(curve, 1e-6), std::domain_error);
}

// Exact: a line through points of a line, and the covariance of a known disturbance.
BOOST_AUTO_TEST_CASE(least_squares_recovers_a_line) {
  std::vector<FitPoint> points;
  for (int k = 0; k < 6; ++k) {
    const double f = 2000 + 2000 * k;
    points.push_back({f, (f - 1148) / 3.13e9});
  }
  const LinearFit fit = fit_line(points);
  EHD_CHECK(error(fit.K_N_per_m, 3.13e9), Tolerance::round_off(100));
  EHD_CHECK(error(fit.dF_N, 1148), Tolerance::round_off(100, 12));
  EHD_CHECK(fit.residual_N / 12000, Tolerance::round_off(100));
  const std::vector<double> disturbance = {30, -20, 10, -40, 25, -5};
  for (std::size_t k = 0; k < 6; ++k) points[k].force_N += disturbance[k];
  const LinearFit disturbed = fit_line(points);
  // The textbook formulas, written out.
  double mean = 0, squares = 0, residuals = 0, largest = 0;
  for (const FitPoint& point : points) mean += point.approach_m / 6;
  for (const FitPoint& point : points) {
    squares += std::pow(point.approach_m - mean, 2);
    const double left = point.force_N - disturbed.K_N_per_m * point.approach_m - disturbed.dF_N;
    residuals += left * left;
    largest = std::max(largest, std::abs(left));
  }
  EHD_CHECK(error(disturbed.residual_N, largest), Tolerance::round_off(100, 100));
  EHD_CHECK(error(disturbed.standard_deviation_N, std::sqrt(residuals / 4)), Tolerance::round_off(100, 100));
  EHD_CHECK(error(disturbed.K_deviation_N_per_m, std::sqrt(residuals / 4 / squares)), Tolerance::round_off(100, 100));
}

BOOST_AUTO_TEST_CASE(points_without_a_rising_line_are_refused) {
  BOOST_CHECK_THROW((void)fit_line({{100, 1e-6}}), std::invalid_argument);
  BOOST_CHECK_THROW((void)fit_line({{100, 1e-6}, {50, 2e-6}}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::bearing
