// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/stress/stated_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "contact/text.hpp"
#include "verification/median.hpp"

namespace ehd::verification::stress {

namespace {

/// A truth that is known to this share of a stated error counts as exact.
constexpr double truth_share = 0.1;
/// At least so many of the stated errors have to be judged.
constexpr double least_judged = 0.9;

}  // namespace

StatedError judged_error(const Compared& number) {
  const auto& [differ, stated, truth_error] = number;
  if (!std::isfinite(differ) || !std::isfinite(stated) || !std::isfinite(truth_error)) return StatedError::undecided;
  if (differ - truth_error > stated) return StatedError::missed;
  const bool holds = differ + truth_error <= stated || (differ <= stated && truth_error <= truth_share * stated);
  return holds ? StatedError::holds : StatedError::undecided;
}

StatedError ErrorCount::add(const Compared& number) {
  const StatedError verdict = judged_error(number);
  known += number.stated <= asked ? 1 : 0;
  if (verdict == StatedError::undecided) return verdict;
  ++judged;
  held += verdict == StatedError::holds ? 1 : 0;
  within += number.differ + number.truth_error <= asked ? 1 : 0;
  worst = std::max(worst, number.differ / number.stated);
  largest = std::max(largest, number.differ);
  inflation.push_back(number.stated / number.differ);
  return verdict;
}

std::vector<Cell> ErrorCount::cells(const std::string& name, std::size_t points) const {
  return {fmt::format("{} to {}", name, plain(asked)),
          points,
          judged,
          held,
          within,
          known,
          worst,
          largest,
          judged > 0 ? std::optional(median(inflation)) : std::nullopt};
}

void judge_share(const ErrorCount& count, std::size_t points, const Tolerance& tolerance, const std::string& what,
                 Tally& tally) {
  const auto judged = static_cast<double>(count.judged);
  tally.add(count.judged > 0 ? static_cast<double>(count.judged - count.held) / judged : std::nan(""), 0, tolerance,
            what + ": share of stated errors that do not hold");
  if (judged < least_judged * static_cast<double>(points))
    tally.add(Verdict::inconclusive,
              fmt::format("{}: only {} of {} stated errors could be judged", what, count.judged, points));
}

}  // namespace ehd::verification::stress
