// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace ehd::bearing {

/// A sum that keeps what additions round away (Neumaier 1974).
class CarefulSum {
 public:
  void add(double term) {
    const double next = sum_ + term;
    lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }
  [[nodiscard]] double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0, lost_ = 0;
};

}  // namespace ehd::bearing
