// SPDX-License-Identifier: GPL-3.0-or-later
// A stopwatch, the processor time of a thread, and the number of repetitions.
#pragma once

#include <time.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <vector>

#include "verification/median.hpp"

namespace ehd::verification {

/// Wall time since construction [s].
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// Processor time of this thread so far [s]. Other processes do not count.
[[nodiscard]] inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Short runs are repeated at least `least` times and for `least_s` in all. No run follows after `enough_s` in all
/// or `most` runs.
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

}  // namespace ehd::verification
