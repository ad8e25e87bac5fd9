// SPDX-License-Identifier: GPL-3.0-or-later
// The collocation equations of the line contact on a mesh of polynomial elements, and their exact Jacobian.
// docs/certified-solver.md, section 2. Everything is a template over the scalar type, so that what rounding does can be
// measured.
//
// Unknowns: P at the Lobatto nodes (n + 1, the last, at the exit, is 0 and stays so), H_0, the flux C and the exit X*.
// Equations: rho H^3 (1/eta + delta)/lambda P' - rho H + C = 0 at the n collocation points, the inlet's pressure, the
// load, and C = rho H at X*, which is P'(X*) = 0. delta is the floor of the fluidity; 0 is the physics.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "contact/problem.hpp"
#include "reference/hp/mesh.hpp"
#include "reference/hp/moments.hpp"
#include "reference/hp/reference_element.hpp"

namespace ehd::reference::hp {

template <class Scalar>
struct State {
  VectorOf<Scalar> P;  ///< nodes, inlet to exit; neighbours share the node between them
  Scalar offset{0};    ///< H_0
  Scalar flux{0};      ///< C
  Scalar exit{0};      ///< X*
};

/// A place in an element, with its distances to both ends in units of the half length.
template <class Scalar>
struct Place {
  int element = 0;
  Scalar from_left{0}, from_right{0};
};

/// What the equations say about a state, at the rows: the collocation points of all elements in order, the right ends
/// of all elements (row_of_right_end), and the inlet.
template <class Scalar>
struct Evaluation {
  ArrayOf<Scalar> X, P, slope, H;  ///< rows; slope = dP/dX from the element that owns the row
  LawValues<Scalar> viscosity, density;
  ArrayOf<Scalar> fluidity;               ///< 1/eta + delta
  ArrayOf<Scalar> mobility;               ///< rho H^3 fluidity/lambda
  ArrayOf<Scalar> balance;                ///< mobility P' - rho H + C
  VectorOf<Scalar> residual;              ///< n + 3: balances at the points, inlet, load, exit
  VectorOf<Scalar> scale;                 ///< what a residual is to be compared with
  ArrayOf<Scalar> film_by_exit;           ///< dH/dX* at fixed P, rows
  Scalar load_integral{0};                ///< S P
  Scalar tail_pressure{0}, tail_load{0};  ///< of the film before the inlet
};

/// The deflection at X that the pressure 4 lambda/(3 |X'|^3) before the inlet, X' < -x, causes, and its derivative:
///   -(1/pi) Int_x^inf 4 lambda/(3 y^3) ln(y + X) dy = -2 lambda/(3 pi x^2) B(X/x),
///   B(v) = ln x + 1/v + (1 - 1/v^2) ln(1 + v) = ln x + 1/2 + 2v/3 - v^2/4 + …
template <class Scalar>
[[nodiscard]] std::pair<Scalar, Scalar> tail_deflection(const Scalar& lambda, const Scalar& x, const Scalar& X);

template <class Scalar>
class Collocation {
 public:
  using Vector = VectorOf<Scalar>;
  using Matrix = MatrixOf<Scalar>;

  /// Sources are those of the problem; in another scalar type than double, `sources`.
  Collocation(const Problem& problem, Mesh mesh, Points points, std::shared_ptr<const SourcesOf<Scalar>> sources = {});

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] Points points() const { return points_; }
  [[nodiscard]] int intervals() const { return intervals_; }
  [[nodiscard]] int first_node(int element) const { return first_[static_cast<std::size_t>(element)]; }
  [[nodiscard]] const ReferenceElement<Scalar>& reference(int element) const {
    return *elements_.at(mesh_.degrees[static_cast<std::size_t>(element)]);
  }
  [[nodiscard]] Scalar half_length(int element) const {
    const auto e = static_cast<std::size_t>(element);
    return (Scalar(mesh_.breakpoints[e + 1]) - Scalar(mesh_.breakpoints[e])) / Scalar(2);
  }
  [[nodiscard]] int row_of_right_end(int element) const { return right_end_[static_cast<std::size_t>(element)]; }
  /// s = (X* - X_a)/T.
  [[nodiscard]] Scalar stretching(const Scalar& exit) const { return (exit - Scalar(mesh_.inlet)) / extent_; }
  [[nodiscard]] Scalar xi(const Place<Scalar>& place) const {
    const auto e = static_cast<std::size_t>(place.element);
    // Measured from the end nearer to the exit, where xi is small and keeps its digits.
    return Scalar(mesh_.breakpoints[e + 1]) - half_length(place.element) * place.from_right;
  }

  /// Rows of the kernel: Int P(x') ln|x - x'| dx' = row . P for each place, in xi.
  [[nodiscard]] Matrix kernel_rows(const std::vector<Place<Scalar>>& places) const;
  /// Film at places from the rows of the kernel there.
  [[nodiscard]] ArrayOf<Scalar> film(const State<Scalar>& state, const std::vector<Place<Scalar>>& places,
                                     const Matrix& rows) const;
  [[nodiscard]] std::vector<Place<Scalar>> node_places() const;
  /// X of the nodes for an exit.
  [[nodiscard]] ArrayOf<Scalar> node_coordinates(const Scalar& exit) const;
  [[nodiscard]] const std::vector<Place<Scalar>>& row_places() const { return places_; }

  [[nodiscard]] Evaluation<Scalar> evaluate(const State<Scalar>& state, const Scalar& floor) const;
  /// d residual/d(P_0 … P_(n-1), H_0, C, X*), (n+3) x (n+3).
  [[nodiscard]] Matrix jacobian(const State<Scalar>& state, const Evaluation<Scalar>& at) const;

  /// d H/d(P_0 … P_(n-1), H_0, C, X*) at the rows, for fixed xi: rows x (n+3).
  [[nodiscard]] Matrix film_jacobian(const State<Scalar>& state, const Evaluation<Scalar>& at) const;
  /// dX/dX* of a place that keeps its xi: 0 at the inlet, 1 at the exit.
  [[nodiscard]] Scalar coordinate_by_exit(const Place<Scalar>& place) const { return Scalar(1) + xi(place) / extent_; }
  /// S: Int P dxi = S . P.
  [[nodiscard]] const Vector& integrals() const { return integrals_; }

  /// The interpolant of nodal values at a local coordinate t of an element.
  [[nodiscard]] Scalar interpolate(const Vector& P, int element, const Scalar& t) const;

 private:
  Problem problem_;
  Mesh mesh_;
  Points points_;
  std::shared_ptr<const SourcesOf<Scalar>> sources_;
  bool flooded_;
  int intervals_;
  Scalar extent_, lambda_;
  std::map<int, std::shared_ptr<const ReferenceElement<Scalar>>> elements_;
  std::vector<int> first_;      ///< node (and collocation point) where an element begins
  std::vector<int> right_end_;  ///< row of an element's right end
  std::vector<Place<Scalar>> places_;
  Matrix kernel_;
  Vector integrals_;  ///< S
};

extern template class Collocation<double>;  // compiled once, in collocation.cpp

}  // namespace ehd::reference::hp
