// SPDX-License-Identifier: GPL-3.0-or-later
// A judgement for programs and for a terminal.
#pragma once

#include <string>

#include "io/json.hpp"
#include "verification/judge/judgement.hpp"

namespace ehd::judging {

inline constexpr const char* judgement_schema = "ehd-judgement-1";

/// docs/schema/ehd-judgement-1.json describes it. The page and the badge (report/judge_page) are made from it alone.
[[nodiscard]] Json to_json(const Judgement& judgement);

/// Tables of digits, stated errors, gates, regimes, hints.
[[nodiscard]] std::string human_text(const Judgement& judgement);

}  // namespace ehd::judging
