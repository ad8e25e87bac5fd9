// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes, states and data that the tests of this folder share; no two numbers alike.
#pragma once

#include "reference/hp/element_newton.hpp"
#include "tests/reference/problems.hpp"

namespace ehd::testing {

/// Seven elements of five degrees on [inlet, exit], sizes from 1.8 to 0.07. The domain is as long as in the mesh where
/// exit = inlet + 4.43; elsewhere it is stretched.
inline reference::hp::Mesh mixed_mesh(double inlet) {
  return {.inlet = inlet,
          .breakpoints = {-4.43, -2.6, -1.9, -1.4, -0.55, -0.2, -0.07, 0},
          .degrees = {5, 8, 3, 12, 4, 8, 6}};
}

/// A smooth positive pressure, no solution of anything: its exit is not where the mesh was made for.
inline reference::hp::State<double> smooth_state(const reference::hp::Collocation<double>& equations) {
  reference::hp::State<double> state{.P = {}, .offset = 0.9, .flux = 0.31, .exit = 1.21};
  const Array X = equations.node_coordinates(state.exit);
  state.P = (0.8 * (state.exit - X).square() * (-(X + 0.2).square()).exp()).matrix();
  state.P[state.P.size() - 1] = 0;
  return state;
}

template <class Scalar>
reference::hp::State<Scalar> in_scalar(const reference::hp::State<double>& state) {
  reference::hp::State<Scalar> out{
      .P = {}, .offset = Scalar(state.offset), .flux = Scalar(state.flux), .exit = Scalar(state.exit)};
  out.P.resize(state.P.size());
  for (Eigen::Index i = 0; i < out.P.size(); ++i) out.P[i] = Scalar(state.P[i]);
  return out;
}

}  // namespace ehd::testing
