// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/estimate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace ehd {

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

  const double last = values[grids - 1] - values[grids - 2];
  if (grids == 2) {
    result.error = result.extrapolated_error = std::abs(last) / size;
    return result;
  }
  const double before = values[grids - 2] - values[grids - 3];
  const double ratio = before / last;  // inf or NaN where the last two grids agree to the digit
  const double s = std::pow(2.0, formal_order);
  double error = std::max(std::abs(last), std::abs(before) / 2);
  if (ratio >= 1.5 && ratio <= 2 * s) error = 1.25 * std::abs(last) / (std::min(ratio, s) - 1);
  result.error = error / size;
  if (ratio > 0) result.observed_order = std::log2(ratio);

  result.extrapolated_error = result.error;
  if (ratio >= s / 1.5 && ratio <= 1.5 * s) {
    result.extrapolated = value + last / (s - 1);
    const double correction = std::abs(last) / (s - 1);
    result.extrapolated_error = correction / size;
    if (grids >= 4) {
      const double extrapolated_before = values[grids - 2] + before / (s - 1);
      const double move = std::abs(result.extrapolated - extrapolated_before);
      result.extrapolated_error = std::min(correction, move) / size;
    }
  }
  return result;
}

}  // namespace ehd
