// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/response.hpp"

#include <cmath>
#include <complex>

#include "tests/check.hpp"

using namespace ehd;
using verification::Tolerance;

namespace {

const auto never = [] { return false; };

/// A response whose kappa is known up to `last`.
Response known_up_to(double last, std::vector<double> frequencies) {
  Response found;
  found.slow = SlowStiffness{.error_0 = 1e-5, .error_1 = 1e-5};
  for (const double Omega : frequencies)
    found.frequencies.push_back(
        {.Omega = Omega, .status = Omega <= last ? StopReason::converged : StopReason::tolerance_not_met});
  find_highest_certified(
      found, 1e-4, [last](double Omega) { return Omega <= last; }, never);
  return found;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(response)

BOOST_AUTO_TEST_CASE(the_highest_certified_frequency_is_bracketed) {
  for (const auto& requested : {std::vector<double>{1, 20}, {20, 1, 50}, {20}, {1e9}, {1e6, 1e9}}) {
    const double certified = known_up_to(7, requested).highest_certified.value();
    BOOST_TEST(certified <= 7);
    // Six halvings of [1, 20], or of two frequencies that are 2^6 apart where none of the request is known.
    BOOST_TEST(certified * std::exp2(6.0 / 64) > 7);
  }
}

// A grid resolves kappa up to 100, where it is known: the answer does not depend on the request, and takes one solve.
BOOST_AUTO_TEST_CASE(the_highest_certified_frequency_is_where_the_grids_end) {
  for (const auto& requested : {std::vector<double>{1, 200}, {1000}, {1e9}, {120, 1e6}}) {
    Response found;
    found.slow = SlowStiffness{.error_0 = 1e-5, .error_1 = 1e-5};
    for (const double Omega : requested)
      found.frequencies.push_back(
          {.Omega = Omega, .status = Omega <= 100 ? StopReason::converged : StopReason::tolerance_not_met});
    int asked = 0;
    find_highest_certified(
        found, 1e-4, [&](double Omega) { return ++asked > 0 && Omega <= 100; }, never, 100);
    BOOST_TEST(found.highest_certified.value() == 100);
    BOOST_TEST(asked == 1);
  }
  // Below the end of the grids something else may end what is known.
  Response found;
  found.slow = SlowStiffness{.error_0 = 1e-5, .error_1 = 1e-5};
  found.frequencies = {{.Omega = 1e9, .status = StopReason::tolerance_not_met}};
  find_highest_certified(
      found, 1e-4, [](double Omega) { return Omega <= 7; }, never, 100);
  BOOST_TEST(found.highest_certified.value() <= 7);
  BOOST_TEST(found.highest_certified.value() * std::exp2(6.0 / 64) > 7);
}

BOOST_AUTO_TEST_CASE(a_contact_that_is_known_at_rest_alone_ends_after_eight_frequencies) {
  Response found = known_up_to(0, {});
  found.frequencies = {{.Omega = 1e9, .status = StopReason::tolerance_not_met}};
  int asked = 0;
  find_highest_certified(
      found, 1e-4, [&](double) { return ++asked < 0; }, never);
  BOOST_TEST(found.highest_certified.value() == 0);
  BOOST_TEST(asked == 8);
}

BOOST_AUTO_TEST_CASE(all_known_is_the_last_requested) {
  BOOST_TEST(known_up_to(7, {3, 5, 1}).highest_certified.value() == 5);
  BOOST_TEST(known_up_to(7, {}).highest_certified.value() == 0);
}

BOOST_AUTO_TEST_CASE(without_the_stiffness_at_rest_nothing_is_certified) {
  Response found = known_up_to(7, {3});
  found.slow->error_0 = 1e-3;
  find_highest_certified(
      found, 1e-4, [](double) { return true; }, never);
  BOOST_TEST(!found.highest_certified);
  found.slow->error_0 = testing::not_a_number;
  find_highest_certified(
      found, 1e-4, [](double) { return true; }, never);
  BOOST_TEST(!found.highest_certified);
}

BOOST_AUTO_TEST_CASE(one_number_outside_its_tolerance_is_said) {
  Response known = known_up_to(7, {3});
  conclude(known, 1e-4, false, "why");
  BOOST_TEST((known.status == StopReason::converged));
  BOOST_TEST(known.reason.empty());
  Response part = known_up_to(7, {3, 9});
  conclude(part, 1e-4, false, "why");
  BOOST_TEST((part.status == StopReason::tolerance_not_met));
  BOOST_TEST(part.reason.starts_with("why; kappa is certified up to Omega = "));
  Response vague = known_up_to(7, {3});
  vague.slow->error_1 = testing::not_a_number;
  conclude(vague, 1e-4, false, "why");
  BOOST_TEST((vague.status == StopReason::tolerance_not_met));
  BOOST_TEST(vague.reason == "why; kappa_1 is not known");
  Response wavy = known_up_to(7, {3});
  wavy.waviness.emplace_back().status = StopReason::tolerance_not_met;
  conclude(wavy, 1e-4, true, "why");
  BOOST_TEST((wavy.status == StopReason::limit_reached));
}

// The command exits 1 then although each frequency of its table says "converged".
BOOST_AUTO_TEST_CASE(a_number_of_slow_motion_that_misses_is_named_with_its_error_rounded_up) {
  Response found = known_up_to(7, {3});
  found.slow->error_1 = 1.301e-4;
  conclude(found, 1e-4, false, "why");
  BOOST_TEST(found.reason == "why; kappa_1 is known to 0.00014 only");
  found.slow->error_0 = 1e-2;
  conclude(found, 1e-4, false, "why");
  BOOST_TEST(found.reason == "why; kappa_0 is known to 0.01 only; kappa_1 is known to 0.00014 only");
}

// Exact: 1/kappa + datum in complex numbers; the errors are the changes that the errors of compliance and lag make.
BOOST_AUTO_TEST_CASE(a_datum_is_a_compliance_in_series) {
  const double Omega = 0.7, datum = 1.9, error = 1e-6;
  const std::complex<double> kappa(3.1, 0.43), chi = 1.0 / kappa, whole = 1.0 / (chi + datum);
  const Stiffness at{.Omega = Omega, .kappa = kappa, .error = error, .lag_error = error};
  const Kappa found = in_series(at, datum);
  EHD_CHECK(ehd::error(found.stiffness, whole.real()), Tolerance::round_off(16));
  EHD_CHECK(ehd::error(found.damping, whole.imag() / Omega), Tolerance::round_off(16));
  const std::complex<double> softer = 1.0 / (chi + datum + error * std::abs(chi)),
                             slower = 1.0 / (chi + datum - std::complex<double>(0, Omega * at.lag() * error));
  EHD_CHECK(
      ehd::error(found.damping_error, (std::abs((softer - whole).imag()) + std::abs((slower - whole).imag())) / Omega),
      Tolerance::required(1e-3, "differences of a part in 1e6, which keep four digits"));
  EHD_CHECK(ehd::error(found.stiffness_error, std::abs((softer - whole).real()) + std::abs((slower - whole).real())),
            Tolerance::required(1e-3, "differences of a part in 1e6, which keep four digits"));
}

BOOST_AUTO_TEST_CASE(damping_with_the_own_datum_is_no_further_off_than_kappa) {
  const Stiffness at{.Omega = 0.5, .kappa = {3, 0.4}, .error = 1e-3, .lag_error = 1};
  EHD_CHECK(ehd::error(in_series(at, 0).damping_error, at.error * std::abs(at.kappa) / at.Omega),
            Tolerance::round_off(8));
}

// Where a spike passes between the nodes, the errors of kappa_0 and kappa_1 cancel in the lag kappa_1/kappa_0^2. A
// stiff film on a soft datum has the error of the lag alone.
BOOST_AUTO_TEST_CASE(damping_with_a_soft_datum_is_known_as_the_lag_is) {
  const SlowStiffness slow{
      .kappa_0 = 4, .kappa_1 = 1.6, .error_0 = 1e-2, .error_1 = 3e-2, .lag = 0.1, .lag_error = 1e-3};
  const Kappa own = in_series(slow, 0), soft = in_series(slow, 1000);
  EHD_CHECK(ehd::error(own.damping_error, 3e-2 * 1.6), Tolerance::round_off(4));
  EHD_CHECK(ehd::error(soft.damping, 0.1 / (1000.25 * 1000.25)), Tolerance::round_off(8));
  EHD_CHECK(ehd::error(soft.damping_error / soft.damping, 1e-3),
            Tolerance::required(1e-2, "2 error_0 chi_0/1000 = 5e-6 beside 1e-3"));
}

BOOST_AUTO_TEST_SUITE_END()
