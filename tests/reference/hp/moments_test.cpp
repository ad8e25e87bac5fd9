// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 1: Int P_k(t) ln|u - t| dt against GSL's quadrature, against a series without cancellation, and against the same
// template with 34 digits, from inside the element to a million lengths away.
#include "reference/hp/moments.hpp"

#include <vector>

#include "tests/check.hpp"
#include "tests/quad.hpp"
#include "tests/quadrature.hpp"

namespace {

using namespace ehd;
using namespace ehd::reference::hp;
using ehd::testing::Quad;
using verification::Tolerance;

template <class Scalar>
VectorOf<Scalar> inside(int degree, const Scalar& from_left, const Scalar& from_right) {
  VectorOf<Scalar> work(degree + 2), m(degree + 1);
  const Scalar u = from_left < from_right ? Scalar(from_left - 1) : Scalar(1 - from_right);
  moments_inside(degree, u, from_left, from_right, work, m);
  return m;
}

template <class Scalar>
VectorOf<Scalar> outside(int degree, const Scalar& beyond) {
  VectorOf<Scalar> work(degree + 2), m(degree + 1);
  moments_outside(degree, beyond, work, m);
  return m;
}

double by_quadrature(int k, double u) {
  return ehd::testing::log_integral([k](double t) { return legendre(k, t)[k]; }, -1, 1, u);
}

/// The size of a moment inside the element: m_0 is of size 1, and m_k at the ends is -2/(k(k+1)).
double size_of_moment(int k) { return k == 0 ? 1 : 2.0 / (k * (k + 1)); }

/// Near an end, `distance` from it, m_k is a difference of Q's of size Q_0 = ln(2/distance)/2, divided by k + 1/2, and
/// not larger than 2/k^2: a loss of k Q_0.
Tolerance rounding(int k, double distance) {
  return Tolerance::round_off(5, (k + 1) * std::max(1.0, std::log(2 / distance) / 2));
}

// QAWS and QAG have a tolerance of 1e-13, of an integral of size 1.
const Tolerance quadrature = Tolerance::iteration(ehd::testing::asked_of_quadrature, 2);

}  // namespace

BOOST_AUTO_TEST_SUITE(hp_moments)

BOOST_AUTO_TEST_CASE(moments_in_the_element_are_its_integrals) {
  constexpr int degree = 12;
  int rows = 0;
  for (const double u : {-1.0, -1 + 1e-10, -0.77, -0.3, 0.0, 0.013, 0.5, 0.96, 1 - 1e-6, 1.0}) {
    const VectorOf<double> m = inside<double>(degree, 1 + u, 1 - u);
    for (const int k : {0, 1, 2, 3, 7, 12}) {
      BOOST_TEST_CONTEXT("u = " << u << ", k = " << k) { EHD_CHECK(std::abs(m[k] - by_quadrature(k, u)), quadrature); }
      ++rows;
    }
  }
  BOOST_TEST(rows == 60);
}

BOOST_AUTO_TEST_CASE(moments_beside_the_element_are_its_integrals) {
  constexpr int degree = 12;
  int rows = 0;
  for (const double beyond : {0.0, 1e-10, 1e-6, 3e-3, 0.02, 0.3, 1.0, 1.5, 7.0, 40.0}) {
    const VectorOf<double> m = outside(degree, beyond);
    for (const int k : {0, 1, 2, 3, 7, 12}) {
      BOOST_TEST_CONTEXT("u = 1 + " << beyond << ", k = " << k) {
        EHD_CHECK(std::abs(m[k] - by_quadrature(k, 1 + beyond)) / std::max(1.0, std::abs(m[0])), quadrature);
        // At the other side odd moments have the other sign.
        EHD_CHECK(
            std::abs(m[k] * (k % 2 == 0 ? 1 : -1) - by_quadrature(k, -1 - beyond)) / std::max(1.0, std::abs(m[0])),
            quadrature);
      }
      ++rows;
    }
  }
  BOOST_TEST(rows == 60);
}

