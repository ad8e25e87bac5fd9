// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/dense_lu.hpp"

#include <Eigen/LU>
#include <limits>
#include <random>

#include "tests/check.hpp"

using namespace ehd;
using fast::DenseLu;
using verification::Tolerance;

BOOST_AUTO_TEST_SUITE(dense_lu)

namespace {

/// Numbers in [-1, 1]; the diagonal is as small as the rest, so that a factorisation has to exchange rows.
Eigen::MatrixXd random_matrix(int size, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  return Eigen::MatrixXd::NullaryExpr(size, size, [&] { return number(generator); });
}

void fill(DenseLu& lu, const Eigen::MatrixXd& matrix) {
  const auto size = static_cast<int>(matrix.rows());
  lu.resize(size);
  for (int i = 0; i < size; ++i) Eigen::Map<Eigen::RowVectorXd>(lu.row(i), size) = matrix.row(i);
}

/// |b - A x| over |A| |x|, in the largest norm: what Gaussian elimination with row exchanges keeps at rounding.
double backward_error(const Eigen::MatrixXd& matrix, const Array& b, const Array& x) {
  const double scale = matrix.cwiseAbs().rowwise().sum().maxCoeff() * x.abs().maxCoeff();
  return (b.matrix() - matrix * x.matrix()).cwiseAbs().maxCoeff() / scale;
}

}  // namespace

BOOST_AUTO_TEST_CASE(solutions_leave_rounding_alone_as_those_of_Eigen_do) {
  DenseLu lu;
  int rows = 0;
  // Whole and broken blocks of rows and columns, the sizes of the coarsest grids (33 to 49, 65 to 97), one after the
  // other in the same storage.
  for (const int size : {1, 2, 3, 4, 5, 7, 8, 33, 34, 36, 49, 97, 64, 6}) {
    BOOST_TEST_CONTEXT("size " << size) {
      const Eigen::MatrixXd matrix = random_matrix(size, static_cast<unsigned>(size));
      const Array b = Array::LinSpaced(size, 1, 2);
      fill(lu, matrix);
      BOOST_REQUIRE(lu.factorise());
      Array x = b;
      lu.solve(x);
      // Eigen does the same operations in another order.
      const Array theirs = matrix.partialPivLu().solve(b.matrix()).array();
      EHD_CHECK(backward_error(matrix, b, x), Tolerance::round_off(size));
      EHD_CHECK(backward_error(matrix, b, theirs), Tolerance::round_off(size));
      ++rows;
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 14);
}

BOOST_AUTO_TEST_CASE(complex_solutions_leave_rounding_alone) {
  constexpr int size = 33;
  Eigen::MatrixXcd matrix(size, size);
  matrix.real() = random_matrix(size, 1);
  matrix.imag() = random_matrix(size, 2);
  fast::DenseLuOf<fast::Complex> lu;
  lu.resize(size);
  for (int i = 0; i < size; ++i) Eigen::Map<Eigen::RowVectorXcd>(lu.row(i), size) = matrix.row(i);
  BOOST_REQUIRE(lu.factorise());
  const Eigen::ArrayXcd b = Eigen::ArrayXcd::LinSpaced(size, 1, fast::Complex(2, 3));
  Eigen::ArrayXcd x = b;
  lu.solve(x);
  const double scale = matrix.cwiseAbs().rowwise().sum().maxCoeff() * x.abs().maxCoeff();
  EHD_CHECK((b.matrix() - matrix * x.matrix()).cwiseAbs().maxCoeff() / scale, Tolerance::round_off(size));
}

BOOST_AUTO_TEST_CASE(a_zero_on_the_diagonal_is_exchanged) {
  DenseLu lu;
  fill(lu, (Eigen::Matrix3d() << 0, 2, 0, 0, 0, 4, 8, 0, 0).finished());
  BOOST_REQUIRE(lu.factorise());
  Array x = (Array(3) << 2, 12, 32).finished();
  lu.solve(x);
  BOOST_CHECK_EQUAL(x[0], 4);
  BOOST_CHECK_EQUAL(x[1], 1);
  BOOST_CHECK_EQUAL(x[2], 3);
}

BOOST_AUTO_TEST_CASE(singular_and_infinite_matrices_are_refused_and_leave_nothing_behind) {
  const int size = 33;
  const Eigen::MatrixXd matrix = random_matrix(size, 5);
  const Array b = Array::LinSpaced(size, 1, 2);
  DenseLu fresh;
  fill(fresh, matrix);
  BOOST_REQUIRE(fresh.factorise());
  Array expected = b;
  fresh.solve(expected);

  DenseLu lu;
  int rows = 0;
  const double infinite = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, infinite, -infinite, nan}) {
    for (const int column : {0, 1, 17, 31, 32}) {
      BOOST_TEST_CONTEXT("column " << column << ": " << bad) {
        Eigen::MatrixXd wrong = matrix;
        if (bad == 0) wrong.col(column).setZero();
        wrong(11, column) = bad;
        fill(lu, wrong);
        BOOST_CHECK(!lu.factorise());
        fill(lu, matrix);
        BOOST_REQUIRE(lu.factorise());
        Array x = b;
        lu.solve(x);
        BOOST_CHECK((x == expected).all());
        ++rows;
      }
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 20);
}

BOOST_AUTO_TEST_SUITE_END()
