// SPDX-License-Identifier: GPL-3.0-or-later
// The linearised equations of the coarsest grid as a dense matrix, with its factors.
#pragma once

#include "contact/array.hpp"
#include "fast/dense_lu.hpp"
#include "fast/state.hpp"

namespace ehd::fast {

struct NodeFields;
struct Squeeze;
class Jacobian;

/// Storage is used again by the next matrix.
template <class Scalar>
class CoarsestOf {
 public:
  /// Builds and factorises the matrix: J without `squeeze`, else J - s Q for a motion at the rate s. `squeeze` holds
  /// the coefficients of Q (squeeze.hpp). False where the matrix is singular.
  [[nodiscard]] bool factorise(const NodeFields& nodes, const Jacobian& jacobian, const Squeeze* squeeze, Scalar rate);
  /// step = J^-1 error.
  void solve(const ResidualOf<Scalar>& error, StepOf<Scalar>& step);

 private:
  void subtract_squeeze(const NodeFields& nodes, const Jacobian& jacobian, const Squeeze& squeeze, Scalar rate);

  DenseLuOf<Scalar> lu_;
  Array integral_;            ///< of P dphi, by P_1..P_(n-1)
  Array scaled_integral_;     ///< its part in the film
  Array exit_kernel_;         ///< of the flux at the exit
  Array mass_;                ///< Q of a face, by P_1..P_(n-1)
  ArrayOf<Scalar> solution_;  ///< P_1..P_(n-1), H_0, X*
};

}  // namespace ehd::fast
