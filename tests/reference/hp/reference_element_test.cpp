// SPDX-License-Identifier: GPL-3.0-or-later
// Collocation points and the element's matrices, in double and with 34 digits.
#include "reference/hp/reference_element.hpp"

#include "tests/check.hpp"
#include "tests/quad.hpp"

namespace {

using namespace ehd;
using namespace ehd::reference::hp;
using namespace ehd::testing;
using verification::Tolerance;

constexpr int largest_degree = 20;

/// The weights that make the points a quadrature rule (Radau's with its fixed point at -1, or Gauss').
template <class Scalar>
VectorOf<Scalar> quadrature_weights(Points kind, const VectorOf<Scalar>& points) {
  const auto p = static_cast<int>(points.size());
  VectorOf<Scalar> weights(p);
  for (int i = 0; i < p; ++i) {
    const Scalar t(points[i]);
    if (kind == Points::left_radau) {
      const Scalar P = legendre(p - 1, t)[p - 1];
      weights[i] = (1 - t) / (Scalar(p * p) * P * P);
    } else {
      const Scalar slope = legendre_derivatives(p, t)[p];
      weights[i] = 2 / ((1 - t * t) * slope * slope);
    }
  }
  return weights;
}

template <class Scalar>
void check_rule(Points kind, int exact_to_twice_p_minus) {
  int rows = 0;
  for (int p = 1; p <= largest_degree; ++p) {
    const VectorOf<Scalar> points = collocation_points<Scalar>(kind, p);
    BOOST_REQUIRE_EQUAL(points.size(), p);
    for (int i = 0; i + 1 < p; ++i) BOOST_TEST(bool(points[i] < points[i + 1]));
    const VectorOf<Scalar> weights = quadrature_weights(kind, points);
    const auto rule = [&](int k) {
      Scalar sum(0);
      for (int i = 0; i < p; ++i) sum += weights[i] * power(Scalar(points[i]), k);
      return sum;
    };
    BOOST_TEST_CONTEXT("degree " << p) {
      for (int k = 0; k <= 2 * p - exact_to_twice_p_minus; ++k) {
        const Scalar integral = k % 2 == 0 ? Scalar(2) / Scalar(k + 1) : Scalar(0);
        // The weights feel their point's rounding p^2 times at the crowded ends, where they are as much smaller.
        EHD_CHECK(as_in_double(Scalar(rule(k) - integral)), Tolerance::round_off(20.0 + 4 * p));
        ++rows;
      }
    }
  }
  BOOST_TEST(rows == (exact_to_twice_p_minus == 1 ? 420 : 400));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hp_reference_element)

BOOST_AUTO_TEST_CASE_TEMPLATE(left_radau_points_of_low_degree_are_the_printed_ones, Scalar, Scalars) {
  using std::sqrt;
  const Scalar one(1), root = sqrt(Scalar(6));
  const auto check = [](const std::vector<Scalar>& points) {
    const int degree = static_cast<int>(points.size());
    const VectorOf<Scalar> found = collocation_points<Scalar>(Points::left_radau, degree);
    BOOST_REQUIRE_EQUAL(found.size(), degree);
    BOOST_TEST(bool(found[0] == Scalar(-1)));  // the upwind end itself
    for (int i = 0; i < degree; ++i)
      EHD_CHECK(as_in_double(Scalar(found[i] - points[static_cast<std::size_t>(i)])), Tolerance::round_off(4));
  };
  check({-one});
  check({-one, one / 3});
  check({-one, (1 - root) / 5, (1 + root) / 5});
}

BOOST_AUTO_TEST_CASE_TEMPLATE(gauss_points_of_low_degree_are_the_printed_ones, Scalar, Scalars) {
  using std::sqrt;
  const auto points = [](int p) { return collocation_points<Scalar>(Points::gauss, p); };
  EHD_CHECK(as_in_double(points(1)[0]), Tolerance::round_off(1));
  EHD_CHECK(as_in_double(Scalar(points(2)[1] - 1 / sqrt(Scalar(3)))), Tolerance::round_off(4));
  EHD_CHECK(as_in_double(Scalar(points(3)[0] + sqrt(Scalar(3) / 5))), Tolerance::round_off(4));
  EHD_CHECK(as_in_double(points(3)[1]), Tolerance::round_off(4));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(left_radau_points_are_the_rule_exact_to_degree_2p_minus_2, Scalar, Scalars) {
  check_rule<Scalar>(Points::left_radau, 2);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(gauss_points_are_the_rule_exact_to_degree_2p_minus_1, Scalar, Scalars) {
  check_rule<Scalar>(Points::gauss, 1);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(left_radau_points_are_the_zeros_of_their_polynomial, Scalar, Scalars) {
  for (int p = 1; p <= largest_degree; ++p) {
    const VectorOf<Scalar> points = collocation_points<Scalar>(Points::left_radau, p);
    for (int i = 0; i < p; ++i) {
      const Scalar t(points[i]);
      const VectorOf<Scalar> P = legendre(p, t), slope = legendre_derivatives(p, t);
      // The distance to the zero by the polynomial's own slope; P_k is wrong by k eps where zeros crowd.
      EHD_CHECK(as_in_double(Scalar((P[p] + P[p - 1]) / (slope[p] + slope[p - 1]))), Tolerance::round_off(8));
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(an_element_knows_a_polynomial_of_its_degree_and_its_slope, Scalar, Scalars) {
  int rows = 0;
  for (const Points kind : {Points::left_radau, Points::gauss}) {
    for (const int p : {2, 3, 8, 12, 15, 20}) {
      const auto element = reference_element<Scalar>(kind, p);
      BOOST_TEST_CONTEXT("degree " << p) {
        BOOST_REQUIRE_EQUAL(element.degree, p);
        // (t + 0.3)^p/1.3^p, no symmetry, of size 1; slopes of size p/1.3 at the end.
        const auto f = [p](const Scalar& t) { return power(Scalar((t + Scalar(3) / 10) / (Scalar(13) / 10)), p); };
        const auto slope = [p](const Scalar& t) {
          return Scalar(p) / (Scalar(13) / 10) * power(Scalar((t + Scalar(3) / 10) / (Scalar(13) / 10)), p - 1);
        };
        VectorOf<Scalar> nodal(p + 1), values(p), slopes(p);
        for (int j = 0; j <= p; ++j) nodal[j] = f(Scalar(element.nodes[j]));
        for (int i = 0; i < p; ++i) {
          values[i] = f(Scalar(element.points[i]));
          slopes[i] = slope(Scalar(element.points[i]));
        }
        const VectorOf<Scalar> at_points = element.at_points * nodal, slope_at_points = element.slope_at_points * nodal;
        EHD_CHECK(as_in_double(Scalar((at_points - values).cwiseAbs().maxCoeff())), Tolerance::round_off(4.0 * p));
        // Markov: slopes of a polynomial of size 1 are p^2 at most, and so is what rounding makes of them.
        EHD_CHECK(as_in_double(Scalar((slope_at_points - slopes).cwiseAbs().maxCoeff())),
                  Tolerance::round_off(4.0 * p, p * p));
        EHD_CHECK(as_in_double(Scalar(element.slope_at_right.dot(nodal) - slope(Scalar(1)))),
                  Tolerance::round_off(4.0 * p, p * p));
        EHD_CHECK(as_in_double(Scalar(element.slope_at_left.dot(nodal) - slope(Scalar(-1)))),
                  Tolerance::round_off(4.0 * p, p * p));
        // The pressure at t = -1 is that of the node, exactly: neighbours must agree on it.
        if (kind == Points::left_radau) BOOST_TEST(bool(at_points[0] == nodal[0]));
        Scalar integral(0);
        for (int j = 0; j <= p; ++j) integral += element.weights[j] * nodal[j];
        const Scalar exact = (Scalar(13) / 10) / Scalar(p + 1) * (Scalar(1) - power(Scalar(Scalar(-7) / 13), p + 1));
        EHD_CHECK(as_in_double(Scalar(integral - exact)), Tolerance::round_off(4.0 * p));
      }
      ++rows;
    }
  }
  BOOST_TEST(rows == 12);
}

BOOST_AUTO_TEST_SUITE_END()
