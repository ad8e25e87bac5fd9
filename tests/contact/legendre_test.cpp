// SPDX-License-Identifier: GPL-3.0-or-later
// Legendre polynomials and the Lobatto nodes, in double and with 34 digits: errors are in units of either type's eps.
#include "contact/legendre.hpp"

#include "tests/check.hpp"
#include "tests/quad.hpp"

namespace {

using namespace ehd;
using namespace ehd::testing;
using verification::Tolerance;

constexpr int largest_degree = 20;

/// Int_-1^1 t^k dt.
template <class Scalar>
Scalar integral_of_power(int k) {
  return k % 2 == 0 ? Scalar(2) / Scalar(k + 1) : Scalar(0);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(legendre)

BOOST_AUTO_TEST_CASE_TEMPLATE(polynomials_and_their_slopes_are_the_printed_ones, Scalar, Scalars) {
  int rows = 0;
  for (const double place : {-1.0, -0.83, -0.1, 0.0, 0.3, 0.77, 1.0, 1.7}) {
    const Scalar t(place), t2 = t * t;
    const VectorOf<Scalar> P = ehd::legendre(5, t), slope = legendre_derivatives(5, t);
    BOOST_TEST_CONTEXT("t = " << place) {
      EHD_CHECK(as_in_double(Scalar(P[0] - Scalar(1))), Tolerance::round_off(0));
      EHD_CHECK(as_in_double(Scalar(P[2] - (3 * t2 - 1) / 2)), Tolerance::round_off(10));
      EHD_CHECK(as_in_double(Scalar(P[5] - (63 * t2 * t2 - 70 * t2 + 15) * t / 8)), Tolerance::round_off(20, 30));
      EHD_CHECK(as_in_double(Scalar(slope[5] - (315 * t2 * t2 - 210 * t2 + 15) / 8)), Tolerance::round_off(20, 200));
      EHD_CHECK(as_in_double(Scalar(slope[4] - (140 * t2 - 60) * t / 8)), Tolerance::round_off(20, 40));
    }
    ++rows;
  }
  BOOST_TEST(rows == 8);
  for (int k = 0; k <= largest_degree; ++k) {
    const VectorOf<Scalar> left = legendre_derivatives(k, Scalar(-1));
    EHD_CHECK(as_in_double(Scalar(left[k] - Scalar(k % 2 == 0 ? -1 : 1) * Scalar(k * (k + 1)) / 2)),
              Tolerance::round_off(1));  // whole numbers
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(the_last_values_alone_are_those_of_all_values_bit_for_bit, Scalar, Scalars) {
  for (int degree = 1; degree <= largest_degree; ++degree)
    for (const double place : {-1.0, -0.83, -0.1, 0.0, 0.3, 0.77, 1.0, 1.7}) {
      const auto [P, slope] = last_legendre(degree, Scalar(place));
      const bool same = P == ehd::legendre(degree, Scalar(place))[degree] &&
                        slope == legendre_derivatives(degree, Scalar(place))[degree];
      BOOST_TEST(same, "degree " << degree << ", t = " << place);
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(lobatto_nodes_of_low_degree_are_the_printed_ones, Scalar, Scalars) {
  using std::sqrt;
  const Scalar one(1);
  const auto check = [](const std::vector<Scalar>& nodes, const std::vector<Scalar>& weights) {
    const int degree = static_cast<int>(nodes.size()) - 1;
    const VectorOf<Scalar> found = lobatto_nodes<Scalar>(degree), found_weights = lobatto_weights(degree, found);
    BOOST_REQUIRE_EQUAL(found.size(), degree + 1);
    for (int j = 0; j <= degree; ++j) {
      BOOST_TEST_CONTEXT("degree " << degree << ", node " << j) {
        const auto at = static_cast<std::size_t>(j);
        EHD_CHECK(as_in_double(Scalar(found[j] - nodes[at])), Tolerance::round_off(4));
        EHD_CHECK(as_in_double(Scalar(found_weights[j] - weights[at])), Tolerance::round_off(8));
      }
    }
  };
  check({-one, one}, {one, one});
  check({-one, Scalar(0), one}, {one / 3, 4 * one / 3, one / 3});
  const Scalar a = 1 / sqrt(5 * one), b = sqrt(3 * one / 7);
  check({-one, -a, a, one}, {one / 6, 5 * one / 6, 5 * one / 6, one / 6});
  check({-one, -b, Scalar(0), b, one}, {one / 10, 49 * one / 90, 32 * one / 45, 49 * one / 90, one / 10});
}

BOOST_AUTO_TEST_CASE_TEMPLATE(lobatto_rule_is_exact_to_degree_2p_minus_1_and_no_further, Scalar, Scalars) {
  int rows = 0;
  for (int p = 1; p <= largest_degree; ++p) {
    const VectorOf<Scalar> nodes = lobatto_nodes<Scalar>(p), weights = lobatto_weights(p, nodes);
    BOOST_TEST_CONTEXT("degree " << p) {
      BOOST_TEST(bool((nodes.array() + nodes.reverse().array()).abs().maxCoeff() <=
                      Scalar(4) * std::numeric_limits<Scalar>::epsilon()));
      for (int j = 0; j < p; ++j) BOOST_TEST(bool(nodes[j] < nodes[j + 1]));
      for (int k = 0; k <= 2 * p - 1; ++k) {
        Scalar sum(0);
        for (int j = 0; j <= p; ++j) sum += weights[j] * power(Scalar(nodes[j]), k);
        // Weights sum to 2, and t^k is wrong by k eps.
        EHD_CHECK(as_in_double(Scalar(sum - integral_of_power<Scalar>(k))), Tolerance::round_off(2.0 * p + 10));
        ++rows;
      }
      // P_p^2, of degree 2p: the rule gives 2/p for 2/(2p+1).
      Scalar square(0);
      for (int j = 0; j <= p; ++j) {
        const Scalar P = ehd::legendre(p, Scalar(nodes[j]))[p];
        square += weights[j] * P * P;
      }
      EHD_CHECK(as_in_double(Scalar(square * p / 2 - 1)), Tolerance::round_off(20));
    }
  }
  BOOST_TEST(rows == 420);  // Sum 2p
}

BOOST_AUTO_TEST_CASE_TEMPLATE(coefficients_of_values_at_the_nodes_invert_the_sum_of_polynomials, Scalar, Scalars) {
  for (int p = 1; p <= largest_degree; ++p) {
    const VectorOf<Scalar> nodes = lobatto_nodes<Scalar>(p);
    MatrixOf<Scalar> values(p + 1, p + 1);  // of P_k at node j
    for (int j = 0; j <= p; ++j) values.row(j) = ehd::legendre(p, Scalar(nodes[j])).transpose();
    const MatrixOf<Scalar> product = lobatto_to_legendre(p, nodes) * values;
    BOOST_TEST_CONTEXT("degree " << p) {
      // A coefficient is a sum of p + 1 products, times k + 1/2.
      EHD_CHECK(as_in_double(Scalar((product - MatrixOf<Scalar>::Identity(p + 1, p + 1)).cwiseAbs().maxCoeff())),
                Tolerance::round_off(10, p));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
