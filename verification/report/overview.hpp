// SPDX-License-Identifier: GPL-3.0-or-later
// The first table: what its lines have in common, and the lines of the bearing.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "verification/report/report.hpp"

namespace ehd::report {

/// Least and largest of the values that are known.
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(const std::optional<double>& value) {
    if (!value || !std::isfinite(*value)) return;
    low = std::min(low, *value);
    high = std::max(high, *value);
  }
  [[nodiscard]] bool any() const { return low <= high; }
};
/// "4.2 digits at worst, 6.7 at best"; without the word where it has been said.
[[nodiscard]] std::string digits_in(const Extent& digits, bool with_word = true);

[[nodiscard]] std::string how_many(std::size_t count, const std::string& one, const std::string& many);
/// HTML; the text is plain.
[[nodiscard]] std::string section_link(const char* section, const std::string& text);
/// The line of a part that the folder does not have.
[[nodiscard]] Verified absent_part(const char* section, const std::string& what);
/// What the solves of a part of the figures took, added up; "not recorded" in files of an earlier version.
[[nodiscard]] std::string cost_of(const View& figures, const char* part);

[[nodiscard]] Verified bearing_verified(const View& figures);
[[nodiscard]] Verified dynamics_verified(const View& figures);
[[nodiscard]] Verified statements_verified(const View& figures);

}  // namespace ehd::report
