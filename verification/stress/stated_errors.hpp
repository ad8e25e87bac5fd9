// SPDX-License-Identifier: GPL-3.0-or-later
// The rule by which a stated error holds, and its count over many random solves.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "verification/stress/stress.hpp"
#include "verification/tolerance.hpp"

namespace ehd::verification::stress {

/// A number of a solver against the truth; all relative. NaN where one of them has none.
struct Compared {
  double differ = std::numeric_limits<double>::quiet_NaN();
  double stated = 0, truth_error = 0;  ///< errors that the solver and the truth state
};

enum class StatedError { holds, missed, undecided };
/// Missed where differ - truth_error > stated. Holds where differ + truth_error <= stated, or where differ <= stated
/// and the truth is ten times better. Else undecided, as where one of the three is not a finite number.
[[nodiscard]] StatedError judged_error(const Compared& number);

/// One number at all points with one tolerance.
struct ErrorCount {
  double asked = 0;
  long judged = 0, held = 0, within = 0, known = 0;  ///< error at most `asked`; stated error at most `asked`
  double worst = 0, largest = 0;                     ///< difference over stated error; difference
  std::vector<double> inflation = {};                ///< stated error over difference

  StatedError add(const Compared& number);
  /// A row of error_count_columns.
  [[nodiscard]] std::vector<Cell> cells(const std::string& name, std::size_t points) const;
};
inline constexpr std::string_view error_count_columns =
    "number | points | judged | stated error holds | differs by at most the tolerance | states at most the "
    "tolerance | difference/stated [most] | difference [most] | stated/difference [median]";

/// The share of stated errors that do not hold, against `tolerance`. Inconclusive where fewer than nine in ten could be
/// judged.
void judge_share(const ErrorCount& count, std::size_t points, const Tolerance& tolerance, const std::string& what,
                 Tally& tally);

}  // namespace ehd::verification::stress
