// SPDX-License-Identifier: GPL-3.0-or-later
// The page and the badge of `ehd judge`, pure functions of judgements (docs/schema/ehd-judgement-1.json).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "verification/report/document.hpp"

namespace ehd::report {

/// All judgements on one self-contained page: digits by case, stated errors against actual ones, gates, hints. There is
/// no single total. The first `own` judgements are of the reader's submissions, which stand out in the figures. Throws
/// ReportError for a judgement of another form.
[[nodiscard]] std::string judge_page(const std::vector<Json>& judgements, std::size_t own = 0);

/// An SVG of one line: the median digits of what was given, by load, and how many numbers are missing. Throws
/// ReportError.
[[nodiscard]] std::string judge_badge(const Json& judgement);

}  // namespace ehd::report
