// SPDX-License-Identifier: GPL-3.0-or-later
// A table of films from solves: the degrees grow until the coefficients have fallen off, and further solves, which the
// table does not use, find its errors.
#pragma once

#include "workflow/film_table.hpp"
#include "workflow/film_table_oil.hpp"
#include "workflow/film_table_source.hpp"

namespace ehd {

struct FilmTableRequest {
  FilmRange range;
  double tolerance = 1e-4;
  int most_degree = 60;     ///< in M and in L, up to ChebyshevBasis::highest_degree
  long most_solves = 4000;  ///< held-out ones among them; at least fewest_solves(range)
};

/// The solves of the first grids of a range, and of the held-out points that judge them: no table needs fewer.
[[nodiscard]] long fewest_solves(const FilmRange& range);

/// The table to the tolerance. status: `converged`; `tolerance_not_met`, within the bounds of the request (the table is
/// there with its errors); `limit_reached`, a contact was not solved (there is no panel).
[[nodiscard]] FilmTable build_film_table(const TableOil& oil, const FilmTableRequest& request,
                                         const FilmSource& source);

}  // namespace ehd
