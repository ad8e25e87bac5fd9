// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/tolerance.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include "tests/check.hpp"

namespace {
using namespace ehd;
using verification::judge;
using verification::Tolerance;
using verification::Verdict;
}  // namespace

BOOST_AUTO_TEST_SUITE(tolerance)

BOOST_AUTO_TEST_CASE(no_tolerance_is_made_from_a_bare_number) {
  BOOST_TEST((!std::is_constructible_v<Tolerance, double>));
  BOOST_TEST((!std::is_convertible_v<double, Tolerance>));
}

BOOST_AUTO_TEST_CASE(half_a_unit_of_the_last_digit_is_read_from_the_text) {
  struct Row {
    const char* digits;
    double relative;
  };
  int rows = 0;
  for (const Row row : {Row{"0.0741", 0.00005 / 0.0741}, Row{"-.25170", 0.000005 / 0.2517}, Row{"4.08", 0.005 / 4.08},
                        Row{"577.350", 0.0005 / 577.35}, Row{"8.9959560167e-4", 0.5e-14 / 8.9959560167e-4},
                        Row{"1300", 0.5 / 1300}, Row{"1.3E+3", 50.0 / 1300}, Row{"0.00", 0.005}}) {
    BOOST_TEST_CONTEXT(row.digits) {
      EHD_CHECK(error(relative_half_unit(row.digits), row.relative), Tolerance::round_off(16));
      EHD_CHECK(error(Tolerance::published_digits(row.digits).value(), row.relative), Tolerance::round_off(16));
    }
    ++rows;
  }
  BOOST_TEST(rows == 8);
}

BOOST_AUTO_TEST_CASE(every_tolerance_carries_its_basis_and_its_reason) {
  struct Row {
    Tolerance tolerance;
    const char* basis;
    double value;
    const char* in_reason;
  };
  const double eps = std::numeric_limits<double>::epsilon();
  const Row rows[] = {{Tolerance::round_off(12, 3), "round-off", 36 * eps, "12 operations"},
                      {Tolerance::iteration(1e-9, 7), "iteration", 7e-9, "amplification 7"},
                      {Tolerance::discretisation(2e-4, 1.25), "discretisation", 2.5e-4, "safety 1.25"},
                      {Tolerance::asymptotic(0.03, "next term M^(4/5)"), "asymptotic", 0.03, "next term M^(4/5)"},
                      {Tolerance::calibrated(0.4, "measured on (3,4)"), "calibrated", 0.4, "measured on (3,4)"},
                      {Tolerance::required(1e-3, "--tolerance 1e-3"), "required", 1e-3, "--tolerance 1e-3"}};
  int count = 0;
  for (const Row& row : rows) {
    EHD_CHECK(error(row.tolerance.value(), row.value), Tolerance::round_off(4));
    BOOST_TEST(row.tolerance.basis() == row.basis);
    BOOST_TEST(row.tolerance.reason().find(row.in_reason) != std::string::npos);
    ++count;
  }
  BOOST_TEST(count == 6);
}

BOOST_AUTO_TEST_CASE(a_verdict_needs_error_and_uncertainty_on_one_side_of_the_tolerance) {
  const Tolerance bound = Tolerance::required(1.0, "here");
  BOOST_TEST((judge(0.7, 0.2, bound) == Verdict::pass));
  BOOST_TEST((judge(0.75, 0.25, bound) == Verdict::pass));  // equality passes
  BOOST_TEST((judge(0.9, 0.2, bound) == Verdict::inconclusive));
  BOOST_TEST((judge(1.1, 0.2, bound) == Verdict::inconclusive));
  BOOST_TEST((judge(1.25, 0.25, bound) == Verdict::inconclusive));
  BOOST_TEST((judge(1.3, 0.25, bound) == Verdict::fail));
  BOOST_TEST((judge(1.0000001, 0, bound) == Verdict::fail));
}

BOOST_AUTO_TEST_CASE(what_is_not_a_number_never_passes) {
  const double nan = std::nan("");
  int rows = 0;
  for (const double tolerance : {1.0, std::numeric_limits<double>::infinity(), nan}) {
    const Tolerance bound = Tolerance::required(tolerance, "here");
    BOOST_TEST((judge(nan, 0, bound) != Verdict::pass));
    BOOST_TEST((judge(0, nan, bound) != Verdict::pass));
    ++rows;
  }
  BOOST_TEST(rows == 3);
  BOOST_TEST((judge(0, 0, Tolerance::required(nan, "here")) != Verdict::pass));
  BOOST_TEST((judge(std::numeric_limits<double>::infinity(), 0, Tolerance::required(1, "here")) == Verdict::fail));
}

BOOST_AUTO_TEST_CASE(verdicts_have_their_words) {
  BOOST_TEST(to_string(Verdict::pass) == "pass");
  BOOST_TEST(to_string(Verdict::fail) == "fail");
  BOOST_TEST(to_string(Verdict::inconclusive) == "inconclusive");
}

BOOST_AUTO_TEST_SUITE_END()
