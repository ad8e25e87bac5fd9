// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/profile.hpp"

#include <cmath>
#include <stdexcept>

#include "contact/legendre.hpp"
#include "tests/check.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

/// f on elements of one degree with these ends.
template <class Function>
Profile on_elements(const std::vector<double>& ends, int degree, const Function& f) {
  const VectorOf<double> t = lobatto_nodes<double>(degree);
  const auto elements = static_cast<Eigen::Index>(ends.size()) - 1;
  Array X(elements * degree + 1);
  std::vector<Eigen::Index> begins;
  for (Eigen::Index k = 0; k < elements; ++k) {
    begins.push_back(k * degree);
    const double left = ends[static_cast<std::size_t>(k)], right = ends[static_cast<std::size_t>(k) + 1];
    for (int j = 0; j <= degree; ++j) X[k * degree + j] = j == degree ? right : left + (right - left) * (t[j] + 1) / 2;
  }
  begins.push_back(elements * degree);
  return {X, X.unaryExpr(f), begins};
}

template <class Function>
Profile on_lines(double left, double right, int intervals, const Function& f) {
  const Array X = Array::LinSpaced(intervals + 1, left, right);
  return {X, X.unaryExpr(f)};
}

constexpr auto square = [](double x) { return x * x; };

constexpr double sums = 1e4;  // additions and evaluations in one norm here, generously

}  // namespace

BOOST_AUTO_TEST_SUITE(profile)

BOOST_AUTO_TEST_CASE(chords_of_a_parabola_are_off_by_what_the_formula_says) {
  // The error of a chord of x^2 on a cell h is (x - a)(b - x), of squared norm h^5/30; ||x^2||^2 = 1/5 on [0, 1].
  const Profile truth = on_elements({0, 0.31, 1}, 2, square);
  for (const int intervals : {1, 7, 64}) {
    const double h = 1.0 / intervals;
    EHD_CHECK(error(relative_l2_error(on_lines(0, 1, intervals, square), truth), h * h / std::sqrt(6.0)),
              Tolerance::round_off(sums));
  }
}

BOOST_AUTO_TEST_CASE(only_the_common_interval_counts) {
  // On [0, 1] the profile is 3 and the truth 2; outside they are wild.
  Array X(4), P(4);
  X << -2, 0, 1, 1.5;
  P << 90, 3, 3, -70;
  const Profile truth = on_elements({0, 0.2, 1}, 5, [](double) { return 2.0; });
  EHD_CHECK(error(relative_l2_error({X, P}, truth), 0.5), Tolerance::round_off(sums));
  EHD_CHECK(error(relative_l2_error(truth, {X, P}), 1.0 / 3), Tolerance::round_off(sums));
}

BOOST_AUTO_TEST_CASE(polynomials_of_different_degree_and_mesh_are_the_same_function) {
  const auto f = [](double x) { return ((0.3 * x - 1.1) * x + 0.7) * x + 2; };
  const double apart = relative_l2_error(on_elements({-1, 0.1, 0.100001, 2}, 3, f), on_elements({-1, 0.7, 2}, 9, f));
  EHD_CHECK(apart, Tolerance::round_off(sums));
}

BOOST_AUTO_TEST_CASE(a_narrow_spike_is_seen_by_the_integral_whatever_the_other_grid) {
  // A hat of height 1 and half width w on top of 1: ||hat||^2 = 2w/3, ||1||^2 = 2 on [-1, 1].
  constexpr double w = 1e-7;
  Array X(5), P(5);
  X << -1, 0.5 - w, 0.5, 0.5 + w, 1;
  P << 1, 1, 2, 1, 1;
  const Profile flat = on_lines(-1, 1, 10, [](double) { return 1.0; });
  EHD_CHECK(error(relative_l2_error({X, P}, flat), std::sqrt(w / 3)), Tolerance::round_off(sums, 1 / w));
}

BOOST_AUTO_TEST_CASE(the_value_of_a_piece_is_that_of_its_polynomial) {
  const auto f = [](double x) { return std::pow(x, 6) - x; };
  const Profile six = on_elements({-0.5, 1.5}, 6, f);
  for (const double x : {-0.5, -0.2, 0.4, 1.5}) EHD_CHECK(std::abs(six.value(0, x) - f(x)), Tolerance::round_off(500));
  BOOST_TEST(six.degree() == 6);
}

BOOST_AUTO_TEST_CASE(profiles_without_a_common_interval_have_no_distance) {
  BOOST_TEST(std::isnan(relative_l2_error(on_lines(0, 1, 3, square), on_lines(1, 2, 3, square))));
  BOOST_TEST(std::isnan(relative_l2_error(on_lines(0, 1, 3, square), on_lines(0, 1, 3, [](double) { return 0.0; }))));
}

BOOST_AUTO_TEST_CASE(what_is_no_profile_is_refused) {
  BOOST_CHECK_THROW(Profile(Array::LinSpaced(3, 0, 1), Array::Zero(4)), std::invalid_argument);
  BOOST_CHECK_THROW(Profile(Array::Zero(1), Array::Zero(1)), std::invalid_argument);
  BOOST_CHECK_THROW(Profile(Array::LinSpaced(4, 0, 1), Array::Zero(4), {0, 2}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
