// SPDX-License-Identifier: GPL-3.0-or-later
// films = "table" of a sweep: the rows take their films from one table, which covers the range that the file states.
#pragma once

#include "io/sweep_file.hpp"
#include "io/sweep_row.hpp"
#include "workflow/film_table.hpp"

namespace ehd {

class SweepSource;

/// Reads films and [table]; the case, solver and tolerance of the sweep are there. Throws CaseError.
void read_films(const SweepSource& source, Sweep& sweep);

/// Refuses a row with another oil or inlet, or outside the range. Throws CaseError.
void require_in_table(const SweepTable& table, const Case& row_case);

/// The table of all rows; it depends on the sweep's file alone.
[[nodiscard]] FilmTable build_table(const Sweep& sweep, const SweepRequest& request);

}  // namespace ehd
