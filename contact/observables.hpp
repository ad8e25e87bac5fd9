// SPDX-License-Identifier: GPL-3.0-or-later
// The only reader of fields. Second-order sums where the scheme's own integrals are second order, local polynomials
// between nodes elsewhere; nothing here knows which solver made the fields.
#pragma once

#include "contact/problem.hpp"
#include "contact/solution.hpp"

namespace ehd {

/// Every wanted quantity, without errors. A spike is a local pressure maximum with a local minimum before it and an
/// earlier maximum before that; without one it is absent. film.central is absent where X = 0 lies outside the grid.
/// - film.minimum: minimum of the quartic through the five nodes about the smallest one (parabola as a fall-back)
/// - film.central: quintic through the six nodes about X = 0
/// - film.couette: flux at the exit, rho H there
/// - rolling.force: |Int H dP/dX dX|/2 by the trapezoid rule in P
/// - load_error: |2/pi Int P dX - 1| by the trapezoid rule, with the tail
/// Where the fields are made of polynomial elements, extrema, values and integrals are those of the polynomials.
/// - flux_variation: max |q - q_exit|/|q_exit| over the faces
[[nodiscard]] Observables observe(const Fields& fields, const Wanted& wanted);

/// The value at x of the polynomial through (nodes, values). Sizes equal, nodes distinct. Errors: none.
[[nodiscard]] double interpolate(const Array& nodes, const Array& values, double x);

}  // namespace ehd
