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

BOOST_AUTO_TEST_CASE(two_factorisations_in_turn_are_those_one_after_the_other) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  fast::Banded bands[2];
  for (fast::Banded& band : bands) {
    band.resize(&band == bands ? 40 : 17);
    for (int i = 0; i < band.rows(); ++i) {
      for (double& entry : band.row(i)) entry = uniform(random);
      band.row(i)[fast::Banded::lower] += 6;
    }
  }
  fast::Banded alone[2] = {bands[0], bands[1]};
  fast::Banded::Factorisation longer(bands[0]), shorter(bands[1]);
  while (shorter.next()) BOOST_REQUIRE(longer.next());
  while (longer.next()) {
  }
  BOOST_TEST(longer.succeeded());
  BOOST_TEST(shorter.succeeded());
  for (int k = 0; k < 2; ++k) {
    BOOST_REQUIRE(alone[k].factorise());
    for (int i = 0; i < alone[k].rows(); ++i) BOOST_TEST(bands[k].row(i) == alone[k].row(i));
  }
}

BOOST_AUTO_TEST_CASE(a_vanishing_pivot_is_refused) {
  fast::Banded band;
  band.resize(3);
  for (int i = 0; i < 3; ++i) band.row(i) = {0, 0, 0, 1, 0, 0};
  band.row(1)[fast::Banded::lower] = 0;
  band.row(1)[fast::Banded::lower + 1] = 1;
  BOOST_CHECK(!band.factorise());
  band.row(0) = band.row(2) = {0, 0, 0, 1, 0, 0};
  band.row(1) = {0, 0, 0, 1e-20, 1, 0};  // a pivot that vanishes without being 0: the row after it is sound
  fast::Banded::Factorisation again(band);
  while (again.next()) {
  }
  BOOST_TEST(!again.next());  // and stays refused
  BOOST_TEST(!again.succeeded());
}

BOOST_AUTO_TEST_SUITE_END()
