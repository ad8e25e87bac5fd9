// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/lu_factors.hpp"

#include <random>

#include "tests/check.hpp"

using namespace ehd;
using verification::Tolerance;

BOOST_AUTO_TEST_SUITE(lu_factors)

BOOST_AUTO_TEST_CASE(one_factorisation_solves_several_right_sides_to_rounding) {
  constexpr int size = 120;  // several of Eigen's blocks
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> number(-1, 1);
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return number(generator); });
  const LuFactors factors(matrix);
  int right_sides = 0;
  for (const double last : {2.0, -1.0}) {
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(size, 1, last), x = factors.solve(b);
    const double scale = matrix.cwiseAbs().rowwise().sum().maxCoeff() * x.cwiseAbs().maxCoeff();
    EHD_CHECK((b - matrix * x).cwiseAbs().maxCoeff() / scale, Tolerance::round_off(size));
    ++right_sides;
  }
  BOOST_REQUIRE_EQUAL(right_sides, 2);
}

BOOST_AUTO_TEST_CASE(a_singular_matrix_has_no_finite_solution) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Ones(3, 3);
  matrix(0, 0) = 2;
  BOOST_TEST(!LuFactors(matrix).solve(Eigen::VectorXd::LinSpaced(3, 1, 2)).allFinite());
}

BOOST_AUTO_TEST_SUITE_END()
