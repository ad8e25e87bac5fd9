// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/table_beside_formulas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "contact/film_formulas.hpp"
#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/tables.hpp"
#include "verification/median.hpp"
#include "verification/studies/box.hpp"
#include "workflow/film_table_build.hpp"

namespace ehd::verification {

namespace {

/// Film, then name; the table sorts first by its blank.
using Deviations = std::map<std::pair<std::string, std::string>, std::vector<double>>;
constexpr const char* table_row_name = " this table";

Deviations deviations_of(const FilmMaps& maps, const FilmTable& table) {
  Deviations found;
  for (const MapPoint& point : maps.points) {
    const MoesGroups at{.M = point.at.M, .L = point.at.L};
    const auto films = films_at(table, at);
    if (point.at.laws != AtlasLaws::roelands || !films) continue;
    for (std::size_t k = 0; k < table_film_count; ++k) {
      const auto& certified = point.film(table_films[k]);
      if (has_absolute_error(table_films[k]) || !certified) continue;
      const double moes = (*films)[k].value * moes_film_per_hertz_film(at.M);
      found[{std::string(to_string(table_films[k])), table_row_name}].push_back(std::abs(moes / certified->value - 1));
    }
    for (const MapFormula& formula : point.formulas)
      found[{std::string(to_string(formula.of)), formula.name}].push_back(std::abs(formula.deviation));
  }
  return found;
}

/// Percent; below 0.1 the next power of ten, since the digits of a small deviation are the solver's.
std::string percent_or_power(double fraction) {
  const double value = 100 * fraction;
  return value >= 0.1 ? fixed(value, 1) : "< " + plain(std::pow(10, std::ceil(std::log10(value))), 1);
}

/// Microseconds of one call, the mean of many.
template <class Call>
double microseconds_of(Call call) {
  constexpr int calls = 20000;
  double sum = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < calls; ++i) sum += call(MoesGroups{.M = 3 + 0.04 * i, .L = 3 + 8e-4 * i});
  const std::chrono::duration<double, std::micro> passed = std::chrono::steady_clock::now() - begin;
  return std::isfinite(sum) ? passed.count() / calls : 0;
}

}  // namespace

FilmTable table_of_the_atlas(unsigned threads) {
  const TableOil of{.lubricant = oil(true)};
  const FilmTableRequest request{.range = {.M_low = 2, .M_high = 1000, .L_low = 2.5, .L_high = 20}};
  return build_film_table(of, request, film_solves(of, request.tolerance, threads, 300));
}

std::string table_beside_formulas(const FilmMaps& maps, const FilmTable& table) {
  std::string text = fmt::format(
      "A table of films beside the film formulas, against the certified films of {},\nroelands, flooded, M {} to {}, "
      "L {} to {}. Deviations in percent. The table is asked for {} %.\n\n",
      maps.source, plain(table.range.M_low), plain(table.range.M_high), plain(table.range.L_low),
      plain(table.range.L_high), plain(100 * table.tolerance));
  std::vector<std::vector<std::string>> rows{{"film", "by", "points", "median", "largest"}};
  for (auto& [names, deviations] : deviations_of(maps, table)) {
    rows.push_back({names.first, names.second, std::to_string(deviations.size()), percent_or_power(median(deviations)),
                    percent_or_power(*std::ranges::max_element(deviations))});
  }
  text += aligned(rows, 2, "  ");
  const double by_table = microseconds_of([&](const MoesGroups& at) { return films_at(table, at)->front().value; });
  const double by_formulas =
      microseconds_of([](const MoesGroups& at) { return film_formulas(at, usual_G).front().moes_film; });
  return text + fmt::format(
                    "\ntime: {} us for the four films of the table with their derivatives, {} us for all the "
                    "formulas\n",
                    plain(by_table, 2), plain(by_formulas, 2));
}

}  // namespace ehd::verification
