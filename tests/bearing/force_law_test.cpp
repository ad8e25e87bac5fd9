// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/force_law.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "bearing/build_curve.hpp"
#include "bearing/fit.hpp"
#include "bearing/law_table.hpp"
#include "contact/approach.hpp"
#include "contact/hertz.hpp"
#include "tests/bearing/synthetic.hpp"
#include "tests/check.hpp"

namespace ehd::bearing {

using synthetic::roller;
using verification::Tolerance;

namespace {

struct NamedLaw {
  std::string name;
  ForceLaw law;
};
/// Every dry law of the table, at both raceways.
std::vector<NamedLaw> every_dry_law() {
  std::vector<NamedLaw> laws;
  for (const Law law : laws_of(Laws::dry)) {
    const LawPair pair = dry_laws(law, roller());
    laws.push_back({std::string(to_string(law)) + ", inner", pair.inner});
    laws.push_back({std::string(to_string(law)) + ", outer", pair.outer});
  }
  return laws;
}

/// Int d(delta)/df df by Gauss' rule of three points: to (by/from)^6.
double integral_of_compliance(const ForceLaw& law, double from_N, double by_N) {
  constexpr double node = 0.7745966692414834;
  const auto at = [&](double x) { return compliance(law, from_N + by_N * (1 + x) / 2); };
  return by_N * (5 * at(-node) + 8 * at(0) + 5 * at(node)) / 18;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(force_law)

// Printed approaches and slopes are judged by the claims approach/*, bearing/datum/* and bearing/laws/*/slopes
// (verification/claims).

// Exact: a law is the printed approach.
BOOST_AUTO_TEST_CASE(the_laws_are_the_printed_approaches) {
  for (const double f : {0.31, 47.0, 8900.0, 61e3}) {
    RollerContact contact = roller();
    contact.force_N = f;
    for (const Raceway raceway : both_raceways) {
      EHD_CHECK(error(approach(lundberg_law(roller(), raceway), f), lundberg_approach_m(contact, raceway)),
                Tolerance::round_off(4));
      EHD_CHECK(error(approach(tripp_law(roller(), raceway), f), tripp_approach_m(contact, raceway)),
                Tolerance::round_off(4));
      // A power of a power: the exponents' rounding times ln(f/coefficient), some 30.
      EHD_CHECK(error(approach(houpert_law(roller(), raceway), f), houpert_approach_m(contact, raceway)),
                Tolerance::round_off(4, 30));
    }
  }
}

// Exact: Lundberg's formula is the log kernel with x_0 = l.
BOOST_AUTO_TEST_CASE(lundberg_is_the_dry_approach_with_the_length_as_datum) {
  RollerContact contact = roller();
  contact.force_N = 9100;
  const Geometry geometry{
      .rollers = 1, .pitch_diameter_m = contact.pitch_diameter_m, .roller_diameter_m = contact.roller_diameter_m};
  for (const Raceway raceway : both_raceways) {
    const Conditions conditions{.load_N_per_m = contact.force_N / contact.length_m,
                                .reduced_radius_m = reduced_radius_m(geometry, raceway),
                                .reduced_modulus_Pa = reduced_modulus_Pa(contact.modulus_Pa, contact.poisson)};
    EHD_CHECK(error(dry_approach_m(conditions, contact.length_m), lundberg_approach_m(contact, raceway)),
              Tolerance::round_off(50));
  }
}

// Invariant: over eleven decades of force, force(approach(f)) = f and both slopes are reciprocal, to rounding.
BOOST_AUTO_TEST_CASE(dry_laws_are_inverse_to_rounding) {
  for (const auto& [name, law] : every_dry_law()) {
    BOOST_TEST_CONTEXT(name) {
      // A logarithmic law is good to an ulp or two, times L/(L - 1) < 1.4; a power to its exponent's rounding times
      // ln(f/coefficient), below 50 here.
      const bool logarithmic = std::holds_alternative<LogarithmicLaw>(law);
      const Tolerance ulps = logarithmic ? Tolerance::round_off(6) : Tolerance::round_off(2, 50);
      for (double f = 1e-6; f < 9e4; f *= 3.7) {
        const double delta = approach(law, f);
        EHD_CHECK(error(force(law, delta), f), ulps);
        EHD_CHECK(error(stiffness(law, delta) * compliance(law, f), 1), Tolerance::round_off(10, 10));
      }
      BOOST_TEST(force(law, 0) == 0);
      BOOST_TEST(force(law, -1e-6) == 0);
      BOOST_TEST(stiffness(law, -1e-6) == 0);
      BOOST_TEST(approach(law, 0) == 0);
      EHD_CHECK(error(force(law, approach(law, 1e-250)), 1e-250), Tolerance::round_off(2, 700));  // ln 1e-300
    }
  }
}

// Invariant: what a force adds to the approach is the integral of the compliance, however little it adds.
BOOST_AUTO_TEST_CASE(a_small_rise_of_the_approach_keeps_its_digits) {
  auto laws = every_dry_law();
  laws.push_back({"ehd-linear", LinearLaw{.K_N_per_m = 2.9e9, .dF_N = 900}});
  for (const auto& [name, law] : laws)
    for (const double from : {0.7, 320.0, 71e3})
      for (const double part : {1e-3, 1e-7, 1e-12, 1e-17})
        BOOST_TEST_CONTEXT(name << " from " << from << " N by " << part) {
          EHD_CHECK(error(rise(law, from, part * from), integral_of_compliance(law, from, part * from)),
                    Tolerance::round_off(10) + Tolerance::asymptotic(1e-18, "Gauss' rule, (by/from)^6"));
        }
  for (const auto& [name, law] : laws) {
    EHD_CHECK(error(rise(law, 0, 55), approach(law, 55) - begins_at(law)), Tolerance::round_off(10));
    EHD_CHECK(error(rise(law, 20, 3000), approach(law, 3020) - approach(law, 20)), Tolerance::round_off(10));
  }
}

// Exact: the line that is cut at delta = 0 carries dF there, and nothing moves below it.
BOOST_AUTO_TEST_CASE(a_cut_line_rises_above_its_jump_only) {
  const LinearLaw cut{.K_N_per_m = 3e9, .dF_N = 900, .unloading = Unloading::at_zero_approach, .fitted_N = {}};
  BOOST_TEST(cut.rise(0, 700) == 0);
  EHD_CHECK(error(cut.rise(0, 1200), 1e-7), Tolerance::round_off(4));
  EHD_CHECK(error(cut.rise(850, 350), 1e-7), Tolerance::round_off(4));
  EHD_CHECK(error(cut.rise(1000, 300), 1e-7), Tolerance::round_off(4));
}

// Exact: a logarithmic law is stated while b is below an eighth of the length in its logarithm, and goes on straight.
BOOST_AUTO_TEST_CASE(logarithmic_laws_end_where_the_contact_is_no_longer_narrow) {
  const ForceLaw law = lundberg_law(roller(), Raceway::outer);
  BOOST_REQUIRE(domain(law).has_value());
  const double heaviest = domain(law)->second;
  const RacewayContact contact{
      .length_m = roller().length_m,
      .reduced_radius_m =
          reduced_radius_m({.rollers = 1, .pitch_diameter_m = 0.087, .roller_diameter_m = 0.013}, Raceway::outer),
      .reduced_modulus_Pa = reduced_modulus_Pa(2.07e11, 0.29)};
  const double length = 2 * std::exp(0.5) * roller().length_m;  // ln(4 e l^2/b^2)
  EHD_CHECK(error(hertz::half_width_m(contact.at(heaviest)), length / 8), Tolerance::round_off(20));
  const double end = approach(law, heaviest), step = 0.1 * end;
  EHD_CHECK(error(approach(law, 2 * heaviest) - end, compliance(law, heaviest) * heaviest), Tolerance::round_off(20));
  EHD_CHECK(error(approach(law, force(law, end + step)), end + step), Tolerance::round_off(20));
  EHD_CHECK(error(rise(law, 0.9 * heaviest, heaviest), approach(law, 1.9 * heaviest) - approach(law, 0.9 * heaviest)),
            Tolerance::round_off(20));
}

// Exact: a rise over the end of the domain is the sum of both sides, however the remainder below the end rounds.
BOOST_AUTO_TEST_CASE(a_rise_over_the_end_of_a_logarithm_ends) {
  int rounds_up = 0;
  for (int m = 0; m < 50; ++m) {
    RollerContact contact = roller();
    contact.length_m = 0.02 + 1e-4 * m;
    const LogarithmicLaw law = lundberg_law(contact, Raceway::outer);
    const double heaviest = law.heaviest_N();
    for (int k = 1; k < 100; ++k) {
      const double from = heaviest * k / 100;
      rounds_up += from + (heaviest - from) > heaviest;
      EHD_CHECK(error(law.rise(from, heaviest), law.approach(from + heaviest) - law.approach(from)),
                Tolerance::round_off(10));
    }
  }
  BOOST_TEST(rounds_up > 10);
}

// Exact: two contacts of the `iso` law in series are c_L = 35948 l^(8/9).
BOOST_AUTO_TEST_CASE(two_iso_contacts_in_series_are_the_iso_constant) {
  const double total_mm = 0.013;
  const double expected = 35948 * std::pow(13.6, 8.0 / 9.0) * std::pow(total_mm, 10.0 / 9.0);
  EHD_CHECK(error(iso_law(0.0136).force(1e-3 * total_mm / 2), expected), Tolerance::round_off(50));
}

BOOST_AUTO_TEST_CASE(a_datum_shorter_than_the_contact_is_refused) {
  const SolvableContact contacts = synthetic::contacts();
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

// Exact: the line of delta on f is the textbook's with the axes exchanged. Its product of slopes with the line of f on
// delta is the squared correlation of the points, so that it is the steeper one.
BOOST_AUTO_TEST_CASE(a_fit_of_the_approach_exchanges_the_axes) {
  std::vector<FitPoint> points, exchanged;
  for (const double f : {500.0, 1700.0, 2900.0, 5300.0, 9100.0}) {
    points.push_back({.force_N = f, .approach_m = 1e-9 * std::pow(f, 0.7)});
    exchanged.push_back({.force_N = 1e-9 * std::pow(f, 0.7), .approach_m = f});
  }
  const LinearFit fit = fit_line(points, FitOf::approach), of_force = fit_line(points), axes = fit_line(exchanged);
  EHD_CHECK(error(fit.K_N_per_m, 1 / axes.K_N_per_m), Tolerance::round_off(10));
  EHD_CHECK(error(fit.dF_N, -axes.dF_N / axes.K_N_per_m), Tolerance::round_off(10));
  EHD_CHECK(error(fit.standard_deviation_N, axes.standard_deviation_N / axes.K_N_per_m), Tolerance::round_off(10));
  EHD_CHECK(error(fit.K_deviation_N_per_m / fit.K_N_per_m, axes.K_deviation_N_per_m / axes.K_N_per_m),
            Tolerance::round_off(10));
  // Constants at the centre of the points do not correlate with slopes: there both fits pass, and the deviations of dF
  // and K are those of one straight line.
  double mean_m = 0;
  for (const FitPoint& point : points) mean_m += point.approach_m / 5;
  const double at_centre = std::pow(fit.dF_deviation_N, 2) + std::pow(mean_m * fit.K_deviation_N_per_m, 2) +
                           2 * mean_m * fit.correlation * fit.dF_deviation_N * fit.K_deviation_N_per_m;
  EHD_CHECK(error(std::sqrt(at_centre), fit.standard_deviation_N / std::sqrt(5.0)), Tolerance::round_off(1000, 10));
  BOOST_TEST(fit.K_N_per_m > of_force.K_N_per_m);
}

// Derivative: the bound of an approach on the line is the sum of what each point's error moves it by, by differences.
BOOST_AUTO_TEST_CASE(the_error_of_a_line_is_that_of_its_points) {
  std::vector<FitPoint> points;  // far from a line, so that every term counts
  for (const double f : {500.0, 1700.0, 2900.0, 5300.0, 9100.0})
    points.push_back(
        {.force_N = f, .approach_m = 1e-9 * std::pow(f, 0.7), .approach_error_m = 1e-10 * std::sqrt(f / 100)});
  double mean_N = 0, mean_error_m = 0;
  for (const FitPoint& point : points) {
    mean_N += point.force_N / 5;
    mean_error_m += point.approach_error_m / 5;
  }
  const auto approach = [](const LinearFit& line, double f) { return (f - line.dF_N) / line.K_N_per_m; };
  for (const FitOf of : {FitOf::force, FitOf::approach}) {
    const LinearFit fit = fit_line(points, of);
    for (const double f : {0.0, 500.0, 3000.0, 20000.0}) {
      double sum_m = 0;
      for (std::size_t k = 0; k < points.size(); ++k) {
        constexpr double step = 1e-4;  // of the error: central differences are then exact to 1e-8 and rounding
        auto up = points, down = points;
        up[k].approach_m += step * points[k].approach_error_m;
        down[k].approach_m -= step * points[k].approach_error_m;
        sum_m += std::abs(approach(fit_line(up, of), f) - approach(fit_line(down, of), f)) / (2 * step);
      }
      EHD_CHECK(error(fit.approach_error_m(f), sum_m), Tolerance::round_off(100, 1e6));
    }
    // The mean of the approaches moves with all of them alike: at the points' centre nothing else counts.
    EHD_CHECK(error(fit.approach_error_m(mean_N), mean_error_m), Tolerance::round_off(100, 10));
  }
}

BOOST_AUTO_TEST_CASE(points_without_a_rising_line_are_refused) {
  BOOST_CHECK_THROW((void)fit_line({{100, 1e-6}}), std::invalid_argument);
  BOOST_CHECK_THROW((void)fit_line({{100, 1e-6}, {50, 2e-6}}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::bearing
