// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/response_curve.hpp"

#include <cmath>
#include <stdexcept>

#include "bearing/martin.hpp"
#include "contact/hertz.hpp"
#include "tests/bearing/synthetic.hpp"
#include "tests/check.hpp"

namespace ehd::bearing {

using verification::Tolerance;

namespace {

constexpr double omega = 36000;           ///< rad/s, at which the synthetic contact departs from slow motion
constexpr double far_omega = 50 * omega;  ///< at which a curve knows hardly anything

/// Responses in closed form: rigid at light loads, and departing from slow motion like Omega^2.
Kappa slow_truth(double force_N) {
  const double stiffness = martin_kappa_0(synthetic::contact(), force_N).value / synthetic::enhancement(force_N, 1.3);
  const double x = std::log(force_N / synthetic::knee_N);  // a dip of the lag to nearly nothing
  const double lag = martin_lag(synthetic::contact(), force_N).value * synthetic::enhancement(force_N, 1.6) *
                     (1 - 0.97 / (1 + std::exp(-4 * (x - 0.3))) / std::cosh(4 * (x - 0.6)));
  return {.stiffness = stiffness, .damping = lag * stiffness * stiffness};
}
Kappa truth_at(double force_N, double at_omega = omega) {
  Kappa kappa = slow_truth(force_N);
  const double bend = synthetic::enhancement(force_N, 0.2) - 1;
  const double Omega = Omega_of(synthetic::contact(), force_N, at_omega);
  kappa.stiffness *= 1 - Omega * Omega * bend;
  kappa.damping *= 1 - 3 * Omega * Omega * bend;  // it turns negative at the heaviest loads
  return kappa;
}

RespondingContact responding(int& solves) {
  return {synthetic::contact(), [&](double load_N_per_m, const std::vector<double>& omegas) -> ResponseResult {
            ++solves;
            const double force_N = load_N_per_m * synthetic::contact().length_m;
            SolvedResponse solved{.slow = slow_truth(force_N)};
            for (const double each : omegas) solved.at.push_back(truth_at(force_N, each));
            return solved;
          }};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(response_curve)

BOOST_AUTO_TEST_CASE(stated_errors_cover_a_known_response_at_every_load) {
  int solves = 0;
  const RespondingContact contacts = responding(solves);
  const ResponseCurveRequest request{.lightest_N = 90, .heaviest_N = 9000, .omegas = {omega}};
  const auto built = build_response_curve(contacts, request);
  BOOST_REQUIRE(std::holds_alternative<ResponseCurve>(built));
  const auto& curve = std::get<ResponseCurve>(built);
  BOOST_TEST(solves == static_cast<int>(curve.forces_N().size()) + 1);  // and one below the lightest
  BOOST_TEST(solves < 70);
  for (const ReadingErrors& errors : {curve.errors().slow, curve.errors().at.at(0)}) {
    EHD_CHECK(8 * errors.stiffness, Tolerance::required(request.bound, "the bound of the request"));
    EHD_CHECK(8 * errors.damping, Tolerance::required(request.bound, "the bound of the request"));
  }
  BOOST_TEST(truth_at(9000).damping < 0);
  double worst = 0, worst_at_N = 0;
  for (double f = 0.5; f <= 9000; f *= 1.13) {
    for (const auto& [found, truth] :
         {std::pair{curve.slow(f), slow_truth(f)}, std::pair{curve.at(f, 0), truth_at(f)}}) {
      const double here = std::max(std::abs(found.stiffness - truth.stiffness) / found.stiffness_error,
                                   std::abs(found.damping - truth.damping) / found.damping_error);
      if (here > worst) worst = here, worst_at_N = f;
    }
  }
  BOOST_TEST_MESSAGE("largest error over stated error " << worst << " at " << worst_at_N << " N, " << solves
                                                        << " solves");
  EHD_CHECK(worst, Tolerance::stated());
}

BOOST_AUTO_TEST_CASE(a_curve_that_is_read_at_few_forces_solves_these_and_four_more) {
  int solves = 0;
  const ResponseCurveRequest request{
      .lightest_N = 90, .heaviest_N = 9000, .omegas = {omega}, .read_at_N = {50, 400, 8000, 400 * (1 + 1e-14), 2000}};
  const auto built = build_response_curve(responding(solves), request);
  BOOST_REQUIRE(std::holds_alternative<ResponseCurve>(built));
  const auto& curve = std::get<ResponseCurve>(built);
  BOOST_TEST(solves == 7);  // 400, 2000, 8000; the lightest, two above it, and half of it
  for (const double f : {400.0, 2000.0, 8000.0})
    for (const auto& [found, truth] :
         {std::pair{curve.slow(f), slow_truth(f)}, std::pair{curve.at(f, 0), truth_at(f)}}) {
      EHD_CHECK(error(found.stiffness, truth.stiffness), Tolerance::round_off(100, 1));
      EHD_CHECK(std::abs(found.damping - truth.damping) / curve.damping_scale(f), Tolerance::round_off(100, 1));
    }
  const Kappa below = curve.slow(50), truth = slow_truth(50);
  EHD_CHECK(std::abs(below.stiffness - truth.stiffness), Tolerance::required(below.stiffness_error, "its error bar"));
  EHD_CHECK(std::abs(below.damping - truth.damping), Tolerance::required(below.damping_error, "its error bar"));
}

// A scan of frequencies may reach beyond what is known. Numbers and errors of the others stay, to the last bit.
BOOST_AUTO_TEST_CASE(the_error_at_a_frequency_does_not_depend_on_the_others_asked_for) {
  for (const std::vector<double>& read_at_N : {std::vector<double>{50, 400, 2000, 8000}, {}}) {
    int solves = 0;
    const auto built = [&](const std::vector<double>& omegas) {
      // The bound is loose: so the far frequency splits no gap, and both curves have the same points.
      return std::get<ResponseCurve>(build_response_curve(
          responding(solves),
          {.lightest_N = 90, .heaviest_N = 9000, .omegas = omegas, .read_at_N = read_at_N, .bound = 1e9}));
    };
    const ResponseCurve alone = built({omega}), beside = built({far_omega, omega});
    BOOST_TEST(alone.forces_N() == beside.forces_N(), boost::test_tools::per_element());
    BOOST_TEST(beside.at(50, 0).damping_error > beside.at(50, 1).damping_error);
    for (const double f : {50.0, 400.0, 3000.0})
      for (const auto& [one, other] :
           {std::pair{alone.slow(f), beside.slow(f)}, std::pair{alone.at(f, 0), beside.at(f, 1)}}) {
        BOOST_TEST(one.stiffness == other.stiffness);
        BOOST_TEST(one.stiffness_error == other.stiffness_error);
        BOOST_TEST(one.damping == other.damping);
        BOOST_TEST(one.damping_error == other.damping_error);
      }
  }
}

// Counter: the heaviest contact has the highest Omega. What it does not answer, no other contact is asked for.
BOOST_AUTO_TEST_CASE(a_frequency_without_an_answer_is_unknown_everywhere_and_asked_for_once) {
  for (const std::vector<double>& read_at_N : {std::vector<double>{50, 400, 2000, 8000}, {}}) {
    int solves = 0, asked = 0;
    const RespondingContact known = responding(solves);
    const RespondingContact contacts{synthetic::contact(),
                                     [&](double load_N_per_m, const std::vector<double>& omegas) -> ResponseResult {
                                       auto result = known.solve(load_N_per_m, omegas);
                                       auto& solved = std::get<SolvedResponse>(result);
                                       for (std::size_t k = 0; k < omegas.size(); ++k)
                                         if (omegas[k] == far_omega) {
                                           ++asked;
                                           solved.at[k] = unknown_at(solved.slow);
                                         }
                                       return result;
                                     }};
    const ResponseCurveRequest beside{
        .lightest_N = 90, .heaviest_N = 9000, .omegas = {far_omega, omega}, .read_at_N = read_at_N};
    ResponseCurveRequest alone = beside;
    alone.omegas = {omega};
    const auto built = std::get<ResponseCurve>(build_response_curve(contacts, beside)),
               other = std::get<ResponseCurve>(build_response_curve(known, alone));
    BOOST_TEST(asked == 1);
    for (const double f : {50.0, 400.0, 3000.0}) {
      BOOST_TEST(!is_known(built.at(f, 0)));
      BOOST_TEST(is_known(built.at(f, 1)));
      BOOST_TEST(built.at(f, 1).damping_error == other.at(f, 0).damping_error);
      BOOST_TEST(built.at(f, 1).damping == other.at(f, 0).damping);
    }
  }
}

// Exact: at vanishing load the curve has the rigid cylinder's stiffness f/h and its closed form of damping.
BOOST_AUTO_TEST_CASE(far_below_the_lightest_point_the_cylinder_is_rigid) {
  int solves = 0;
  const auto built = build_response_curve(responding(solves), {.lightest_N = 90, .heaviest_N = 9000});
  const RacewayContact contact = synthetic::contact();
  const double f = 0.09, film_m = martin_film(contact, f).value, b = hertz::half_width_m(contact.at(f));
  const Kappa found = std::get<ResponseCurve>(built).slow(f);
  // kappa_0 E'/4 is the stiffness per length
  EHD_CHECK(error(found.stiffness * contact.reduced_modulus_Pa / 4, f / contact.length_m / film_m),
            Tolerance::asymptotic(1e-3, "(f/knee)^(3/2) at a two-thousandth of the knee, times 10"));
  const double c = 6.548275819 * contact.viscosity_Pa_s * std::pow(contact.reduced_radius_m / film_m, 1.5);
  EHD_CHECK(error(found.damping * contact.reduced_modulus_Pa / 4 * b / (contact.speed_sum_m_per_s / 2), c),
            Tolerance::asymptotic(1e-3, "likewise"));
}

BOOST_AUTO_TEST_CASE(a_contact_without_response_and_a_negative_kappa_1_end_the_curve_with_a_sentence) {
  RespondingContact contacts{synthetic::contact(), [](double, const std::vector<double>&) -> ResponseResult {
                               return SolveFailure{.why = "no steady state", .limit = true};
                             }};
  const ResponseCurveRequest request{.lightest_N = 90, .heaviest_N = 9000};
  const auto failed = build_response_curve(contacts, request);
  BOOST_REQUIRE(std::holds_alternative<SolveFailure>(failed));
  BOOST_TEST(std::get<SolveFailure>(failed).limit);
  BOOST_TEST(std::get<SolveFailure>(failed).why.find("90 N: no steady state") != std::string::npos);
  contacts.solve = [](double, const std::vector<double>&) -> ResponseResult {
    return SolvedResponse{.slow = {.stiffness = 4, .damping = -0.1}};
  };
  const auto negative = build_response_curve(contacts, request);
  BOOST_REQUIRE(std::holds_alternative<SolveFailure>(negative));
  BOOST_TEST(std::get<SolveFailure>(negative).why.find("kappa_1 = -0.1") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(without_a_lighter_contact_the_error_below_is_unknown) {
  int solves = 0;
  const RespondingContact known = responding(solves);
  const RespondingContact contacts{synthetic::contact(),
                                   [&](double load_N_per_m, const std::vector<double>& omegas) -> ResponseResult {
                                     if (load_N_per_m * synthetic::contact().length_m < 80)
                                       return SolveFailure{.why = "too light"};
                                     return known.solve(load_N_per_m, omegas);
                                   }};
  const auto built = build_response_curve(contacts, {.lightest_N = 90, .heaviest_N = 9000});
  BOOST_REQUIRE(std::holds_alternative<ResponseCurve>(built));
  BOOST_TEST(std::isinf(std::get<ResponseCurve>(built).slow(50).damping_error));
  BOOST_TEST(std::isfinite(std::get<ResponseCurve>(built).slow(100).damping_error));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::bearing
