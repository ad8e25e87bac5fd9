// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/start.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/film_formulas.hpp"
#include "contact/hertz.hpp"

namespace ehd::fast {

using std::numbers::pi;

Lengths lengths_from_film(double film) {
  const double scale = std::max(1.0, std::sqrt(2 * film));
  return {.film = film, .scale = scale, .inlet = std::pow(std::min(1.0, film), 2.0 / 3) * scale};
}

Lengths expected_lengths(const Groups& groups) {
  return lengths_from_film(expected_film({.M = groups.M, .L = groups.L}));
}

namespace {

/// Martin: X* = martin_exit sqrt(2 H_min) = tan(g_c) sqrt(2 H_min), in a parabolic gap.
constexpr double martin_exit = 0.4751299200930562;
/// Hertz: X* = 1 + this much of the inlet zone's width.
constexpr double hertz_exit = 0.45;
/// H_0 is such that the film is at least (1 - this share) of the film at X = 0, everywhere.
constexpr double share_lost = 0.7;
/// Where the far inlet's own pressure begins: X < -max(far_begin, far_widths sqrt(2 H)).
constexpr double far_begin = 1.5, far_widths = 2;
/// A reduced pressure is held at this, times 1/(alpha p_H); below the second, P = Q to rounding.
constexpr double largest_reduced = 0.9, linear_reduced = 1e-8;
/// A first guess of the deflection at the first node, for the first tail.
constexpr double first_deflection = 0.6;

/// Martin's pressure from the exit inwards: dP/dy ~ 1/(1+y^2)^2 - flux/(1+y^2)^3, y = X/sqrt(2 H). Not scaled to a
/// load.
void put_martin(const Array& X, double width, Array& P) {
  const double flux = 1 + martin_exit * martin_exit;  // gap at the exit over the smallest, where dP/dX = 0
  for (Eigen::Index i = X.size() - 2; i > 0; --i) {
    const double y = (X[i] + X[i + 1]) / (2 * width), gap = 1 + y * y;
    P[i] = std::max(0.0, P[i + 1] - (X[i + 1] - X[i]) * (1 - flux / gap) / (gap * gap));
  }
}

void put_hertz(const Array& X, Array& P) {
  for (Eigen::Index i = X.size() - 2; i > 0; --i) P[i] = std::sqrt(std::max(0.0, 1 - X[i] * X[i]));
}

/// The far inlet's pressure, lambda 4/(3 x^3), less what a cut takes away, is the least that P holds there: without it
/// the first faces, whose conductance grows as x^6, would dominate every norm.
void raise_far_inlet(const Setting& setting, const Array& X, double width, Array& P) {
  const double cut = setting.with_tail ? 0 : 1 / std::pow(-setting.inlet, 3);
  for (Eigen::Index i = 1; i + 1 < X.size(); ++i) {
    const double x = -X[i], far = std::max(far_begin, far_widths * width);
    if (x < far) break;
    P[i] = std::max(P[i], setting.groups.lambda * 4 / 3 * (1 / (x * x * x) - cut));
  }
}

/// Raises the pressure before a thin film to Reynolds' equation in the dry contact's gap plus the film, up to X = -1:
/// Q' = lambda (H - film)/H^3 for the reduced pressure Q, on the scheme's own faces. Without it the flux errors of the
/// wide gap, up to 1e7 of the film, hide those of the contact from Newton's norm.
void put_inlet(const Setting& setting, const Grid& grid, const Array& X, double film, State& state) {
  const Array H = film + hertz::gap(X);
  const double lambda = setting.groups.lambda, a = ambient_slope(setting.viscosity);
  double Q = state.tail.pressure, held = 0;
  for (Eigen::Index i = 0; i + 1 < X.size() && X[i] < 0; ++i) {
    if (X[i + 1] < -1) {
      const double k = grid.bias[i], gap = (H[i] + H[i + 1]) / 2;
      const double wedge = i == 0 ? gap : H[i] + ((1 + k) * (H[i + 1] - H[i]) + (1 - k) * (H[i] - H[i - 1])) / 4;
      Q += (X[i + 1] - X[i]) * lambda * (wedge - film) / (gap * gap * gap);
      const double q = std::min(a * Q, largest_reduced);
      held = q > linear_reduced ? -std::log1p(-q) / a : Q;
    }
    state.P[i + 1] = std::max(state.P[i + 1], held);
  }
}

}  // namespace

double first_exit(Shape shape, double film) {
  return shape == Shape::hertz ? 1 + hertz_exit * std::pow(std::min(1.0, film), 2.0 / 3)
                               : martin_exit * std::sqrt(2 * film);
}

double offset_for(double film, const Setting& setting, const State& state, Grid& grid) {
  const double length = state.exit - setting.inlet;
  Array gap;
  double integral = 0;
  grid.product(state.P, gap, integral);
  const Array X = setting.inlet + length * grid.place;
  gap = X.square() / 2 - length / pi * (gap + std::log(length) * integral);
  // The node nearest to X = 0; but a film that an interpolated pressure has spoilt elsewhere must be open.
  Eigen::Index centre = 0;
  X.abs().minCoeff(&centre);
  return film - std::min(gap[centre], gap.minCoeff() + share_lost * film);
}

InletTail first_tail(const Setting& setting, double film) {
  const double far = -setting.inlet;
  return inlet_tail(far, film - first_deflection - std::log(far) / 2, 0, film, setting.groups.lambda,
                    ambient_slope(setting.viscosity));
}

State first_iterate(const Setting& setting, Shape shape, double film, Grid& grid) {
  State state;
  const int n = grid.n;
  const double width = std::sqrt(2 * film);
  state.exit = first_exit(shape, film);
  const double length = state.exit - setting.inlet;
  const Array X = setting.inlet + length * grid.place;
  state.P.setZero(n + 1);
  if (shape == Shape::hertz) {
    put_hertz(X, state.P);
  } else {
    put_martin(X, width, state.P);
  }
  state.P *= pi / 2 / (length / n * (grid.slope * state.P).sum());
  raise_far_inlet(setting, X, width, state.P);
  if (setting.with_tail) state.tail = first_tail(setting, film);
  if (shape == Shape::hertz && film < thin_film) put_inlet(setting, grid, X, film, state);
  state.offset = offset_for(film, setting, state, grid);
  return state;
}

}  // namespace ehd::fast
