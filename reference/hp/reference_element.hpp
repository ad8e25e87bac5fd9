// SPDX-License-Identifier: GPL-3.0-or-later
// One polynomial element on [-1, 1]: its nodes, its collocation points, and the values and slopes there.
#pragma once

#include "contact/legendre.hpp"

namespace ehd::reference::hp {

/// Where a differential equation of an element is collocated: degree-many points.
enum class Points {
  left_radau,  ///< zeros of P_p + P_(p-1): contains t = -1, the upwind end
  gauss,       ///< zeros of P_p
};

/// The collocation points of degree p, increasing.
template <class Scalar>
[[nodiscard]] VectorOf<Scalar> collocation_points(Points kind, int degree) {
  const auto value = [&](auto t) {
    const auto P = legendre(degree, t);
    return kind == Points::gauss ? P[degree] : decltype(t)(P[degree] + P[degree - 1]);
  };
  const auto with_slope = [&](const Scalar& t) {
    const VectorOf<Scalar> slope = legendre_derivatives(degree, t);
    return std::pair<Scalar, Scalar>(value(t),
                                     kind == Points::gauss ? slope[degree] : Scalar(slope[degree] + slope[degree - 1]));
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

/// Everything that an element of one degree needs, on t in [-1, 1].
template <class Scalar>
struct ReferenceElement {
  int degree = 0;
  VectorOf<Scalar> nodes;            ///< Lobatto, degree + 1
  VectorOf<Scalar> weights;          ///< their quadrature, exact for 2 degree - 1
  VectorOf<Scalar> points;           ///< collocation, degree
  MatrixOf<Scalar> to_legendre;      ///< nodal values -> coefficients of P_0 … P_p
  MatrixOf<Scalar> at_points;        ///< nodal values -> values at the collocation points
  MatrixOf<Scalar> slope_at_points;  ///< nodal values -> d/dt there
  VectorOf<Scalar> slope_at_right;   ///< nodal values -> d/dt at t = 1
  VectorOf<Scalar> slope_at_left;    ///< nodal values -> d/dt at t = -1
};

template <class Scalar>
[[nodiscard]] ReferenceElement<Scalar> reference_element(Points kind, int degree) {
  ReferenceElement<Scalar> element;
  element.degree = degree;
  element.nodes = lobatto_nodes<Scalar>(degree);
  element.points = collocation_points<Scalar>(kind, degree);
  element.weights = lobatto_weights(degree, element.nodes);
  element.to_legendre = lobatto_to_legendre(degree, element.nodes);
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
