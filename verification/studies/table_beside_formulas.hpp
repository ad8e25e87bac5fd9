// SPDX-License-Identifier: GPL-3.0-or-later
// A table of films (workflow/film_table) beside the published film formulas, both against the certified films of the
// atlas.
#pragma once

#include <string>

#include "verification/studies/film_maps.hpp"
#include "workflow/film_table.hpp"

namespace ehd::verification {

/// The table of the atlas's Roelands oil over M 2..1000, L 2.5..20 to 1e-4, by the default solver over threads.
[[nodiscard]] FilmTable table_of_the_atlas(unsigned threads);

/// A line for the table and for each formula of a film: the median and the largest deviation over the points of the
/// atlas that the table covers. The last line, which begins with "time", has what an evaluation takes here.
[[nodiscard]] std::string table_beside_formulas(const FilmMaps& maps, const FilmTable& table);

}  // namespace ehd::verification
