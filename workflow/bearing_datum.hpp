// SPDX-License-Identifier: GPL-3.0-or-later
// The datum x_0 of the approach at the raceways of a case.
#pragma once

#include "bearing/geometry.hpp"
#include "workflow/bearing_balance.hpp"
#include "workflow/bearing_notes.hpp"

namespace ehd {

/// The datum at both raceways [m], and where it comes from.
struct DatumOfCase {
  bearing::BothRaceways<double> x0_m;
  note::Datum note;
};

/// `largest_dry_N`: largest_dry_force_N, used where the datum of the case follows from the dry balance.
[[nodiscard]] DatumOfCase datum_of(const BearingSetup& setup, double largest_dry_N);

}  // namespace ehd
