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

bool FilmRange::contains(const MoesGroups& at) const {
  return at.M >= M_low && at.M <= M_high && at.L >= L_low && at.L <= L_high;
}

PanelPlace place_in(const FilmPanel& panel, const FilmRange& range, const MoesGroups& at) {
  const double a = std::log(panel.M_low), across = std::log(panel.M_high) - a;
  const double b = std::log1p(range.L_low), along = std::log1p(range.L_high) - b;
  return {.x = 2 * (std::log(at.M) - a) / across - 1,
          .x_by_M = 2 / (across * at.M),
          .y = 2 * (std::log1p(at.L) - b) / along - 1,
          .y_by_L = 2 / (along * (1 + at.L))};
}

MoesGroups contact_at(const FilmPanel& panel, const FilmRange& range, double x, double y) {
  const double a = std::log(panel.M_low), across = std::log(panel.M_high) - a;
  const double b = std::log1p(range.L_low), along = std::log1p(range.L_high) - b;
  return {.M = std::clamp(std::exp(a + across * (x + 1) / 2), panel.M_low, panel.M_high),
          .L = std::clamp(std::expm1(b + along * (y + 1) / 2), range.L_low, range.L_high)};
}

std::optional<ByFilm<FilmAt>> films_at(const FilmTable& table, const MoesGroups& at) {
  if (!table.range.contains(at)) return std::nullopt;
  const FilmPanel& panel =
      *std::find_if(table.panels.begin(), table.panels.end() - 1, [&](const auto& one) { return at.M <= one.M_high; });
  const PanelPlace place = place_in(panel, table.range, at);
  const ChebyshevBasis x(panel.degree_M, place.x), y(panel.degree_L, place.y);
  ByFilm<FilmAt> films;
  for (std::size_t k = 0; k < table_film_count; ++k) {
    const ValueWithSlopes log_film = chebyshev_sum(panel.coefficients[k], x, y);
    const double film = std::exp(log_film.value);
    films[k] = {.value = film + table_shift(table_films[k]),
                .by_M = film * log_film.by_x * place.x_by_M,
                .by_L = film * log_film.by_y * place.y_by_L};
  }
  return films;
}

}  // namespace ehd
