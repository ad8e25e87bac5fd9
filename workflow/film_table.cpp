// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/film_table.hpp"

#include <algorithm>
#include <cmath>

#include "contact/hertz.hpp"
#include "workflow/chebyshev.hpp"

namespace ehd {

double table_shift(Quantity film) { return row_of(film).kind == QuantityKind::offset ? hertz::dry_offset() : 0; }

double table_error_unit(Quantity film, double value) {
  return has_absolute_error(film) ? std::max(1.0, value - table_shift(film)) : value;
}

double table_unit_of_stated(Quantity film, double value) {
  return has_absolute_error(film) ? table_error_unit(film, value) : 1;
}

bool FilmRange::contains(const MoesGroups& at) const {
  return at.M >= M_low && at.M <= M_high && at.L >= L_low && at.L <= L_high;
}

std::optional<ByFilm<FilmAt>> films_at(const FilmTable& table, const MoesGroups& at) {
  if (!table.range.contains(at)) return std::nullopt;
  const FilmPanel& panel = *std::find_if(table.panels.begin(), table.panels.end() - 1,
                                         [&](const auto& one) { return holds(one.shape, at); });
  ByFilm<FilmAt> films = films_in(panel, at);
  const double x = place_in(panel.shape, at).x;
  const bool at_bend = table.at_bend && (x < panel.x_first || x > panel.x_last);
  for (std::size_t k = 0; k < table_film_count; ++k)
    if (!at_bend)
      films[k].error = table.errors[k].stated;
    else if (table.at_bend->stated)
      films[k].error = (*table.at_bend->stated)[k];
  return films;
}

ByFilm<FilmAt> films_in(const FilmPanel& panel, const MoesGroups& at) {
  const PanelPlace place = place_in(panel.shape, at);
  const ChebyshevBasis x(panel.degree_M, place.x), y(panel.degree_L, place.y);
  ByFilm<FilmAt> films;
  for (std::size_t k = 0; k < table_film_count; ++k) {
    const ValueWithSlopes log_film = chebyshev_sum(panel.coefficients[k], x, y);
    const double film = std::exp(log_film.value);
    films[k] = {.value = film + table_shift(table_films[k]),
                .by_M = film * log_film.by_x * place.x_by_M,
                .by_L = film * (log_film.by_x * place.x_by_L + log_film.by_y * place.y_by_L)};
  }
  return films;
}

}  // namespace ehd
