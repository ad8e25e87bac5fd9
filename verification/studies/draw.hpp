// SPDX-License-Identifier: GPL-3.0-or-later
// Random inputs of claims and stress tests: the same on every machine and in every run.
#pragma once

#include <cmath>
#include <random>
#include <string>

#include "contact/conditions.hpp"
#include "contact/text.hpp"

namespace ehd::verification {

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  /// Not std::uniform_real_distribution, whose numbers depend on the library.
  double uniform(double from, double to) {
    constexpr double all_values = 4294967296.0;  // of mt19937: 2^32
    return from + (to - from) * (static_cast<double>(random_()) / all_values);
  }
  double logarithmic(double from, double to) { return std::pow(10, uniform(std::log10(from), std::log10(to))); }
  /// from ... to, both included.
  int integer(int from, int to) { return from + static_cast<int>(uniform(0, to - from + 1)); }
  /// M 0.05 ... 5000 logarithmically, L 0 ... 30, to four digits.
  MoesGroups point() {
    const double M = logarithmic(0.05, 5000);
    return {digits(M, 4), digits(uniform(0, 30), 4)};
  }
  static double digits(double value, int count) { return std::stod(plain(value, count)); }

 private:
  std::mt19937 random_;
};

}  // namespace ehd::verification
