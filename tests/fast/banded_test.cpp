// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/banded.hpp"

#include <Eigen/Dense>
#include <random>

#include "tests/check.hpp"

using namespace ehd;
using verification::Tolerance;

BOOST_AUTO_TEST_SUITE(banded)

BOOST_AUTO_TEST_CASE(banded_solve_equals_a_dense_one) {
  constexpr int n = 40;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  fast::Banded band;
  band.resize(n);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < fast::Banded::width; ++k) {
      const int j = i - fast::Banded::lower + k;
      const double value = uniform(random) + (j == i ? 6 : 0);
      band.row(i)[static_cast<std::size_t>(k)] = value;
      if (j >= 0 && j < n) dense(i, j) = value;
    }
  }
  Array x(n);
  for (int i = 0; i < n; ++i) x[i] = uniform(random);
  const Eigen::VectorXd expected = dense.partialPivLu().solve(x.matrix());
  BOOST_REQUIRE(band.factorise());
  band.solve(x);
  EHD_CHECK((x.matrix() - expected).norm() / expected.norm(), Tolerance::round_off(n, 10));
}

BOOST_AUTO_TEST_CASE(a_vanishing_pivot_is_refused) {
  fast::Banded band;
  band.resize(3);
  for (int i = 0; i < 3; ++i) band.row(i) = {0, 0, 0, 1, 0, 0};
  band.row(1)[fast::Banded::lower] = 0;
  band.row(1)[fast::Banded::lower + 1] = 1;
  BOOST_CHECK(!band.factorise());
}

BOOST_AUTO_TEST_SUITE_END()
