// SPDX-License-Identifier: GPL-3.0-or-later
// A flat rigid punch on a half space, plane strain, Hertz scaling: H = H_0 - (1/pi) Int P ln|X - X'| dX' does not
// change over [a, c] when P = W/(pi sqrt((X - a)(c - X))).
#pragma once

#include <cmath>
#include <numbers>

namespace ehd::verification::exact {

/// -dH_0/dW = -ln((c - a)/4)/pi: Int of ln|X - X'| over that pressure of load 1 is ln((c - a)/4) everywhere.
[[nodiscard]] inline double flat_punch_compliance(double a, double c) {
  return -std::log((c - a) / 4) / std::numbers::pi;
}

}  // namespace ehd::verification::exact
