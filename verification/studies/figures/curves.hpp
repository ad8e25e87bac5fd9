// SPDX-License-Identifier: GPL-3.0-or-later
// Curves for figures: few points where a curve is straight, many where it bends. And the gap behind a contact's exit.
#pragma once

#include <cstddef>
#include <vector>

#include "contact/profile.hpp"

namespace ehd::verification {

/// One curve over common abscissae, and how far a drawn chord may be from it at each of them (absolute, positive).
struct ThinnedCurve {
  std::vector<double> values;
  std::vector<double> allowed;
};

struct Thinning {
  std::vector<std::size_t> kept;  ///< indices, increasing, the first and last among them
  double factor = 1;              ///< chords through the kept points are within factor * allowed at every point
};

/// Douglas and Peucker's division at the point that is furthest off, vertically and for all curves at once. `factor`
/// grows in steps of 1.5 until at most `most` points (>= 2) are kept. X increases; sizes are equal, at least 2.
[[nodiscard]] Thinning thin(const std::vector<double>& X, const std::vector<ThinnedCurve>& curves, std::size_t most);

/// H(X) - H(X*) for X >= X*, where the pressure ends at X* = pressure.last():
///   (X^2 - X*^2)/2 - (1/pi) Int P [ln(X - t) - ln(X* - t)] dt,
/// by a Lobatto rule on each piece of P. Pressure before the profile's first node is left out: the difference of the
/// two logarithms falls with its distance.
[[nodiscard]] double gap_behind_exit(const Profile& pressure, double X);

}  // namespace ehd::verification
