// SPDX-License-Identifier: GPL-3.0-or-later
// A table of films as JSON and as CSV; io/film_table_c writes it as C.
#pragma once

#include <string>
#include <vector>

#include "io/json.hpp"
#include "workflow/film_table.hpp"

namespace ehd {

/// The name of the format.
inline constexpr const char* film_table_schema = "ehd-films-2";

/// {"schema", "provenance", "case", "version", "solver", "status", "lubricant", "inlet", "range",
/// "tolerance", "s", "x", "y", "films", "panels", "cost"}; docs/films-table.md has the meaning.
[[nodiscard]] Json to_json(const FilmTable& table);

/// The same: comment lines that begin with #, a header line, and a line for each coefficient.
[[nodiscard]] std::string film_table_csv(const FilmTable& table);

/// A sentence or two a line: what the table holds, of which oil, made by what, and its errors. For a human, and for the
/// comments of the files.
[[nodiscard]] std::vector<std::string> film_table_words(const FilmTable& table);

}  // namespace ehd
