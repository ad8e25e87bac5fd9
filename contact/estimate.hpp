// SPDX-License-Identifier: GPL-3.0-or-later
// Error of the last value of a sequence of grids, each with twice the intervals of the one before. Judged from what
// the grids show, never from an assumed order.
#pragma once

#include <optional>
#include <vector>

namespace ehd {

struct GridEstimate {
  double value = 0;                          ///< the last value
  double error = 0;                          ///< relative to |value|; infinite for a single grid
  std::optional<double> observed_order = {};  ///< log2 of the last ratio of differences, where it is positive
  double extrapolated = 0;                   ///< by the observed order where it is near `formal_order`, else = value
  double extrapolated_error = 0;             ///< relative
};

/// `values`: coarse to fine, at least one.
///   d_k = f_k - f_(k-1), r = d_(m-1)/d_m, s = 2^formal_order.
/// - two grids: error |d_m| (covers first order and above).
/// - monotone, 1.5 <= r <= 2 s: error 1.25 |d_m|/(min(r, s) - 1).
/// - r < 1.5, negative or larger than 2 s (coincidence): error max(|d_m|, |d_(m-1)|/2).
/// Extrapolation f_m + d_m/(s - 1) where s/1.5 <= r <= 1.5 s; its error is the move of the extrapolated value from the
/// grid before (needs four grids), or the size |d_m|/(s - 1) of the last correction.
[[nodiscard]] GridEstimate estimate(const std::vector<double>& values, double formal_order);

}  // namespace ehd