BOOST_AUTO_TEST_CASE(far_moments_are_their_series_however_small) {
  // ln|u - t| = ln u - Sum_j (t/u)^j/j, and Int P_k t^j dt = 2^(k+1) j! ((j+k)/2)!/(((j-k)/2)! (j+k+1)!) where j - k is
  // even and not negative: terms of one sign, so that each moment is known relative to itself.
  constexpr int degree = 20;
  int rows = 0;
  for (const double beyond : {1.0, 2.0, 9.7, 1e2, 1e3, 1e4, 1e6, 2e6}) {
    const VectorOf<double> m = outside(degree, beyond);
    const long double u = 1 + static_cast<long double>(beyond);
    for (int k = 0; k <= degree; ++k) {
      // Term j = k: Int P_k t^k dt = 2^(k+1) (k!)^2/(2k+1)!; then the ratio of consecutive terms.
      long double integral = 2;
      for (int i = 1; i <= k; ++i) integral *= static_cast<long double>(i) / (2 * i + 1);
      long double power = 1;
      for (int i = 0; i < k; ++i) power /= u;
      long double sum = 0;
      for (int j = k; j < 400; j += 2) {
        if (j > 0) sum -= integral * power / j;
        integral *= static_cast<long double>(j + 1) * (j + 2) / (static_cast<long double>(j - k + 2) * (j + k + 3));
        power /= u * u;
      }
      if (k == 0) sum += 2 * std::log(u);
      BOOST_TEST_CONTEXT("u = 1 + " << beyond << ", k = " << k) {
        // k ratios, each good to a few eps.
        EHD_CHECK(error(m[k], static_cast<double>(sum)), Tolerance::round_off(20.0 + 4 * k));
      }
      ++rows;
    }
  }
  BOOST_TEST(rows == 8 * 21);
}

BOOST_AUTO_TEST_CASE(rounding_in_the_element_is_a_few_units_of_the_moment_at_its_ends) {
  int rows = 0;
  for (const int degree : {4, 8, 12, 15, 20}) {
    for (const double from_left : {1e-30, 1e-18, 1e-10, 1e-5, 0.01, 0.1, 0.37, 0.8, 0.999, 1.0}) {
      const VectorOf<double> m = inside<double>(degree, from_left, 2 - from_left);
      const VectorOf<Quad> truth = inside<Quad>(degree, Quad(from_left), Quad(2) - Quad(from_left));
      for (int k = 0; k <= degree; ++k) {
        BOOST_TEST_CONTEXT("degree " << degree << ", 1 + u = " << from_left << ", k = " << k) {
          EHD_CHECK(static_cast<double>(abs(truth[k] - m[k])) / size_of_moment(k), rounding(k, from_left));
        }
        ++rows;
      }
    }
  }
  BOOST_TEST(rows == 10 * (5 + 9 + 13 + 16 + 21));
}

BOOST_AUTO_TEST_CASE(rounding_outside_the_element_is_a_few_units_of_each_moment_itself) {
  int rows = 0;
  for (const int degree : {4, 8, 12, 15, 20}) {
    // Both sides of the switch between the recurrences at acosh(u) = 1.5/(degree + 1).
    const double at_switch = std::cosh(1.5 / (degree + 1)) - 1;
    for (const double beyond : {1e-30, 1e-18, 1e-10, 1e-6, 1e-4, 2e-3, 0.999999 * at_switch, 1.000001 * at_switch, 0.05,
                                0.3, 0.999999, 1.000001, 4.0, 60.0, 1e3, 1e4, 1e6, 2e6}) {
      const VectorOf<double> m = outside(degree, beyond);
      const VectorOf<Quad> truth = outside(degree, Quad(beyond));
      for (int k = 0; k <= degree; ++k) {
        BOOST_TEST_CONTEXT("degree " << degree << ", u = 1 + " << beyond << ", k = " << k) {
          // m_0 passes through 0 at u = 1.17 and is then known as a difference of numbers of size 1.
          const double size = k == 0 ? std::max(1.0, std::abs(m[0])) : static_cast<double>(abs(truth[k]));
          EHD_CHECK(static_cast<double>(abs(truth[k] - m[k])) / size, rounding(k, beyond));
        }
        ++rows;
      }
    }
  }
  BOOST_TEST(rows == 18 * (5 + 9 + 13 + 16 + 21));
}

BOOST_AUTO_TEST_CASE(even_moments_are_even_and_odd_ones_odd) {
  for (const double from_left : {0.0, 1e-12, 0.2, 0.9}) {
    const VectorOf<double> left = inside<double>(9, from_left, 2 - from_left),
                           right = inside<double>(9, 2 - from_left, from_left);
    for (int k = 0; k <= 9; ++k)
      EHD_CHECK(std::abs(left[k] - (k % 2 == 0 ? 1 : -1) * right[k]) / size_of_moment(k), Tolerance::round_off(10));
  }
}

BOOST_AUTO_TEST_CASE(the_two_sides_of_an_end_meet) {
  // The logarithm's integral is continuous, with a slope of ln|1 - u|: from 1e-13 inside to 1e-13 outside.
  const double step = 1e-13;
  const VectorOf<double> in = inside<double>(12, 2 - step, step), out = outside(12, step), at = outside(12, 0.0);
  for (int k = 0; k <= 12; ++k) {
    const auto far = Tolerance::asymptotic(40 * step, "1e-13 times twice the slope ln(1e-13)");
    EHD_CHECK(std::abs(in[k] - at[k]), far);
    EHD_CHECK(std::abs(out[k] - at[k]), far);
  }
}

BOOST_AUTO_TEST_SUITE_END()
