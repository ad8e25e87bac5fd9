// SPDX-License-Identifier: GPL-3.0-or-later
// A positive number of a raceway's contact as a function of the contact force: a spline through solved contacts, down
// to vanishing load.
#pragma once

#include <memory>
#include <vector>

#include "bearing/geometry.hpp"
#include "bearing/martin.hpp"
#include "bearing/monotone_spline.hpp"

namespace ehd::bearing {

/// - Between the points: the monotone spline of the logarithm over ln f.
/// - Below the lightest: the closed form of a rigid cylinder times exp(a t^(3/2) + c t^3), t = f/f_lightest. Value and
///   slope are continuous. The first piezoviscous corrections grow in these powers (alpha p_max ~ f^(3/2)).
/// - Above the heaviest: the power law of the end. It serves iterates that stray there and is NOT accurate.
class ContinuedSpline {
 public:
  /// The rigid cylinder's number at a contact force [N].
  using ClosedForm = ValueAndExponent (*)(const RacewayContact& contact, double force_N);

  /// Forces [N] increasing, at least three; as many values, positive. `name` is for messages. Throws
  /// std::invalid_argument.
  ContinuedSpline(const RacewayContact& contact, const std::vector<double>& forces_N, const std::vector<double>& values,
                  ClosedForm rigid, const char* name);

  /// The number at a force > 0 [N], and its derivative to the force.
  [[nodiscard]] ValueAndSlope at(double force_N) const;

 private:
  [[nodiscard]] ValueAndSlope below_lightest(double force_N) const;

  RacewayContact contact_;
  double lightest_N_ = 0, heaviest_N_ = 0;
  ClosedForm rigid_;
  std::shared_ptr<const MonotoneSpline> spline_;  // immutable, so copies share it
};

}  // namespace ehd::bearing
