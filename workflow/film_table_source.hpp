// SPDX-License-Identifier: GPL-3.0-or-later
// Where a table of films has its films from: solved contacts.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "workflow/deadline.hpp"
#include "workflow/film_table.hpp"
#include "workflow/film_table_oil.hpp"

namespace ehd {

/// The films of one contact with the errors that its solve states; `why` says why there are none.
struct SolvedFilms {
  ByFilm<double> value = {};
  ByFilm<double> error = {};
  std::string why = {};
  /// The largest pressure, in units of p_H, and its X; no numbers where they are not known.
  double peak = std::numeric_limits<double>::quiet_NaN(), peak_X = std::numeric_limits<double>::quiet_NaN();
};
/// Gives a table its films: those of some contacts, in their order.
using FilmSource = std::function<std::vector<SolvedFilms>(const std::vector<MoesGroups>&)>;

/// Each solve is asked for this share of the table's tolerance.
inline constexpr double solve_share = 0.2;

/// Solves by the default solver over threads (0: one per core), for a table of this tolerance.
[[nodiscard]] FilmSource film_solves(const TableOil& oil, double table_tolerance, unsigned threads, double time_limit_s,
                                     const Deadline& deadline = {});

}  // namespace ehd
