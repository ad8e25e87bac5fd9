// SPDX-License-Identifier: GPL-3.0-or-later
// The films of one lubricant as a table over M and L: Chebyshev coefficients, their evaluation with derivatives, and
// the errors that were found. workflow/film_table_build makes one by solving.
//
//   ln(film - shift) = sum of c_ij T_i(x) T_j(y),  x and y: workflow/film_panel.hpp
//
// The shift is 0 for a film and the offset of the dry contact for the offset H_0, which may be negative: H_0 rises
// above its dry value by about a film.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "contact/conditions.hpp"
#include "contact/quantities.hpp"
#include "contact/solution.hpp"
#include "workflow/film_panel.hpp"

namespace ehd {

/// What a table holds, in Hertz units.
inline constexpr std::array table_films{Quantity::film_minimum, Quantity::film_central, Quantity::film_couette,
                                        Quantity::film_offset};
inline constexpr std::size_t table_film_count = table_films.size();
template <class Value>
using ByFilm = std::array<Value, table_film_count>;  ///< in the order of table_films

/// 0 for a film, the dry offset for H_0.
[[nodiscard]] double table_shift(Quantity film);

/// What an error is divided by. A film: itself. The offset: its rise above the dry value where that is above 1, else 1.
/// So the error of a small offset is absolute (Hertz units), as everywhere.
[[nodiscard]] double table_error_unit(Quantity film, double value);
/// table_error_unit in units of a stated error, which is relative for a film and absolute for the offset.
[[nodiscard]] double table_unit_of_stated(Quantity film, double value);

struct FilmRange {
  double M_low = 0, M_high = 0;  ///< 0 < M_low < M_high
  double L_low = 0, L_high = 0;  ///< 0 <= L_low < L_high
  [[nodiscard]] bool contains(const MoesGroups& at) const;
};

/// Neighbouring panels meet within their errors, not exactly.
struct FilmPanel {
  PanelShape shape;
  double x_first = -1, x_last = 1;  ///< beyond, next to a bend, no contact was solved: the panel extrapolates
  int degree_M = 0, degree_L = 0;
  ByFilm<std::vector<double>> coefficients;  ///< c_ij, row by row, i over the degrees of M
};

/// Errors in units of table_error_unit.
struct FilmTableErrors {
  double found = 0;   ///< the largest difference to a held-out solve
  double solves = 0;  ///< the largest error that a solve of the table states
  double stated = 0;  ///< found_factor found + solves
};

/// Next to a bend no contact of the table is solved, and a panel extrapolates. There the errors below do not hold;
/// these do, where the table has them.
struct BendErrors {
  double gap = 0;                             ///< ln M, on both sides of the bend
  std::optional<ByFilm<double>> stated = {};  ///< empty: a held-out contact there was not solved
};

struct FilmTable {
  std::string case_id = {};  ///< whose oil it is; empty where the oil is of no case
  int version = 0;
  std::string title = {};  ///< of the case, with the values that --set changed
  std::string solver = {};
  Lubricant lubricant;
  Inlet inlet;
  FilmRange range;
  double tolerance = 0;
  std::vector<FilmPanel> panels;  ///< of a contact in the range: the first that holds it
  ByFilm<FilmTableErrors> errors = {};
  std::optional<BendErrors> at_bend = {};  ///< where the range holds a bend that is an edge
  long solves = 0;                         ///< that the coefficients and the edges of panels are made of
  long held_out = 0;                       ///< further ones, which found the errors
  StopReason status = StopReason::converged;
  std::string reason = {};  ///< where status is not converged
};

/// A film in Hertz units with its derivatives.
struct FilmAt {
  double value = 0;
  double by_M = 0;
  double by_L = 0;
  /// In units of table_error_unit: next to a bend BendErrors, else FilmTableErrors::stated. Infinite: not known.
  double error = std::numeric_limits<double>::infinity();
};

/// All films at a contact; empty outside the range of the table, which has at least one panel.
[[nodiscard]] std::optional<ByFilm<FilmAt>> films_at(const FilmTable& table, const MoesGroups& at);

/// The same in one panel, without errors; L is in it.
[[nodiscard]] ByFilm<FilmAt> films_in(const FilmPanel& panel, const MoesGroups& at);

}  // namespace ehd
