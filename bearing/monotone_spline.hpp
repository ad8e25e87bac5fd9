// SPDX-License-Identifier: GPL-3.0-or-later
// A cubic spline that does not overshoot.
#pragma once

#include <vector>

namespace ehd::bearing {

/// A value and its derivative.
struct ValueAndSlope {
  double value = 0;
  double slope = 0;
};

/// The cubic spline with not-a-knot ends (fourth order; a parabola through three points). Where the points are monotone
/// its slopes are limited (Hyman 1983, SIAM J. Sci. Stat. Comput. 4, 645-654), so that the curve is monotone too.
/// GSL's cubic spline has natural ends, which are of second order at the ends, and its monotone spline is of second
/// order everywhere.
class MonotoneSpline {
 public:
  /// `none`: the plain spline, for values that rise and fall. Beside an extremum the limit costs two orders.
  enum class Limit { none, monotone };

  /// At least three points, x increasing.
  MonotoneSpline(std::vector<double> x, std::vector<double> y, Limit limit = Limit::monotone);

  /// Between the first and the last point.
  [[nodiscard]] ValueAndSlope at(double x) const;
  [[nodiscard]] double first() const { return x_.front(); }
  [[nodiscard]] double last() const { return x_.back(); }

 private:
  std::vector<double> x_, y_, slope_;
};

}  // namespace ehd::bearing
