// SPDX-License-Identifier: GPL-3.0-or-later
// A solver with a tolerance or a number of intervals.
#pragma once

#include <optional>
#include <string>

#include "contact/solver.hpp"

namespace ehd::verification {

struct Setting {
  std::string solver = {};
  std::optional<double> tolerance = {};
  std::optional<int> nodes = {};
  [[nodiscard]] std::string text() const;  ///< "1e-3", "n = 1024": without the solver
  /// A solve on a given number of intervals is iterated to half the error of that grid.
  [[nodiscard]] Request request(double time_limit_s) const;
};

/// An observed quantity; null where there is none, or where it is not finite.
[[nodiscard]] const Reading* reading_of(const Solution& solution, Quantity quantity);

}  // namespace ehd::verification
