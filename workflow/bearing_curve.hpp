// SPDX-License-Identifier: GPL-3.0-or-later
// The law ehd: film curves of both raceways that reach as far as the rollers' loads; and films read from curves.
#pragma once

#include "bearing/geometry.hpp"
#include "bearing/law_table.hpp"
#include "workflow/bearing_balance.hpp"
#include "workflow/bearing_result.hpp"
#include "workflow/contact_memory.hpp"

namespace ehd {

/// M = f/(l sqrt(eta_0 u_s E' R)): the force at M = 1 [N].
[[nodiscard]] double force_at_M_1_N(const bearing::RacewayContact& contact);

/// A first curve ends at this force [N]; a balance that goes beyond extends the curve.
[[nodiscard]] double first_reach_N(const BearingSetup& setup, double largest_dry_N);

/// The curves of both raceways up to `reach_N` at least. Throws LawFailure.
[[nodiscard]] bearing::BothRaceways<bearing::SharedCurve> curves_of(const BearingSetup& setup, double reach_N,
                                                                    ContactMemory& memory);

/// Minimum films at the rollers' loads, and the curves that they are read from.
void fill_films(BearingResult& result, const bearing::BothRaceways<bearing::SharedCurve>& curves);

/// Balances with the curves' laws, extends the curves where a load is beyond them, and fills in balance, films and
/// notes. Reads result.datum_m. Throws LawFailure.
void run_curve_law(BearingResult& result, const BearingSetup& setup, bearing::FromCurves make, double largest_dry_N,
                   ContactMemory& memory);

}  // namespace ehd
