// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/plane.hpp"

#include <limits>

namespace ehd::bearing {

namespace {

/// An eigenvalue below this part of the other one is rounding (pseudo_inverse).
constexpr double rank_threshold = 2 * std::numeric_limits<double>::epsilon();

/// xx yy - xy^2, good to two units in the last place (Kahan; Jeannerod, Louvet & Muller 2013, Math. Comp. 82,
/// 2245-2264).
double determinant(const Symmetric2& a) {
  const double square = a.xy * a.xy, lost = std::fma(-a.xy, a.xy, square);
  return std::fma(a.xx, a.yy, -square) + lost;
}

}  // namespace

// With mean m = (xx + yy)/2, half difference d = (xx - yy)/2 and r = sqrt(d^2 + xy^2) the eigenvalues are m +- r. The
// one of larger size is the sum of two numbers of one sign. Its axis solves (xx - value) x + xy y = 0; the row with the
// larger diagonal entry, |d| + r in size, has no cancellation either.
Principal principal(const Symmetric2& a) {
  const double mean = (a.xx + a.yy) / 2, half = (a.xx - a.yy) / 2, radius = std::hypot(half, a.xy);
  const bool positive = mean >= 0;
  const double larger = positive ? mean + radius : mean - radius;
  const double smaller = larger == 0 ? 0 : determinant(a) / larger;
  if (radius == 0) return {{larger, smaller}, {Vector2{1, 0}, Vector2{0, 1}}};
  // Of the eigenvalue m + r: (r + d, xy) or (xy, r - d). The axis of m - r stands at right angles.
  const Vector2 along = half >= 0 ? Vector2{radius + half, a.xy} : Vector2{a.xy, radius - half};
  const Vector2 upper = along / std::hypot(along.x, along.y), lower{-upper.y, upper.x};
  return {{larger, smaller}, {positive ? upper : lower, positive ? lower : upper}};
}

Symmetric2 pseudo_inverse(const Symmetric2& matrix) {
  const Principal of = principal(matrix);
  Symmetric2 inverse;
  if (of.values[0] == 0) return inverse;
  inverse.add(1 / of.values[0], of.axes[0]);
  if (std::abs(of.values[1]) > rank_threshold * std::abs(of.values[0])) inverse.add(1 / of.values[1], of.axes[1]);
  return inverse;
}

}  // namespace ehd::bearing
