// SPDX-License-Identifier: GPL-3.0-or-later
// The discrete equations at one iterate: fields at the nodes (node_fields.hpp), Reynolds' equation on the faces
// (face_fluxes.hpp), and the errors of the equations,
//
//   flux error e_i = F_i - rho_n H_n, i = 0..n-1;  load error l Int P dphi - pi/2.
//
// Unknowns P_1..P_(n-1), H_0, X*: as many as equations. Their derivatives are in jacobian.hpp.
#pragma once

#include "contact/array.hpp"
#include "fast/counters.hpp"
#include "fast/face_fluxes.hpp"
#include "fast/node_fields.hpp"
#include "fast/state.hpp"

namespace ehd::fast {

/// Storage is used again at the next iterate.
struct Discretisation {
  NodeFields nodes;
  FaceFluxes faces;
  Residual error;
  /// n entries: rho H before each face, at least rho_n H_n. Flux errors are judged in these units: far out the film is
  /// thousands of times H_n and conducts with its third power, so that an error of a hundred H_n moves no film there.
  Array oil;
  double rounding = 0;  ///< rounding floor of residual()

  /// Everything, of the state. False where the film is not positive or a number is not finite; then only nodes.H is
  /// meaningful.
  [[nodiscard]] bool evaluate(const Setting& setting, State& state, Grid& on, Counters& counters);
  /// The same where nodes.product and nodes.product_integral belong to the state's pressure already.
  [[nodiscard]] bool evaluate_with_product(const Setting& setting, State& state, Grid& on, Counters& counters);
  /// The tail that belongs to the present fields.
  [[nodiscard]] InletTail tail_of(const Setting& setting, const State& state) const;
  /// max|e_i|/oil_i.
  [[nodiscard]] double residual() const { return (error.flux / oil).abs().maxCoeff(); }
  /// max|e_i|/(rho_n H_n), the self-check flux_variation on the faces. Below: a bound of its rounding error.
  [[nodiscard]] double flux_variation() const { return error.flux.abs().maxCoeff() / nodes.exit_flux(); }
  [[nodiscard]] double rounding_of_flux_variation() const { return rounding * oil.maxCoeff() / nodes.exit_flux(); }
};

}  // namespace ehd::fast
