// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/film_curve.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "bearing/build_curve.hpp"
#include "bearing/fit.hpp"
#include "bearing/force_law.hpp"
#include "contact/approach.hpp"
#include "tests/bearing/synthetic.hpp"
#include "tests/check.hpp"

namespace ehd::bearing {

using verification::Tolerance;

namespace {

constexpr double bound = 1e-3;

FilmCurve built(const SolvableContact& contacts) {
  auto curve = build_curve(contacts, {.heaviest_N = 12e3, .force_bound = bound, .film_bound = bound});
  const auto* failure = std::get_if<SolveFailure>(&curve);
  BOOST_REQUIRE_MESSAGE(!failure, (failure ? failure->why : ""));
  return std::get<FilmCurve>(curve);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(film_curve)

// Exact: Martin's constants by quadrature of his pressure, p ~ Int (h - h_c)/h^3, x = sqrt(2 R h_0) tan g.
BOOST_AUTO_TEST_CASE(martin_constants_by_quadrature) {
  const double exit_tangent = 0.4751299200930562, gc = std::atan(exit_tangent), sharp = 1 / std::pow(std::cos(gc), 2);
  const auto primitive = [&](double g) {
    return g / 2 + std::sin(2 * g) / 4 - sharp * (3 * g / 8 + std::sin(2 * g) / 4 + std::sin(4 * g) / 32);
  };
  const double from = -std::acos(-1) / 2;
  constexpr int cells = 200000;
  const double width = (gc - from) / cells;
  double weight = 0, logarithm = 0;
  for (int k = 0; k < cells; ++k) {
    const double g = from + (k + 0.5) * width;
    const double p = (primitive(g) - primitive(from)) / std::pow(std::cos(g), 2) * width;
    weight += p;
    logarithm += p * std::log(std::abs(std::tan(g)));
  }
  const RacewayContact contact = synthetic::contact();
  const double force_N = 3.0, b = hertz::half_width_m(contact.at(force_N)), R = contact.reduced_radius_m;
  const double film = martin_film(contact, force_N).value;
  const double midpoint = 1e-8;  // (width)^2, and |log| at one cell about g = 0
  EHD_CHECK(
      error(film * force_N / (contact.viscosity_Pa_s * contact.speed_sum_m_per_s * R * contact.length_m), 12 * weight),
      Tolerance::discretisation(midpoint, 10));
  const double deformation = b * b / (2 * R);
  const double mean = (martin_offset_film(contact, force_N).value - film) / deformation + 2 * hertz::dry_offset() -
                      std::log(std::sqrt(2 * R * film) / b);
  EHD_CHECK(error(mean, logarithm / weight), Tolerance::discretisation(1e-5, 1));  // integrable singularity at g = 0
}

// Invariant: the offset film is the dry approach minus the approach with a film, for every datum.
BOOST_AUTO_TEST_CASE(the_offset_film_does_not_depend_on_the_datum) {
  const RacewayContact contact = synthetic::contact();
  const double force_N = 4200;
  const SolvedContact solved = synthetic::solve(force_N);
  for (const double datum_m : {0.002, 0.05, 3.0}) {
    const Conditions conditions = contact.at(force_N);
    EHD_CHECK(error(dry_approach_m(conditions, datum_m) - approach_m(conditions, solved.offset, datum_m),
                    offset_film_m(contact, force_N, solved)),
              Tolerance::round_off(100, 20));
  }
}

// Agreement: a synthetic relation is recovered within the bound, between points and below the lightest.
BOOST_AUTO_TEST_CASE(a_known_relation_is_recovered_within_the_bound) {
  const SolvableContact contacts = synthetic::contacts();
  const FilmCurve curve = built(contacts);
  BOOST_TEST_MESSAGE(curve.forces_N().size()
                     << " points from " << curve.lightest_N() << " N, interpolation error "
                     << curve.errors().interpolation << ", joint error " << curve.errors().joint);
  EHD_CHECK(curve.errors().interpolation_force, Tolerance::required(bound, "the bound of the request"));
  BOOST_TEST(curve.errors().lightest_because.find("the rigid-roller formula is used") != std::string::npos);
  EHD_CHECK(curve.errors().joint_force, Tolerance::required(bound, "the bound of the request"));
  double inside = 0, below = 0;
  for (double f = 1e-2 * curve.lightest_N(); f <= curve.heaviest_N(); f *= 1.07) {
    // The force at the true approach, by the curve's own law; datum x_0 = l.
    const double datum_m = curve.contact().length_m;
    const CurveLaw law(std::make_shared<const FilmCurve>(curve), datum_m);
    const double approach_m = dry_approach_m(curve.contact().at(f), datum_m) - synthetic::offset_film_m(f);
    const double wrong = std::max(std::abs(law.force(approach_m) / f - 1),
                                  std::abs(std::log(curve.minimum_film(f).value / synthetic::minimum_film_m(f))));
    double& worst = f < curve.lightest_N() ? below : inside;
    worst = std::max(worst, wrong);
  }
  BOOST_TEST_MESSAGE("true error between points " << inside << ", below the lightest " << below);
  EHD_CHECK(inside, Tolerance::required(bound, "the bound of the request"));
  EHD_CHECK(below, Tolerance::required(bound, "the bound of the request"));
}

// Agreement: the compliance of the curve is that of the synthetic relation within its stated error, at every load.
BOOST_AUTO_TEST_CASE(the_stated_error_of_the_compliance_covers_a_known_relation) {
  const FilmCurve curve = built(synthetic::contacts());
  const RacewayContact contact = synthetic::contact();
  const auto approach_m = [&](double f) {
    return dry_approach_m(contact.at(f), contact.length_m) - synthetic::offset_film_m(f);
  };
  double worst = 0, smallest_stated = 1, largest_stated = 0;
  for (double f = 0.05 * curve.lightest_N(); f <= curve.heaviest_N(); f *= 1.07) {
    constexpr double step = 1e-4;
    const double truth_m = (approach_m(f * (1 + step)) - approach_m(f * (1 - step))) / (2 * step);
    const double stated = curve.compliance_error(f);
    worst = std::max(worst, std::abs(curve.rise_m(f) / truth_m - 1) / stated);
    smallest_stated = std::min(smallest_stated, stated);
    largest_stated = std::max(largest_stated, stated);
  }
  BOOST_TEST_MESSAGE("largest error over stated error " << worst << ", stated " << smallest_stated << " to "
                                                        << largest_stated);
  EHD_CHECK(worst, Tolerance::stated());
  BOOST_TEST(worst > 0.02);  // and says something
}

// Between points a factor of two apart the stated error is the slope of an error that is known, and not much more.
BOOST_AUTO_TEST_CASE(the_error_of_the_compliance_is_the_slope_of_the_interpolation_error) {
  const RacewayContact contact = synthetic::contact();
  std::vector<double> forces, offsets, films;
  for (double f = 50; f < 2000; f *= 2) {
    forces.push_back(f);
    offsets.push_back(synthetic::offset_film_m(f));
    films.push_back(synthetic::minimum_film_m(f));
  }
  const FilmCurve plain(contact, forces, offsets, films);
  double of_film = 0, of_force = 0;
  for (double f = forces[0]; f < forces.back(); f *= 1.01) {
    const double off_m = plain.offset_film(f).value - synthetic::offset_film_m(f);
    of_film = std::max(of_film, std::abs(off_m) / synthetic::offset_film_m(f));
    of_force = std::max(of_force, std::abs(off_m) / plain.rise_m(f));
  }
  CurveErrors errors;
  errors.interpolation = of_film, errors.interpolation_force = of_force;
  const FilmCurve curve(contact, forces, offsets, films, errors);
  double worst = 0;
  for (double f = forces[0]; f < forces.back(); f *= 1.01) {
    constexpr double step = 1e-4;
    const double slope_m =
        (synthetic::offset_film_m(f * (1 + step)) - synthetic::offset_film_m(f * (1 - step))) / (2 * step);
    const double wrong_m = std::abs(f * curve.offset_film(f).slope - slope_m);
    worst = std::max(worst, wrong_m / curve.rise_m(f) / curve.compliance_error(f));
  }
  EHD_CHECK(worst, Tolerance::stated());
  BOOST_TEST(worst > 0.4, "the bar is " << 1 / worst << " times the error");
}

// Invariant: the stated error below the lightest point covers contacts that the curve has not seen. One contact is
// solved there, at half the lightest load, where the error of some of these relations happens to vanish.
BOOST_AUTO_TEST_CASE(the_error_stated_below_the_joint_covers_every_contact_there) {
  int judged = 0;
  double worst = 0;
  for (double knee_N = 150; knee_N < 600; knee_N *= 1.1)
    for (double bump = -2; bump < 2; bump += 0.1) {
      const auto films_m = [&](double force_N) {
        const double at_N = synthetic::knee_N / knee_N * force_N, x = std::pow(force_N / knee_N, 1.5);
        const double rigid = martin_film(synthetic::contact(), force_N).value;
        const double deformation = martin_offset_film(synthetic::contact(), force_N).value - rigid;
        const double offset =
            rigid * synthetic::enhancement(at_N, 0.58) + deformation / synthetic::enhancement(at_N, 4);
        return std::pair{offset * std::exp(bump * std::pow(x / (1 + x), 2)),
                         rigid * synthetic::enhancement(at_N, 0.56)};
      };
      const SolvableContact contacts{synthetic::contact(), [&](double load_N_per_m) -> ContactResult {
                                       const double force_N = load_N_per_m * synthetic::contact().length_m;
                                       return synthetic::solved(force_N, films_m(force_N).first,
                                                                films_m(force_N).second);
                                     }};
      const FilmCurve curve = built(contacts);
      for (double share = 0.97; share > 0.02; share *= 0.9) {
        const double f = share * curve.lightest_N(), off_m = curve.offset_film(f).value - films_m(f).first;
        const double film_error = std::max(std::abs(std::log1p(off_m / films_m(f).first)),
                                           std::abs(std::log(curve.minimum_film(f).value / films_m(f).second)));
        worst = std::max(
            {worst, film_error / curve.errors().joint, std::abs(off_m) / curve.rise_m(f) / curve.errors().joint_force});
        ++judged;
      }
    }
  BOOST_TEST(judged > 1000);
  BOOST_TEST_MESSAGE("true error over stated error, at most " << worst << ", at " << judged << " contacts");
  EHD_CHECK(worst, Tolerance::required(1, "a stated error covers the true one"));
}

// Invariant: value and slope are continuous where the rigid limit takes over, and the film falls all the way.
BOOST_AUTO_TEST_CASE(the_rigid_limit_joins_with_value_and_slope) {
  const SolvableContact contacts = synthetic::contacts();
  const FilmCurve curve = built(contacts);
  const double at = curve.lightest_N(), just_below = at * (1 - 1e-12);
  EHD_CHECK(error(curve.offset_film(just_below).value, curve.offset_film(at).value), Tolerance::round_off(1e5));
  EHD_CHECK(error(curve.offset_film(just_below).slope, curve.offset_film(at).slope),
            Tolerance::discretisation(1e-8, 10));  // the rigid slope is a central difference of step 1e-4
  EHD_CHECK(error(curve.minimum_film(just_below).slope, curve.minimum_film(at).slope),
            Tolerance::discretisation(1e-8, 10));
  double before = std::numeric_limits<double>::infinity();
  for (double f = 1e-4 * at; f < curve.heaviest_N(); f *= 1.01) {
    const double film = curve.offset_film(f).value;
    BOOST_REQUIRE(film < before);
    before = film;
  }
}

// Exact: as the load vanishes the approach is minus Martin's film.
BOOST_AUTO_TEST_CASE(the_lightest_contact_is_held_apart_by_martins_film) {
  const SolvableContact contacts = synthetic::contacts();
  const FilmCurve curve = built(contacts);
  const double f = 1e-5 * curve.lightest_N();
  const double approach_m = dry_approach_m(curve.contact().at(f), 0.02) - curve.offset_film(f).value;
  EHD_CHECK(error(approach_m, -martin_film(curve.contact(), f).value),
            Tolerance::asymptotic(1e-5, "remainder of the order of the load ratio to the lightest solved one"));
}

// Counter: a curve solves its points and one more contact; a fit solves its points.
BOOST_AUTO_TEST_CASE(a_curve_and_a_fit_solve_what_they_need) {
  std::set<double> loads;
  const SolvableContact contacts{synthetic::contact(), [&loads](double load_N_per_m) -> ContactResult {
                                   loads.insert(load_N_per_m);
                                   return synthetic::solve(load_N_per_m * synthetic::contact().length_m);
                                 }};
  const FilmCurve curve = built(contacts);
  const std::size_t solved = loads.size();
  BOOST_TEST(solved == curve.forces_N().size() + 1);  // one below, that judges the rigid limit
  BOOST_REQUIRE(std::holds_alternative<LinearFit>(fit_contacts(contacts, 0.02, 2000, 12000, 6)));
  BOOST_TEST(loads.size() == solved + 6);
}

// Agreement: forces that a fit solves in any case serve as points and checks, and the curve is as good with few others.
BOOST_AUTO_TEST_CASE(given_forces_serve_as_points) {
  const SolvableContact contacts = synthetic::contacts();
  const std::vector<double> given = fit_forces_N(2000, 12000, 6);
  const auto curve = build_curve(contacts, {.heaviest_N = 11e3, .given_N = given});
  BOOST_REQUIRE(std::holds_alternative<FilmCurve>(curve));
  const FilmCurve& shared = std::get<FilmCurve>(curve);
  BOOST_TEST(shared.heaviest_N() == 12000);
  long own = 0;
  for (const double f : shared.forces_N()) own += std::find(given.begin(), given.end(), f) == given.end();
  BOOST_TEST(static_cast<long>(shared.forces_N().size()) - own >= 3);
  for (const double f : {3000.0, 5100.0, 11900.0, 700.0})
    EHD_CHECK(std::log(shared.minimum_film(f).value / synthetic::minimum_film_m(f)),
              Tolerance::required(1e-3, "the curve's own bound"));
  // Beyond the given forces the curve goes on to a power of two; far too heavy ones are not solved.
  BOOST_TEST(as_met({.heaviest_N = 13e3, .given_N = given}).heaviest_N == 16384);
  BOOST_TEST(as_met({.heaviest_N = 300, .given_N = {100, 1e6}}).given_N.empty());
}

// Exact: a cubic in the logarithms is its own spline, ends included.
BOOST_AUTO_TEST_CASE(a_cubic_of_the_logarithms_is_reproduced) {
  const auto film = [](double f) {
    const double s = std::log(f);
    return 1e-6 * std::exp(-0.2 * s + 0.01 * s * s - 4e-4 * s * s * s);
  };
  std::vector<double> forces{3, 11, 40, 300, 900, 2000}, films;
  for (const double f : forces) films.push_back(film(f));
  const FilmCurve curve(synthetic::contact(), forces, films, films);
  for (const double f : {3.5, 20.0, 100.0, 1500.0, 1999.0}) {
    EHD_CHECK(error(curve.offset_film(f).value, film(f)), Tolerance::round_off(200));
    const double s = std::log(f), slope = film(f) / f * (-0.2 + 0.02 * s - 1.2e-3 * s * s);
    EHD_CHECK(error(curve.offset_film(f).slope, slope), Tolerance::round_off(2000));
  }
}

// Invariant: films that fall from point to point fall between them, however sharp the bend.
BOOST_AUTO_TEST_CASE(a_sharp_bend_does_not_overshoot) {
  const std::vector<double> forces{1, 2, 4, 8, 16, 32, 64};
  const std::vector<double> films{64, 32, 16, 8, 7.999, 7.998, 7.9};
  const FilmCurve curve(synthetic::contact(), forces, films, films);
  for (double f = 1; f < 63; f *= 1.01) BOOST_REQUIRE(curve.offset_film(f * 1.01).value <= curve.offset_film(f).value);
}

// More points where the curve bends: the knee is at 180 N, the straight ends are far from it.
BOOST_AUTO_TEST_CASE(points_gather_where_the_curve_bends) {
  const SolvableContact contacts = synthetic::contacts();
  const FilmCurve curve = built(contacts);
  const auto between = [&](double low, double high) {
    return std::count_if(curve.forces_N().begin(), curve.forces_N().end(),
                         [&](double f) { return f >= low && f < high; });
  };
  BOOST_TEST(between(60, 540) > between(1800, 16200));
}

// Failures are values: at the heavy end there is no curve, at the light end the joint is where solving ends.
BOOST_AUTO_TEST_CASE(a_failure_at_the_heavy_end_is_reported) {
  const SolvableContact contacts{synthetic::contact(),
                                 [](double) -> ContactResult { return SolveFailure{"diverged"}; }};
  const auto curve = build_curve(contacts, {.heaviest_N = 12e3});
  BOOST_REQUIRE(std::holds_alternative<SolveFailure>(curve));
  BOOST_TEST(std::get<SolveFailure>(curve).why.find("16384") == std::string::npos);  // printed with four digits
  BOOST_TEST(std::get<SolveFailure>(curve).why.find("1.638e4 N: diverged") != std::string::npos);
  const auto fit = fit_contacts(contacts, 0.02, 2000, 12000, 6);
  BOOST_REQUIRE(std::holds_alternative<SolveFailure>(fit));
}

BOOST_AUTO_TEST_CASE(the_fit_takes_equally_spaced_forces_from_one_end_of_its_range_to_the_other) {
  const SolvableContact contacts = synthetic::contacts();
  const auto fit = fit_contacts(contacts, 0.02, 1900, 11400, 6);
  BOOST_REQUIRE(std::holds_alternative<LinearFit>(fit));
  const auto& points = std::get<LinearFit>(fit).points;
  BOOST_REQUIRE_EQUAL(points.size(), 6u);
  for (std::size_t k = 0; k < points.size(); ++k)
    EHD_CHECK(error(points[k].force_N, 1900.0 + 1900.0 * static_cast<double>(k)), Tolerance::round_off(8));
}

BOOST_AUTO_TEST_CASE(a_failure_at_the_light_end_leaves_a_joint_with_its_error) {
  const SolvableContact contacts{synthetic::contact(), [](double load_N_per_m) -> ContactResult {
                                   const double force_N = load_N_per_m * synthetic::contact().length_m;
                                   if (force_N < 200) return SolveFailure{"too light"};
                                   return synthetic::solve(force_N);
                                 }};
  const FilmCurve curve = built(contacts);
  BOOST_TEST(curve.lightest_N() >= 200);
  BOOST_TEST(curve.errors().joint > bound);
  BOOST_TEST(std::isfinite(curve.errors().joint));
  BOOST_TEST(curve.errors().lightest_because.find("too light") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(points_that_make_no_curve_are_refused) {
  BOOST_CHECK_THROW(FilmCurve(synthetic::contact(), {1, 2}, {1, 1}, {1, 1}), std::invalid_argument);
  BOOST_CHECK_THROW(FilmCurve(synthetic::contact(), {1, 3, 2}, {1, 1, 1}, {1, 1, 1}), std::invalid_argument);
  BOOST_CHECK_THROW(FilmCurve(synthetic::contact(), {1, 2, 3}, {1, -1, 1}, {1, 1, 1}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::bearing
