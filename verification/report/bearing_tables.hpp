// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the section "Bearing": error budgets, the paper's statements, contact force laws.
#pragma once

#include <vector>

#include "verification/report/page.hpp"

namespace ehd::report {

/// What each simplification may move; one table for all bearings that state one.
void add_budgets(Page& page, const std::vector<View>& bearings);
void add_statements(Page& page, const std::vector<View>& statements);
/// One choice changed at a time, and what the statements become.
void add_study(Page& page, const View& study);
/// f(delta) and the minimum film, a curve a law.
void add_force_laws(Page& page, const std::vector<View>& laws);

}  // namespace ehd::report
