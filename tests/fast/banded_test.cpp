// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/banded.hpp"

#include <Eigen/Dense>
#include <random>
#include <tuple>

#include "tests/check.hpp"

using namespace ehd;
using verification::Tolerance;

BOOST_AUTO_TEST_SUITE(banded)

using Scalars = std::tuple<double, fast::Complex>;

BOOST_AUTO_TEST_CASE_TEMPLATE(banded_solve_equals_a_dense_one, Scalar, Scalars) {
  using Band = fast::BandedOf<Scalar>;
  constexpr int n = 40;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto number = [&] {
    if constexpr (std::is_same_v<Scalar, double>)
      return uniform(random);
    else
      return Scalar(uniform(random), uniform(random));
  };
  Band band;
  band.resize(n);
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> dense(n, n);
  dense.setZero();
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < Band::width; ++k) {
      const int j = i - Band::lower + k;
      const Scalar value = number() + (j == i ? 6.0 : 0.0);
      band.row(i)[static_cast<std::size_t>(k)] = value;
      if (j >= 0 && j < n) dense(i, j) = value;
    }
  }
  ArrayOf<Scalar> x(n);
  for (int i = 0; i < n; ++i) x[i] = number();
  const auto expected = dense.partialPivLu().solve(x.matrix()).eval();
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
