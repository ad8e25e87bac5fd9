// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the section "Bearing": error budgets, the paper's statements, contact force laws.
#pragma once

#include <optional>
#include <vector>

#include "verification/report/page.hpp"
#include "workflow/bearing_result.hpp"

namespace ehd::report {

/// The errors of one law's balance (BearingResult::errors). Absent for a dry law, and where a source of error has
/// no bound.
[[nodiscard]] std::optional<BearingErrors> errors_of_balance(const View& law);

/// By how much each simplification may move a balance: one table for all bearings.
void add_budgets(Page& page, const std::vector<View>& bearings);
void add_statements(Page& page, const std::vector<View>& statements);
/// The statements where one choice at a time is changed.
void add_study(Page& page, const View& study);
/// f(delta) and the minimum film, a curve a law.
void add_force_laws(Page& page, const std::vector<View>& laws);

}  // namespace ehd::report
