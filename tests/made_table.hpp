// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of films that nobody solved: the films are formulas.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "contact/hertz.hpp"
#include "workflow/film_table_build.hpp"

namespace ehd::testing {

inline const FilmRange made_range{.M_low = 3, .M_high = 400, .L_low = 2, .L_high = 18};

/// Smooth films with the powers of film formulas; the offset is negative in most of the range.
[[nodiscard]] inline ByFilm<double> made_films(const MoesGroups& at) {
  const double central = 0.9 * std::pow(at.M, -1.1) * std::pow(1 + at.L, 0.7);
  return {0.85 * central, central, 1.1 * central, hertz::dry_offset() + central * (1 + 0.1 / at.M)};
}

/// The films `films`, each with the error 1e-7; the contacts go to `asked`.
[[nodiscard]] inline FilmSource made_source(const std::function<ByFilm<double>(const MoesGroups&)>& films,
                                            std::vector<MoesGroups>* asked = nullptr) {
  return [=](const std::vector<MoesGroups>& contacts) {
    std::vector<SolvedFilms> solved;
    for (const MoesGroups& at : contacts) {
      solved.push_back({.value = films(at), .error = {1e-7, 1e-7, 1e-7, 1e-7}});
      if (asked) asked->push_back(at);
    }
    return solved;
  };
}

[[nodiscard]] inline TableOil made_oil() {
  return {.lubricant = {.viscosity = ViscosityLaw::roelands,
                        .density = DensityLaw::dowson_higginson,
                        .alpha_per_Pa = 2.1e-8,
                        .z = 0.67,
                        .p0_Pa = 1.9e8}};
}

[[nodiscard]] inline FilmTable made_table(double tolerance = 1e-6) {
  FilmTable table =
      build_film_table(made_oil(), {.range = made_range, .tolerance = tolerance}, made_source(made_films));
  table.case_id = "made-oil-1.5";
  table.version = 7;
  return table;
}

/// A table whose central film has a corner: below this M it falls by 0.3 times the root of the distance in ln M.
inline const FilmRange corner_range{.M_low = 1.2, .M_high = 60, .L_low = 2, .L_high = 18};
[[nodiscard]] inline double corner_M(double L) { return 2.4 * std::pow(1 + L, -0.2); }
[[nodiscard]] inline ByFilm<double> corner_films(const MoesGroups& at) {
  ByFilm<double> films = made_films(at);
  films[1] *= std::exp(-0.3 * std::sqrt(std::max(0.0, std::log(corner_M(at.L) / at.M))));
  return films;
}
/// The peak of the pressure passes X = 0 at the corner.
[[nodiscard]] inline FilmSource corner_source() {
  return [](const std::vector<MoesGroups>& contacts) {
    std::vector<SolvedFilms> solved = made_source(corner_films)(contacts);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      solved[i].peak_X = 0.8 * std::tanh(std::log(contacts[i].M / corner_M(contacts[i].L)));
      solved[i].peak = 10;
    }
    return solved;
  };
}
[[nodiscard]] inline FilmTable corner_table() {
  FilmTable table = build_film_table(made_oil(), {.range = corner_range, .tolerance = 1e-5}, corner_source());
  table.case_id = "made-oil-1.5";
  table.version = 7;
  return table;
}

}  // namespace ehd::testing
