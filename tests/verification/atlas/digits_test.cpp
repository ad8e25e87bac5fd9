// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/atlas/digits.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "contact/text.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

std::string text_of(double value, double error) {
  const auto known = known_digits(value, error);
  return known ? known->text : "none";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(atlas_digits)

BOOST_AUTO_TEST_CASE(a_digit_is_printed_where_the_error_is_below_half_of_its_unit) {
  const struct {
    double value, error;
    const char* text;
  } rows[] = {
      {0.0741427, 2e-6, "0.07414"},
      {0.0741427, 4.9e-6, "0.07414"},
      {0.0741427, 5e-6, "0.0741"},  // not below half a unit
      {1.25, 0.004, "1.25"},
      {9.9996, 4e-5, "9.9996"},
      {9.9996, 0.00049, "10.000"},
      {9.9996, 0.004, "10.00"},
      {9.9996, 0.3, "10"},
      {0.99996, 0.0004, "1.000"},
      {9.9996e-4, 4e-9, "9.9996e-4"},
      {9.9996e-4, 4e-8, "1.0000e-3"},
      {9.6e-4, 4e-5, "1.0e-3"},
      {9.6e-5, 4e-6, "1.0e-4"},
      {1.5141e-7, 1e-10, "1.51e-7"},
      {0.001, 1e-6, "0.00100"},
      {999999.7, 0.4, "1000000"},
      {1234567, 40, "1.2346e6"},
      {99999, 4000, "1.0e5"},
      {-0.50346337, 1e-5, "-0.5035"},
      {-9.6e-4, 4e-5, "-1.0e-3"},
      {0.00012, 1e-12, "1.2000000e-4"},
      {1.0 / 3, 1e-30, "0.333333333333333"},  // 15 digits are what a double holds
      {1e300, 1e290, "1.000000000e300"},
      {1e-300, 1e-310, "1.000000000e-300"},
      // not one digit
      {9.6e-4, 6e-4, "none"},
      {0.7, 0.3, "none"},  // and not 1
      {4.0, 5.0, "none"},
      {0.4, 0.4, "none"},
      {1.0, 100.0, "none"},
      {0.0, 1e-9, "none"},
      {1.0, 0.0, "none"},
      {1.0, -1e-3, "none"},
      {1.0, infinite, "none"},
      {1.0, std::nan(""), "none"},
      {infinite, 1.0, "none"},
      {std::nan(""), 1e-9, "none"},
  };
  for (const auto& row : rows)
    BOOST_TEST(text_of(row.value, row.error) == row.text,
               row.value << " +- " << row.error << ": " << text_of(row.value, row.error));
}

BOOST_AUTO_TEST_CASE(the_uncertainty_covers_the_error_and_the_rounding_of_the_text) {
  std::size_t printed = 0;
  for (int k = 0; k < 20000; ++k) {
    // Values and errors over many decades, none of them at a round place.
    const double value = (k % 2 ? -1 : 1) * std::pow(10.0, std::fmod(k * 0.6180339887, 14.0) - 7);
    const double error = std::abs(value) * std::pow(10.0, -std::fmod(k * 0.4142135623, 16.0));
    const auto known = known_digits(value, error);
    if (!known) {
      BOOST_REQUIRE(error >= 0.05 * std::abs(value));
      continue;
    }
    ++printed;
    const double text = std::stod(known->text), relative = std::stod(known->relative),
                 absolute = std::stod(known->absolute);
    const double truth_may_be_off = error + std::abs(text - value);
    constexpr double slack = 1 - 1e-8;  // what is 1.2 to nine digits is printed as 1.2
    BOOST_REQUIRE_MESSAGE(absolute >= slack * truth_may_be_off, known->text << " from " << value << " +- " << error);
    BOOST_REQUIRE(relative * std::abs(text) >= slack * truth_may_be_off);
    BOOST_REQUIRE_MESSAGE(absolute <= 1.11 * truth_may_be_off, known->absolute << " for " << truth_may_be_off);
    BOOST_REQUIRE(relative <= 1);
    const double half_unit = relative_half_unit(known->text) * std::abs(text);
    constexpr double rounding = 1e-6;  // of half_unit itself
    BOOST_REQUIRE_MESSAGE(error <= half_unit * (1 + rounding), known->text << " from " << value << " +- " << error);
    BOOST_REQUIRE_MESSAGE(error >= 0.0999 * half_unit || count_digits(known->text) >= 15,
                          known->text << " keeps back a digit: " << value << " +- " << error);
  }
  BOOST_TEST(printed > 15000u);
}

BOOST_AUTO_TEST_CASE(significant_digits_are_counted) {
  const struct {
    const char* text;
    int digits;
  } rows[] = {{"", 0},      {"0", 0},         {"0.0741", 3}, {"-0.5035", 4}, {"1.000", 4},
              {"10.00", 4}, {"1.0000e-3", 5}, {"1e10", 1},   {"-", 0},       {"1.2345E22", 5}};
  for (const auto& row : rows) BOOST_TEST(count_digits(row.text) == row.digits, row.text);
}

BOOST_AUTO_TEST_SUITE_END()
