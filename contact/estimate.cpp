// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/estimate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace ehd {

namespace {
/// The smallest ratio of differences between grids that the estimate uses (a third of an order). No finite bound is
/// right for all slower sequences, and a slower sequence must not get a smaller error than a faster one.
constexpr double slowest_ratio = 1.25;
/// The error of two grids, and of three or more at a ratio r, over the last difference d: 3 d, and 1.25 d/(r - 1).
constexpr double of_two_grids = 3, of_ratio = 1.25;
/// Ratios within 5 % of 2^order twice in a row are clean: the error is then twice what the order says.
constexpr double clean_within = 0.05, of_clean = 2;
/// Within this factor of 2^order the sequence is extrapolated.
constexpr double extrapolated_within = 1.5;
}  // namespace

GridEstimate estimate(const std::vector<double>& values, double formal_order) {
  assert(!values.empty());
  const std::size_t grids = values.size();
  const double value = values.back();
  const double size = std::abs(value);
  GridEstimate result{.value = value,
                      .error = std::numeric_limits<double>::infinity(),
                      .extrapolated = value,
                      .extrapolated_error = std::numeric_limits<double>::infinity()};
  if (grids == 1) return result;

  const auto difference = [&](std::size_t back) { return values[grids - 1 - back] - values[grids - 2 - back]; };
  const double last = difference(0);
  if (grids == 2) {
    result.error = result.extrapolated_error = of_two_grids * std::abs(last) / size;
    return result;
  }
  const double before = difference(1);
  const double ratio = before / last;  // inf or NaN where the last two grids agree to the digit
  const double s = std::pow(2.0, formal_order);
  double error = std::abs(last);
  if (ratio > 0) error *= std::max(1.0, of_ratio / (std::max(ratio, slowest_ratio) - 1));
  for (std::size_t back = 1; back <= 3 && back + 2 <= grids; ++back)
    error = std::max(error, std::ldexp(std::abs(difference(back)), -static_cast<int>(back)));
  if (grids >= 4) {
    const auto clean = [&](double r) { return std::abs(r / s - 1) <= clean_within; };
    if (clean(ratio) && clean(difference(2) / before)) error = of_clean * std::abs(last) / (s - 1);
  }
  result.error = error / size;
  if (ratio > 0 && std::isfinite(ratio)) result.observed_order = std::log2(ratio);

  result.extrapolated_error = result.error;
  if (ratio >= s / extrapolated_within && ratio <= extrapolated_within * s) {
    result.extrapolated = value + last / (s - 1);
    result.extrapolated_error = std::abs(last) / (s - 1) / size;
    if (grids >= 4) {
      // The larger of two moves of the extrapolated value: a single one may vanish by chance.
      const double before_that = values[grids - 3] - values[grids - 4];
      const double move = std::abs(last + (last - before) / (s - 1));
      const double move_before = std::abs(before + (before - before_that) / (s - 1));
      result.extrapolated_error = std::max(move, move_before / s) / size;
    }
  }
  return result;
}

}  // namespace ehd
