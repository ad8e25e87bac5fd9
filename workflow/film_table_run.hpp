// SPDX-License-Identifier: GPL-3.0-or-later
// A contact whose films come from a table instead of a solve.
#pragma once

#include "workflow/contact_run.hpp"
#include "workflow/film_table.hpp"

namespace ehd {

/// The solver's name of such a run.
inline constexpr const char* table_solver = "table";

/// The films of the table at the case's M and L, with the errors that the table states. Its status is the table's.
/// The case is lubricated, with the oil and inlet of the table, and inside its range.
[[nodiscard]] ContactRun run_from_table(const Case& contact_case, const FilmTable& table);

}  // namespace ehd
