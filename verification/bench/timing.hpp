// SPDX-License-Identifier: GPL-3.0-or-later
// How often a time is taken, and what is made of the times.
#pragma once

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace ehd::verification {

/// Short runs are repeated at least `least` times and for `least_s` in all; what takes `enough_s` is not.
struct Repetition {
  int least = 5;
  double least_s = 0.05;
  double enough_s = 0.5;
  int most = 200;
  [[nodiscard]] bool satisfied_by(const std::vector<double>& seconds) const {
    const double sum = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    const auto count = static_cast<int>(seconds.size());
    return count > 0 && (sum >= enough_s || count >= most || (count >= least && sum >= least_s));
  }
};

/// The middle one; the mean of the middle two. Throws std::invalid_argument for none.
[[nodiscard]] inline double median(std::vector<double> values) {
  if (values.empty()) throw std::invalid_argument("a median of no values; required is at least one");
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

}  // namespace ehd::verification
