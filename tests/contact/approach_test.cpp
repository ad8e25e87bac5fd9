// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/approach.hpp"

#include <cmath>
#include <numbers>

#include "contact/hertz.hpp"
#include "tests/check.hpp"

namespace {

using namespace ehd;
using std::numbers::pi;
using verification::Tolerance;

const Tolerance rounding = Tolerance::round_off(64);

Conditions contact() { return {.load_N_per_m = 4.1e5, .reduced_radius_m = 2.3e-3, .reduced_modulus_Pa = 2.26e11}; }

}  // namespace

BOOST_AUTO_TEST_SUITE(approach)

BOOST_AUTO_TEST_CASE(with_the_half_width_as_datum_it_is_minus_the_offset) {
  const Conditions c = contact();
  const double b = hertz::half_width_m(c);
  EHD_CHECK(error(approach_m(c, -0.37, b), 0.37 * b * b / c.reduced_radius_m), rounding);
}

BOOST_AUTO_TEST_CASE(it_equals_the_film_equation_far_from_the_contact) {
  // h(x) = -delta + x^2/(2R) - (4/(pi E')) Int p ln|(x-x')/x_0| dx': at large x the integral is w ln(x/x_0), so H_0
  // read from h there must give delta back. The next term is (b/x)^2/8 of the last.
  const Conditions c = contact();
  const double b = hertz::half_width_m(c), R = c.reduced_radius_m, datum = 0.031, offset = -0.42;
  const double X = 1e5, x = X * b;
  const double from_hertz_scaling = (offset + X * X / 2 - std::log(X) / 2) * b * b / R;
  const double compliance = 4 / (pi * c.reduced_modulus_Pa);
  const double without_delta = x * x / (2 * R) - compliance * c.load_N_per_m * std::log(x / datum);
  // The difference of two numbers of size X^2/2 keeps eps X^2 of the result's size.
  EHD_CHECK(error(without_delta - from_hertz_scaling, approach_m(c, offset, datum)), Tolerance::round_off(8, X * X));
}

BOOST_AUTO_TEST_CASE(dry_it_is_the_printed_logarithm) {
  const Conditions c = contact();
  const double b = hertz::half_width_m(c), datum = 0.019;
  const double compliance = 4 * c.load_N_per_m / (pi * c.reduced_modulus_Pa);
  EHD_CHECK(error(dry_approach_m(c, datum), compliance * (std::log(2 * datum / b) + 0.5)), rounding);
}

BOOST_AUTO_TEST_CASE(the_datum_that_meets_an_approach_is_the_inverse) {
  const Conditions c = contact();
  int rows = 0;
  for (const double datum : {1.3e-4, 2.3e-3, 0.122}) {
    EHD_CHECK(error(datum_from_dry_approach_m(c, dry_approach_m(c, datum)), datum), rounding);
    ++rows;
  }
  BOOST_TEST(rows == 3);
  BOOST_TEST(datum_from_dry_approach_m(c, -5e-6) > 0);
}

BOOST_AUTO_TEST_CASE(a_film_moves_the_bodies_by_the_same_amount_whatever_the_datum) {
  const Conditions c = contact();
  const double b = hertz::half_width_m(c), offset = -0.31;
  const double expected = -(b * b / c.reduced_radius_m) * (offset - hertz::dry_offset());
  int rows = 0;
  for (const double datum : {2e-4, 3e-2}) {
    EHD_CHECK(error(approach_m(c, offset, datum) - dry_approach_m(c, datum), expected), rounding);
    ++rows;
  }
  BOOST_TEST(rows == 2);
}

BOOST_AUTO_TEST_SUITE_END()
