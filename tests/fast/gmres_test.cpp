// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/gmres.hpp"

#include <Eigen/LU>
#include <random>
#include <tuple>
#include <vector>

#include "tests/check.hpp"

using namespace ehd;
using verification::Tolerance;

BOOST_AUTO_TEST_SUITE(gmres)

using Scalars = std::tuple<double, fast::Complex>;

/// A dense matrix near the identity, and a preconditioner that changes from step to step.
BOOST_AUTO_TEST_CASE_TEMPLATE(the_residual_that_was_asked_for_is_reached, Scalar, Scalars) {
  constexpr int n = 30;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto number = [&] {
    if constexpr (std::is_same_v<Scalar, double>)
      return uniform(random);
    else
      return Scalar(uniform(random), uniform(random));
  };
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  const Matrix A = Matrix::Identity(n, n) * Scalar(2.0) + Matrix::NullaryExpr(n, n, [&] { return 0.1 * number(); });
  const ArrayOf<Scalar> b = ArrayOf<Scalar>::NullaryExpr(n, number);
  std::vector<ArrayOf<Scalar>> z;
  fast::GmresOf<Scalar> solver;
  const auto y = solver.solve(b, 1e-9, [&](std::size_t k, const ArrayOf<Scalar>& v, ArrayOf<Scalar>& w) {
    z.push_back(v / (1.0 + 0.1 * static_cast<double>(k)));
    w = (A * z.back().matrix()).array();
  });
  BOOST_TEST(y.size() < fast::GmresOf<Scalar>::most_steps);
  ArrayOf<Scalar> x = ArrayOf<Scalar>::Zero(n);
  for (std::size_t k = 0; k < y.size(); ++k) x += y[k] * z[k];
  EHD_CHECK((b.matrix() - A * x.matrix()).norm() / b.matrix().norm(),
            Tolerance::iteration(1e-9) + Tolerance::round_off(n));
}

BOOST_AUTO_TEST_SUITE_END()
