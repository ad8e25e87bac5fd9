// SPDX-License-Identifier: GPL-3.0-or-later
// A table of films as C99: one file with data and evaluator, which needs math.h alone.
#pragma once

#include <string>

#include "workflow/film_table.hpp"

namespace ehd {

/// The file. Its names begin with "ehd_" and the id of the case, so that a program can hold several tables:
/// `int ehd_own_moes_20_10_film(int film, double M, double L, double *value, double *by_M, double *by_L)`.
[[nodiscard]] std::string film_table_c(const FilmTable& table);

/// "ehd_own_moes_20_10": the beginning of its names.
[[nodiscard]] std::string film_table_c_prefix(const FilmTable& table);

}  // namespace ehd
