// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/exact/hertz_gap.hpp"

#include <cmath>
#include <numbers>

#include "verification/exact/numerics.hpp"

namespace ehd::verification::exact {

using std::numbers::pi;

double hertz_film_by_quadrature(double X) {
  // t = X +- u, u > 0, on either side of X, so that the logarithm is singular at an end point only. There the adaptive
  // rule extrapolates.
  const auto side = [X](double direction, double from, double to) {
    if (to <= from) return 0.0;
    return integral(
        [=](double u) {
          const double t = X + direction * u;
          return std::sqrt(std::max(0.0, (1 - t) * (1 + t))) * std::log(u);
        },
        from, to);
  };
  double moment = 0;
  if (X < 1) moment += side(+1, std::max(0.0, -1 - X), 1 - X);
  if (X > -1) moment += side(-1, std::max(0.0, X - 1), X + 1);
  return X * X / 2 - moment / pi;
}

}  // namespace ehd::verification::exact
