// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/continued_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

namespace ehd::bearing {

namespace {

std::vector<double> logarithms(const std::vector<double>& values, const std::string& name) {
  std::vector<double> logs;
  for (const double value : values) {
    if (!(value > 0) || !std::isfinite(value))
      throw std::invalid_argument(
          fmt::format("curve over the contact force: a {} is {}; all must be positive and finite", name, value));
    logs.push_back(std::log(value));
  }
  return logs;
}

}  // namespace

ContinuedSpline::ContinuedSpline(const RacewayContact& contact, const std::vector<double>& forces_N,
                                 const std::vector<double>& values, ClosedForm rigid, const char* name)
    : contact_(contact), rigid_(rigid) {
  if (forces_N.size() < 3 || values.size() != forces_N.size())
    throw std::invalid_argument(fmt::format(
        "curve over the contact force: {} forces and {} values of the {}; give equal numbers of each, at least three",
        forces_N.size(), values.size(), name));
  if (std::adjacent_find(forces_N.begin(), forces_N.end(), std::greater_equal<>()) != forces_N.end())
    throw std::invalid_argument("curve over the contact force: the forces must increase");
  lightest_N_ = forces_N.front();
  heaviest_N_ = forces_N.back();
  spline_ = std::make_shared<const MonotoneSpline>(logarithms(forces_N, "force"), logarithms(values, name));
}

/// ln y = ln y_rigid + a t^(3/2) + c t^3. Value and slope at t = 1 fix a and c.
ValueAndSlope ContinuedSpline::below_lightest(double force_N) const {
  const ValueAndExponent at_joint = rigid_(contact_, lightest_N_), here = rigid_(contact_, force_N);
  const ValueAndSlope joint = spline_->at(spline_->first());
  const double v = joint.value - std::log(at_joint.value), d = joint.slope - at_joint.exponent;
  const double c = (d - 1.5 * v) / 1.5, a = v - c;
  const double t = force_N / lightest_N_, t15 = t * std::sqrt(t);
  const double value = here.value * std::exp(a * t15 + c * t15 * t15);
  return {value, value / force_N * (here.exponent + 1.5 * a * t15 + 3 * c * t15 * t15)};
}

ValueAndSlope ContinuedSpline::at(double force_N) const {
  if (force_N < lightest_N_) return below_lightest(force_N);
  const double log_force = std::log(force_N), last = spline_->last();
  if (force_N <= heaviest_N_) {
    const ValueAndSlope inside = spline_->at(std::clamp(log_force, spline_->first(), last));
    const double value = std::exp(inside.value);
    return {value, value * inside.slope / force_N};
  }
  const ValueAndSlope end = spline_->at(last);
  const double value = std::exp(end.value + end.slope * (log_force - last));
  return {value, value * end.slope / force_N};
}

}  // namespace ehd::bearing
