// SPDX-License-Identifier: GPL-3.0-or-later
// Reynolds' equation on the faces. Face i lies between the nodes i and i + 1:
//
//   F_i = f_(i+1/2) - eps_i (P_(i+1) - P_i)/(X_(i+1) - X_i),  f = rho^ H, rho^ of carried_density.hpp
//   eps_i = rho_f H_f^3 m/lambda; rho_f, H_f: means of the two nodes; m: logarithmic mean of 1/eta
//   f_(i+1/2) = f_i + [(1 + k_i)(f_(i+1) - f_i) + (1 - k_i)(f_i - f_(i-1))]/4; on the first face the mean
//
// The equations are F_i = rho_n H_n on every face, since P = P' = 0 at the exit.
#pragma once

#include "contact/array.hpp"
#include "fast/carried_density.hpp"

namespace ehd::fast {

struct NodeFields;
struct Setting;

/// Arrays have n entries, one a face; their storage is used again.
struct FaceFluxes {
  Array eps;   ///< eps_i = rho H^3/(eta lambda)
  Array flux;  ///< F_i
  CarriedDensity carried;

  /// Sets all three from the fields at the nodes and the pressure P.
  void evaluate(const Setting& setting, const NodeFields& nodes, const Array& P);
  /// The largest rounding error of an F_i, each in units of `oil` at its face.
  [[nodiscard]] double rounding(const NodeFields& nodes, const Array& P, const Array& oil) const;
};

}  // namespace ehd::fast
