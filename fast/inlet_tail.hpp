// SPDX-License-Identifier: GPL-3.0-or-later
// The far inlet beyond the first node, for a flooded contact on a grid that begins at X_a.
//
// For x = -X >= x_a = -X_a the gap is the parabola with a slowly varying correction,
//   H(x) = x^2/2 + A - ln(x/x_a)/2 - (m/pi)(1/x - 1/x_a),   A = H(X_a) - x_a^2/2,   m = Int P X dX,
// and Reynolds' equation integrates from infinity with the flux C: the reduced pressure is
//   Q(x) = lambda Int_x^inf ( 1/H^2 - C/H^3 ) dx',   P = -ln(1 - a Q)/a,
// with a the ambient slope of ln eta (P = Q where a = 0) and the leading term lambda 4/(3 x^3). The integrals run over
// t = x_a/x in (0, 1), where everything is smooth but for t^2 ln(t).
#pragma once

#include "contact/array.hpp"

namespace ehd::fast {

struct InletTail {
  double pressure = 0;  ///< P(X_a)
  double load = 0;      ///< Int P dX over X < X_a
  double work = 0;      ///< Int H dP/dX dX over X < X_a
  /// Deflection by the tail's pressure at X, -(1/pi) Int P ln|X - X'| dX', as a polynomial in X: Taylor in X/x, with an
  /// error of order (X/x_a)^5. It is wrong near X_a, where H is about x_a^2/2 and this error does not matter.
  double deflection[5] = {};  ///< coefficients of 1, X, …, X^4
};

/// `far` = x_a > 0, `gap_excess` = A, `moment` = m, `flux` = C, `slope` = a. Pressures that would exceed the model
/// (a Q > 0.9, met only while Newton is far away) are held there.
[[nodiscard]] InletTail inlet_tail(double far, double gap_excess, double moment, double flux, double lambda,
                                   double slope);

}  // namespace ehd::fast
