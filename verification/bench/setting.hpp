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

/// The larger of the two film errors that the solution states; infinite where the solution cannot be a truth. One that
/// missed its tolerance can be: its error estimate is as good.
[[nodiscard]] double stated_error(const Solution& solution);

}  // namespace ehd::verification
