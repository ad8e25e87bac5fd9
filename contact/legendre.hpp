// SPDX-License-Identifier: GPL-3.0-or-later
// Legendre polynomials in any real scalar type, and the Lobatto nodes on which a polynomial element keeps its values.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "contact/array.hpp"

namespace ehd {

template <class Scalar>
using VectorOf = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
template <class Scalar>
using MatrixOf = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// P_0 … P_degree at t.
template <class Scalar>
[[nodiscard]] VectorOf<Scalar> legendre(int degree, const Scalar& t) {
  VectorOf<Scalar> P(degree + 1);
  P[0] = Scalar(1);
  if (degree > 0) P[1] = t;
  for (int k = 1; k < degree; ++k) P[k + 1] = (Scalar(2 * k + 1) * t * P[k] - Scalar(k) * P[k - 1]) / Scalar(k + 1);
  return P;
}

/// P_0' … P_degree' at t, by P'_(k+1) = P'_(k-1) + (2k+1) P_k.
template <class Scalar>
[[nodiscard]] VectorOf<Scalar> legendre_derivatives(int degree, const Scalar& t) {
  const VectorOf<Scalar> P = legendre(degree, t);
  VectorOf<Scalar> slope = VectorOf<Scalar>::Zero(degree + 1);
  if (degree > 0) slope[1] = Scalar(1);
  for (int k = 1; k < degree; ++k) slope[k + 1] = slope[k - 1] + Scalar(2 * k + 1) * P[k];
  return slope;
}

/// P_degree and P_degree' at t, for degree 1 and above: the last values of the two functions above, bit for bit.
template <class Scalar>
[[nodiscard]] std::pair<Scalar, Scalar> last_legendre(int degree, const Scalar& t) {
  Scalar P_before(1), P(t), slope_before(0), slope(1);
  for (int k = 1; k < degree; ++k) {
    slope_before = std::exchange(slope, Scalar(slope_before + Scalar(2 * k + 1) * P));
    P_before = std::exchange(P, Scalar((Scalar(2 * k + 1) * t * P - Scalar(k) * P_before) / Scalar(k + 1)));
  }
  return {P, slope};
}

namespace detail {

/// Newton's method doubles the digits each time, so that starts good to 1e-3 need at most seven steps in any type used
/// here; the others are spare. It has settled when a step is less than this many units of rounding.
inline constexpr int most_newton_steps = 12, settled_roundings = 4;
/// An interval of length 2, halved so often, is shorter than the rounding of a double.
inline constexpr int bisections = 60;
/// The search for zeros takes this many cells for each zero, as if there were this many zeros more.
inline constexpr int cells_per_zero = 40, spare_zeros = 2;
/// The cells are shifted by this part of one, so that none ends at 0, where odd functions have a zero.
inline constexpr double cell_shift = 0.37;

/// The zero of f near `start` by Newton's method; f returns value and derivative.
template <class Scalar, class Function>
Scalar refined_zero(double start, const Function& f) {
  using std::abs;
  Scalar t(start);
  for (int step = 0; step < most_newton_steps; ++step) {
    const auto [value, slope] = f(t);
    const Scalar move = value / slope;
    t -= move;
    if (abs(move) < Scalar(settled_roundings) * std::numeric_limits<Scalar>::epsilon()) break;
  }
  return t;
}

/// A zero of f between a and b by bisection: the start of Newton's method.
template <class Function>
double bisected(const Function& f, double a, double b) {
  const bool rising = f(a) < 0;
  for (int step = 0; step < bisections; ++step) {
    const double middle = (a + b) / 2;
    if ((f(middle) < 0) == rising)
      a = middle;
    else
      b = middle;
  }
  return (a + b) / 2;
}

/// All sign changes of f inside (-1, 1) on a grid that is fine at the ends, where zeros crowd.
template <class Function>
std::vector<double> sign_changes(const Function& f, int count) {
  std::vector<double> zeros;
  const int cells = cells_per_zero * (count + spare_zeros);
  const auto at = [&](int i) { return -std::cos(std::numbers::pi * (i + cell_shift) / (cells + 2 * cell_shift)); };
  bool negative = f(at(0)) < 0;
  for (int i = 0; i < cells; ++i) {
    const bool was_negative = std::exchange(negative, f(at(i + 1)) < 0);
    if (negative != was_negative) zeros.push_back(bisected(f, at(i), at(i + 1)));
  }
  return zeros;
}

}  // namespace detail

/// Gauss-Legendre-Lobatto nodes: -1, the zeros of P_p', 1.
template <class Scalar>
[[nodiscard]] VectorOf<Scalar> lobatto_nodes(int degree) {
  const auto with_slope = [&](const Scalar& t) {
    const auto [P, slope] = last_legendre(degree, t);
    // Legendre's equation: (1 - t^2) P'' = 2 t P' - p (p+1) P.
    return std::pair<Scalar, Scalar>(slope,
                                     (Scalar(2) * t * slope - Scalar(degree * (degree + 1)) * P) / (Scalar(1) - t * t));
  };
  const auto starts = detail::sign_changes([&](double t) { return last_legendre(degree, t).second; }, degree - 1);
  VectorOf<Scalar> nodes(degree + 1);
  nodes[0] = Scalar(-1);
  nodes[degree] = Scalar(1);
  for (int k = 1; k < degree; ++k)
    nodes[k] = detail::refined_zero<Scalar>(starts[static_cast<std::size_t>(k - 1)], with_slope);
  return nodes;
}

/// Lobatto weights of the nodes, exact for degree 2 p - 1.
template <class Scalar>
[[nodiscard]] VectorOf<Scalar> lobatto_weights(int degree, const VectorOf<Scalar>& nodes) {
  VectorOf<Scalar> weights(degree + 1);
  for (int j = 0; j <= degree; ++j) {
    const Scalar P = legendre(degree, Scalar(nodes[j]))[degree];
    weights[j] = Scalar(2) / (Scalar(degree * (degree + 1)) * P * P);
  }
  return weights;
}

/// Values at the Lobatto nodes -> coefficients of P_0 … P_p.
template <class Scalar>
[[nodiscard]] MatrixOf<Scalar> lobatto_to_legendre(int degree, const VectorOf<Scalar>& nodes) {
  const VectorOf<Scalar> weights = lobatto_weights(degree, nodes);
  MatrixOf<Scalar> to_legendre(degree + 1, degree + 1);
  for (int j = 0; j <= degree; ++j) {
    const VectorOf<Scalar> P = legendre(degree, Scalar(nodes[j]));
    for (int k = 0; k <= degree; ++k) {
      // 1 / Int P_k^2 by the Lobatto rule itself, which is exact but for k = p.
      const Scalar norm = k < degree ? Scalar(2 * k + 1) / Scalar(2) : Scalar(degree) / Scalar(2);
      to_legendre(k, j) = norm * weights[j] * P[k];
    }
  }
  return to_legendre;
}

}  // namespace ehd
