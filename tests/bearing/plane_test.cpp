// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/plane.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/check.hpp"

namespace ehd::bearing {

using verification::Tolerance;

namespace {

/// Matrices of both signs, with nearly equal eigenvalues, nearly singular, and with entries of very different size.
std::vector<Symmetric2> matrices() {
  std::vector<Symmetric2> all;
  for (const double xx : {1.7, 3.1e9, -2.4, 1e-12})
    for (const double yy : {1.7, 0.3, 2.9e9, 5e-9, -7.0})
      for (const double xy : {0.0, 1e-9, -0.61, 4.4e8, -1.9}) all.push_back({xx, xy, yy});
  // Rollers at some azimuths, so close together that the ring has hardly a stiffness across.
  for (const double apart : {1e-7, 1e-4, 0.3, 1.5}) {
    Symmetric2 stiffness;
    for (const double psi : {0.4, 0.4 + apart}) stiffness.add(2.7e9, {std::cos(psi), std::sin(psi)});
    all.push_back(stiffness);
  }
  return all;
}

Eigen::Matrix2d full(const Symmetric2& a) { return Eigen::Matrix2d{{a.xx, a.xy}, {a.xy, a.yy}}; }
Eigen::Vector2d full(Vector2 v) { return {v.x, v.y}; }

}  // namespace

BOOST_AUTO_TEST_SUITE(plane)

// Agreement: Eigen's general solver.
BOOST_AUTO_TEST_CASE(principal_directions_are_those_of_a_general_solver) {
  int judged = 0;
  for (const Symmetric2& matrix : matrices()) BOOST_TEST_CONTEXT(matrix.xx << " " << matrix.xy << " " << matrix.yy) {
      const Principal found = principal(matrix);
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> general(full(matrix));
      const bool last_first = std::abs(general.eigenvalues()[1]) >= std::abs(general.eigenvalues()[0]);
      const double size = general.eigenvalues().cwiseAbs().maxCoeff();
      for (const Eigen::Index k : {0, 1}) {
        const Eigen::Index there = last_first ? 1 - k : k;
        const auto here = static_cast<std::size_t>(k);
        EHD_CHECK(std::abs(found.values[here] - general.eigenvalues()[there]) / size, Tolerance::round_off(10));
        // A direction is known to the rounding of the matrix over the gap between the eigenvalues.
        const double gap = std::abs(general.eigenvalues()[1] - general.eigenvalues()[0]);
        if (!(gap > 1e-12 * size)) continue;
        const double along = full(found.axes[here]).dot(general.eigenvectors().col(there));
        EHD_CHECK(std::abs(std::abs(along) - 1), Tolerance::round_off(10));
        const double across = full(found.axes[1 - here]).dot(general.eigenvectors().col(there));
        EHD_CHECK(std::abs(across), Tolerance::round_off(10, size / gap));
        ++judged;
      }
    }
  BOOST_TEST(judged > 100);
}

// Exact: A = Sum value n n', n of length one and at right angles.
BOOST_AUTO_TEST_CASE(principal_directions_give_back_the_matrix) {
  for (const Symmetric2& matrix : matrices()) {
    const Principal found = principal(matrix);
    EHD_CHECK(error(norm(found.axes[0]), 1), Tolerance::round_off(4));
    BOOST_TEST(dot(found.axes[0], found.axes[1]) == 0);
    Symmetric2 again;
    for (const std::size_t k : {0u, 1u}) again.add(found.values[k], found.axes[k]);
    const double size = std::abs(found.values[0]);
    for (const double off : {again.xx - matrix.xx, again.xy - matrix.xy, again.yy - matrix.yy})
      EHD_CHECK(std::abs(off) / size, Tolerance::round_off(10));
  }
}

// Exact: the smaller eigenvalue keeps its digits beside one that is 1e12 times larger. [1+a a; a a], a = 2^-40: the
// determinant is a, and the larger eigenvalue 1 + a + a^2 + O(a^3).
BOOST_AUTO_TEST_CASE(the_smaller_eigenvalue_keeps_its_digits) {
  const double a = std::ldexp(1, -40);
  EHD_CHECK(error(principal({1 + a, a, a}).values[1], a / (1 + a)), Tolerance::round_off(4));
  // [u 1; 1 2-u], u = 1 + 2^-30: the determinant is -2^-60, the larger eigenvalue 2 + 2^-61 but for smaller terms.
  const double u = 1 + std::ldexp(1, -30);
  EHD_CHECK(error(principal({u, 1, 2 - u}).values[1], -std::ldexp(1, -61)), Tolerance::round_off(4));
}

// Agreement: Eigen's complete orthogonal decomposition, and the four conditions of Moore and Penrose.
BOOST_AUTO_TEST_CASE(the_pseudo_inverse_is_that_of_a_general_decomposition) {
  int singular = 0;
  std::vector<Symmetric2> all = matrices();
  for (const double psi : {0.0, 0.3, 1.1, 2.9}) {  // one roller carries: no stiffness across
    Symmetric2 one;
    one.add(3.7e9, {std::cos(psi), std::sin(psi)});
    all.push_back(one);
  }
  all.push_back({4.2e8, 0, 0});
  all.push_back({});
  for (const Symmetric2& matrix : all) BOOST_TEST_CONTEXT(matrix.xx << " " << matrix.xy << " " << matrix.yy) {
      const Eigen::Matrix2d A = full(matrix), found = full(pseudo_inverse(matrix));
      const auto general = A.completeOrthogonalDecomposition();
      const Eigen::Matrix2d there = general.pseudoInverse();
      singular += general.rank() < 2;
      const double size = there.norm(), condition = std::max(1.0, A.norm() * size);
      if (size == 0) {
        BOOST_TEST(found.norm() == 0);
        continue;
      }
      EHD_CHECK((found - there).norm() / size, Tolerance::round_off(20, condition));
      EHD_CHECK((A * found * A - A).norm() / A.norm(), Tolerance::round_off(20, condition));
      EHD_CHECK((found * A * found - found).norm() / size, Tolerance::round_off(20, condition));
    }
  BOOST_TEST(singular >= 5);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::bearing
