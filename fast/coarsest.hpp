// SPDX-License-Identifier: GPL-3.0-or-later
// The linearised equations of the coarsest grid as a dense matrix, with its factors.
#pragma once

#include "contact/array.hpp"
#include "fast/dense_lu.hpp"

namespace ehd::fast {

struct NodeFields;
struct Residual;
struct Step;
class Jacobian;

/// Storage is used again by the next matrix.
class Coarsest {
 public:
  /// Builds and factorises the matrix. False where it is singular.
  [[nodiscard]] bool factorise(const NodeFields& nodes, const Jacobian& jacobian);
  /// step = J^-1 error.
  void solve(const Residual& error, Step& step);

 private:
  DenseLu lu_;
  Array integral_;         ///< of P dphi, by P_1..P_(n-1)
  Array scaled_integral_;  ///< its part in the film
  Array exit_kernel_;      ///< of the flux at the exit
  Array solution_;         ///< P_1..P_(n-1), H_0, X*
};

}  // namespace ehd::fast
