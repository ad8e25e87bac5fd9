// SPDX-License-Identifier: GPL-3.0-or-later
// Legendre polynomials in any real scalar type, and the point sets made of their zeros.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "contact/array.hpp"

namespace ehd::reference::hp {

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

/// Where a differential equation of an element is collocated: degree-many points.
enum class Points {
  left_radau,  ///< zeros of P_p + P_(p-1): contains t = -1, the upwind end
  gauss,       ///< zeros of P_p
};

namespace detail {

/// The zeros of f in (-1, 1), increasing, from `count` starts; f returns value and derivative. Newton's method doubles
/// the digits each time, so that starts good to 1e-3 need at most seven steps in any type used here.
template <class Scalar, class Function>
Scalar refined_zero(double start, const Function& f) {
  using std::abs;
  Scalar t(start);
  for (int step = 0; step < 12; ++step) {
    const auto [value, slope] = f(t);
    const Scalar move = value / slope;
    t -= move;
    if (abs(move) < Scalar(4) * std::numeric_limits<Scalar>::epsilon()) break;
  }
  return t;
}

/// A zero of f between a and b by bisection: the start of Newton's method.
template <class Function>
double bisected(const Function& f, double a, double b) {
  const bool rising = f(a) < 0;
  for (int step = 0; step < 60; ++step) {
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
  const int cells = 40 * (count + 2);
  const auto at = [&](int i) { return -std::cos(std::numbers::pi * (i + 0.37) / (cells + 0.74)); };
  for (int i = 0; i < cells; ++i) {
    if ((f(at(i)) < 0) != (f(at(i + 1)) < 0)) zeros.push_back(bisected(f, at(i), at(i + 1)));
  }
  return zeros;
}

}  // namespace detail

/// The collocation points of degree p, increasing.
template <class Scalar>
[[nodiscard]] VectorOf<Scalar> collocation_points(Points kind, int degree) {
  const auto value = [&](auto t) {
    const auto P = legendre(degree, t);
    return kind == Points::gauss ? P[degree] : decltype(t)(P[degree] + P[degree - 1]);
  };
  const auto with_slope = [&](const Scalar& t) {
    const VectorOf<Scalar> slope = legendre_derivatives(degree, t);
    return std::pair<Scalar, Scalar>(
        value(t), kind == Points::gauss ? slope[degree] : Scalar(slope[degree] + slope[degree - 1]));
  };
  const int inner = kind == Points::gauss ? degree : degree - 1;
  const auto starts = detail::sign_changes([&](double t) { return value(t); }, inner);
  VectorOf<Scalar> points(degree);
  int i = 0;
  if (kind == Points::left_radau) points[i++] = Scalar(-1);
  for (std::size_t k = starts.size() - static_cast<std::size_t>(inner); k < starts.size(); ++k)
    points[i++] = detail::refined_zero<Scalar>(starts[k], with_slope);
  return points;
}

/// Gauss-Legendre-Lobatto nodes: -1, the zeros of P_p', 1.
template <class Scalar>
[[nodiscard]] VectorOf<Scalar> lobatto_nodes(int degree) {
  const auto with_slope = [&](const Scalar& t) {
    const Scalar P = legendre(degree, t)[degree], slope = legendre_derivatives(degree, t)[degree];
    // Legendre's equation: (1 - t^2) P'' = 2 t P' - p (p+1) P.
    return std::pair<Scalar, Scalar>(
        slope, (Scalar(2) * t * slope - Scalar(degree * (degree + 1)) * P) / (Scalar(1) - t * t));
  };
  const auto starts =
      detail::sign_changes([&](double t) { return legendre_derivatives(degree, t)[degree]; }, degree - 1);
  VectorOf<Scalar> nodes(degree + 1);
  nodes[0] = Scalar(-1);
  nodes[degree] = Scalar(1);
  for (int k = 1; k < degree; ++k)
    nodes[k] = detail::refined_zero<Scalar>(starts[static_cast<std::size_t>(k - 1)], with_slope);
  return nodes;
}

/// Everything that an element of one degree needs, on t in [-1, 1].
template <class Scalar>
struct ReferenceElement {
  int degree = 0;
  VectorOf<Scalar> nodes;           ///< Lobatto, degree + 1
  VectorOf<Scalar> weights;         ///< their quadrature, exact for 2 degree - 1
  VectorOf<Scalar> points;          ///< collocation, degree
  MatrixOf<Scalar> to_legendre;     ///< nodal values -> coefficients of P_0 … P_p
  MatrixOf<Scalar> at_points;       ///< nodal values -> values at the collocation points
  MatrixOf<Scalar> slope_at_points;  ///< nodal values -> d/dt there
  VectorOf<Scalar> slope_at_right;  ///< nodal values -> d/dt at t = 1
  VectorOf<Scalar> slope_at_left;   ///< nodal values -> d/dt at t = -1
};

template <class Scalar>
[[nodiscard]] ReferenceElement<Scalar> reference_element(Points kind, int degree) {
  ReferenceElement<Scalar> element;
  element.degree = degree;
  element.nodes = lobatto_nodes<Scalar>(degree);
  element.points = collocation_points<Scalar>(kind, degree);
  element.weights.resize(degree + 1);
  element.to_legendre.resize(degree + 1, degree + 1);
  for (int j = 0; j <= degree; ++j) {
    const VectorOf<Scalar> P = legendre(degree, Scalar(element.nodes[j]));
    element.weights[j] = Scalar(2) / (Scalar(degree * (degree + 1)) * P[degree] * P[degree]);
    for (int k = 0; k <= degree; ++k) {
      // 1 / Int P_k^2 by the Lobatto rule itself, which is exact but for k = p.
      const Scalar norm = k < degree ? Scalar(2 * k + 1) / Scalar(2) : Scalar(degree) / Scalar(2);
      element.to_legendre(k, j) = norm * element.weights[j] * P[k];
    }
  }
  element.at_points.resize(degree, degree + 1);
  element.slope_at_points.resize(degree, degree + 1);
  for (int i = 0; i < degree; ++i) {
    element.at_points.row(i) = legendre(degree, Scalar(element.points[i])).transpose() * element.to_legendre;
    element.slope_at_points.row(i) =
        legendre_derivatives(degree, Scalar(element.points[i])).transpose() * element.to_legendre;
  }
  element.slope_at_right = element.to_legendre.transpose() * legendre_derivatives(degree, Scalar(1));
  element.slope_at_left = element.to_legendre.transpose() * legendre_derivatives(degree, Scalar(-1));
  if (kind == Points::left_radau) element.at_points.row(0).setUnit(0);
  return element;
}

}  // namespace ehd::reference::hp
