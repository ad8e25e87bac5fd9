// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ehd::fast {

namespace {

/// Calibrated as extrapolation.hpp says: bars of three grids; the ratios of moves that count as regular (8 for smooth
/// solutions); bars of regular and of irregular sequences; how much less each move further back counts.
constexpr double of_three = 1.6, of_plain_move = 3;
constexpr double least_ratio = 6, largest_ratio = 11;
constexpr double of_regular = 2, of_regular_move = 4;
constexpr double of_irregular = 1.5, of_spike = 2, less_each_move = 6;
constexpr std::size_t moves_back = 4;

}  // namespace

Limit limit_of(const std::vector<double>& f, bool spike) {
  const std::size_t m = f.size();
  if (m == 1) return {.value = f[0], .error = std::numeric_limits<double>::infinity()};
  // From the finest grid backwards: R(0), R(1), …
  const auto R = [&](std::size_t back) { return (4 * f[m - 1 - back] - f[m - 2 - back]) / 3; };
  if (m == 2) return {.value = R(0), .error = std::abs(f[1] - f[0])};
  const auto r = [&](std::size_t back) { return R(back) - R(back + 1); };
  const auto S = [&](std::size_t back) { return (8 * R(back) - R(back + 1)) / 7; };
  if (m == 3)
    return {.value = S(0), .error = std::max(of_three * std::abs(r(0)), std::abs(f[2] - f[1]) / of_plain_move)};

  const double move = std::abs(S(0) - S(1));
  // Beside a spike two regular ratios prove nothing: they are those of the smooth part. What the spike adds shows only
  // on grids that begin to see it.
  const auto regular = [&](std::size_t back) {
    if (spike) return false;
    const double ratio = r(back + 1) / r(back);
    return ratio >= least_ratio && ratio <= largest_ratio;
  };
  // One ratio may be near 8 by chance.
  if (regular(0) && m == 4) return {.value = S(0), .error = std::max(of_regular * move, std::abs(r(0)))};
  if (regular(0) && regular(1))
    return {.value = S(0), .error = std::max(of_regular * move, std::abs(r(0)) / of_regular_move)};
  double error = move, share = spike ? of_spike : of_irregular;
  for (std::size_t back = 0; back + 3 <= m && back < moves_back; ++back, share /= less_each_move)
    error = std::max(error, share * std::abs(r(back)));
  return {.value = S(0), .error = error};
}

}  // namespace ehd::fast
