// SPDX-License-Identifier: GPL-3.0-or-later
// The law ehd-linear: straight lines through solved contacts of both raceways, and the same lines cut at delta = 0.
#pragma once

#include "bearing/law_table.hpp"
#include "contact/nondimensional.hpp"
#include "workflow/bearing_balance.hpp"
#include "workflow/bearing_result.hpp"
#include "workflow/contact_memory.hpp"

namespace ehd {

/// Where a case states no fit.load_N, the line of a raceway is fitted over these parts of the largest force on it in
/// the dry balance: the largest roller load, or at the outer raceway the centrifugal force if that is larger. The range
/// begins at lightest_fit_M or above, ten times the smallest M that is solved at all. So every bearing has a line.
/// Lighter contacts would not improve the line: there the film goes as 1/f (Martin's rigid cylinder).
inline constexpr double default_fit_from = 0.2, default_fit_to = 1.2, lightest_fit_M = 10 * smallest_M;

/// Fits the lines, balances with their laws, and fills in balance, fits and notes; where `with_films` also the films
/// and the cut variant. Reads result.datum_m and result.plan. Throws LawFailure.
void run_linear_law(BearingResult& result, const BearingSetup& setup, bearing::FromFits make, double largest_dry_N,
                    ContactMemory& memory, bool with_films);

/// Judges the lines also at the contacts that carry nothing by the lines and do by the law ehd. `full`: the balance by
/// ehd of the same rollers.
void judge_use_beside(BearingResult& result, const BearingResult& full);

}  // namespace ehd
