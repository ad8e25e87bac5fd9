// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/film_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "contact/film_formulas.hpp"
#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/tables.hpp"

namespace ehd::verification {

namespace {

using Row = std::map<std::string, std::string>;

/// A film of the table, in Hertz units.
std::optional<MapValue> film_in(const Row& row, const std::string& column) {
  const std::string &value = row.at(column), &error = row.at(column + "_error");
  if (value.empty() || error.empty()) return std::nullopt;
  return MapValue{std::stod(value), std::stod(error)};
}

std::optional<MapValue> in_moes(std::optional<MapValue> film, double M) {
  if (film) film->value *= moes_film_per_hertz_film(M);
  return film;
}

/// cut/flooded - 1; the uncertainty of a ratio is the sum of the relative ones.
std::optional<MapValue> cost_of(const std::optional<MapValue>& cut, const std::optional<MapValue>& flooded) {
  if (!cut || !flooded) return std::nullopt;
  const double ratio = cut->value / flooded->value;
  return MapValue{ratio - 1, ratio * (cut->error + flooded->error)};
}

AtlasPoint point_of(const Row& row) {
  AtlasPoint point;
  for (const AtlasLaws laws : all_atlas_laws)
    if (row.at("laws") == to_string(laws)) point.laws = laws;
  point.M = std::stod(row.at("M"));
  point.L = std::stod(row.at("L"));
  return point;
}

}  // namespace

const std::optional<MapValue>& MapPoint::film(Quantity quantity) const {
  if (quantity == Quantity::film_minimum) return minimum;
  return quantity == Quantity::film_central ? central : couette;
}

const std::optional<MapValue>& MapPoint::cost(Quantity film) const {
  return film == Quantity::film_minimum ? minimum_cost : central_cost;
}

FilmMaps film_maps(const AtlasTable& table) {
  FilmMaps maps{.source = "cases/atlas/atlas.csv", .M = {}, .L = {}, .points = {}};
  std::set<double> all_M, all_L;
  std::map<std::string, const Row*> cut;  // by "laws M L"
  const auto key = [](const Row& row) { return fmt::format("{} {} {}", row.at("laws"), row.at("M"), row.at("L")); };
  for (const Row& row : table.rows)
    if (row.at("inlet") == "-4") cut[key(row)] = &row;
  for (const Row& row : table.rows) {
    if (row.at("inlet") != "flooded") continue;
    MapPoint point;
    point.at = point_of(row);
    const double M = point.at.M, L = point.at.L;
    all_M.insert(M);
    all_L.insert(L);
    const auto minimum = film_in(row, "H_min"), central = film_in(row, "H_cen");
    point.minimum = in_moes(minimum, M);
    point.central = in_moes(central, M);
    point.couette = in_moes(film_in(row, "H_couette"), M);
    if (const auto at = cut.find(key(row)); at != cut.end()) {
      point.minimum_cost = cost_of(film_in(*at->second, "H_min"), minimum);
      point.central_cost = cost_of(film_in(*at->second, "H_cen"), central);
    }
    for (const FilmFormula& formula : film_formulas({.M = M, .L = L}, usual_G)) {
      const auto& certified = point.film(formula.of);
      if (!certified) continue;
      point.formulas.push_back({.name = formula.name,
                                .of = formula.of,
                                .moes = formula.moes_film,
                                .deviation = formula.moes_film / certified->value - 1});
    }
    maps.points.push_back(std::move(point));
  }
  maps.M.assign(all_M.begin(), all_M.end());
  maps.L.assign(all_L.begin(), all_L.end());
  return maps;
}

FilmMaps film_maps(const std::filesystem::path& folder) { return film_maps(read_atlas_table(folder / "atlas.csv")); }

// -- for a reader -----------------------------------------------------------------------------------------------

namespace {

constexpr int most_digits = 15;

/// A number of each point, its error absolute; absent where it is not known.
using Field = std::function<std::optional<MapValue>(const MapPoint&)>;

/// The middle of sorted values: of an even number the mean of both middle ones, with the larger of their errors.
MapValue median(const std::vector<MapValue>& sorted) {
  const MapValue &low = sorted[(sorted.size() - 1) / 2], &high = sorted[sorted.size() / 2];
  return {(low.value + high.value) / 2, std::max(low.error, high.error)};
}

/// The points of one set of laws, isoviscous ones (L = 0) among them.
std::vector<const MapPoint*> points_of(const FilmMaps& maps, AtlasLaws laws) {
  std::vector<const MapPoint*> points;
  for (const MapPoint& point : maps.points)
    if (point.at.laws == laws || point.at.laws == AtlasLaws::isoviscous) points.push_back(&point);
  return points;
}

const MapPoint* at(const std::vector<const MapPoint*>& points, double M, double L) {
  const auto found =
      std::find_if(points.begin(), points.end(), [&](const MapPoint* one) { return one->at.M == M && one->at.L == L; });
  return found == points.end() ? nullptr : *found;
}

/// Rows of L, columns of M, percent; "*" behind numerical tests, "-" where nothing is known; L and M that have no
/// value at all are left out.
std::string percent_table(const FilmMaps& maps, const std::vector<const MapPoint*>& points, const Field& field) {
  std::vector<double> columns;
  for (const double M : maps.M)
    if (std::any_of(points.begin(), points.end(), [&](const MapPoint* one) { return one->at.M == M && field(*one); }))
      columns.push_back(M);
  std::vector<std::vector<std::string>> rows(1, {"L \\ M"});
  for (const double M : columns) rows.front().push_back(plain(M) + " ");
  for (const double L : maps.L) {
    std::vector<std::string> row{plain(L)};
    bool any = false;
    for (const double M : columns) {
      const MapPoint* point = at(points, M, L);
      const auto value = point ? field(*point) : std::nullopt;
      any = any || value;
      row.push_back(value ? known_percent(*value) + (point->at.numerical_test() ? "*" : " ") : "- ");
    }
    if (any) rows.push_back(std::move(row));
  }
  return aligned_in_parts(rows, 1, "    ");
}

/// "0.5 ... 20, 200": runs of neighbouring M of the table where `holds`. A point that is not known ends a run.
std::string runs_of_M(const FilmMaps& maps, const std::vector<const MapPoint*>& points, double L, const Field& field,
                      const std::function<bool(double)>& holds) {
  std::string text;
  std::optional<double> first, last;
  const auto close = [&] {
    if (first)
      text += (text.empty() ? "" : ", ") + plain(*first) + (*last > *first ? " ... " + plain(*last) : std::string());
    first.reset();
  };
  for (const double M : maps.M) {
    const MapPoint* point = at(points, M, L);
    const auto value = point ? field(*point) : std::nullopt;
    if (!value || !holds(value->value)) {
      close();
      continue;
    }
    if (!first) first = M;
    last = M;
  }
  close();
  return text.empty() ? "nowhere" : text;
}

struct NamedFormula {
  std::string name;
  Quantity of;
};

std::vector<NamedFormula> formulas_of(const FilmMaps& maps, std::optional<Quantity> quantity) {
  std::vector<NamedFormula> names;
  for (const MapPoint& point : maps.points) {
    for (const MapFormula& formula : point.formulas) {
      const bool asked = !quantity || formula.of == quantity ||
                         (quantity == Quantity::film_central && formula.of == Quantity::film_couette);
      if (asked && std::none_of(names.begin(), names.end(), [&](const NamedFormula& one) {
            return one.name == formula.name && one.of == formula.of;
          }))
        names.push_back({formula.name, formula.of});
    }
  }
  std::stable_sort(names.begin(), names.end(), [](const NamedFormula& one, const NamedFormula& other) {
    return to_string(one.of) > to_string(other.of);
  });
  return names;
}

Field deviation_of(const NamedFormula& formula) {
  return [formula](const MapPoint& point) -> std::optional<MapValue> {
    for (const MapFormula& one : point.formulas)
      if (one.name == formula.name && one.of == formula.of)
        return MapValue{one.deviation, (1 + one.deviation) * point.film(formula.of)->error};
    return std::nullopt;
  };
}

bool is_close(double deviation) { return std::abs(deviation) <= close_formula; }
bool is_poor(double deviation) { return std::abs(deviation) >= poor_formula; }

/// A line for each formula: how many points are within 5 %, and 30 % or more off; then the same at M >= 2 and
/// p_H <= 4 GPa, where bearings run, with the median and the extremes.
std::string overview(const std::vector<NamedFormula>& formulas, const std::vector<const MapPoint*>& points) {
  constexpr double bearings_M = 2;
  std::vector<std::vector<std::string>> rows{{"formula", "film", "points", "within 5 %", "30 % off",
                                              "M >= 2, up to 4 GPa", "there within 5 %", "there 30 % off", "median",
                                              "lowest", "highest"}};
  for (const NamedFormula& formula : formulas) {
    const Field deviation = deviation_of(formula);
    std::vector<MapValue> all, bearings;
    for (const MapPoint* point : points) {
      const auto value = deviation(*point);
      if (!value) continue;
      all.push_back(*value);
      if (point->at.M >= bearings_M && !point->at.numerical_test()) bearings.push_back(*value);
    }
    if (all.empty()) continue;
    const auto count = [](const std::vector<MapValue>& values, bool (*holds)(double)) {
      return std::to_string(
          std::count_if(values.begin(), values.end(), [&](const MapValue& one) { return holds(one.value); }));
    };
    std::vector<std::string> row{formula.name, std::string(to_string(formula.of)), std::to_string(all.size()),
                                 count(all, is_close), count(all, is_poor)};
    row.push_back(std::to_string(bearings.size()));
    row.push_back(count(bearings, is_close));
    row.push_back(count(bearings, is_poor));
    std::sort(bearings.begin(), bearings.end(),
              [](const MapValue& one, const MapValue& other) { return one.value < other.value; });
    if (!bearings.empty()) {
      row.push_back(known_percent(median(bearings)));
      row.push_back(known_percent(bearings.front()));
      row.push_back(known_percent(bearings.back()));
    }
    rows.push_back(std::move(row));
  }
  return aligned_in_parts(rows, 2, "  ");
}

}  // namespace

std::string known_percent(const MapValue& fraction) {
  const double value = 100 * fraction.value, size = std::abs(value), error = 100 * fraction.error;
  if (size <= error) return "0";
  int decimals = size < 0.995 ? 2 : size < 9.95 ? 1 : 0;
  // A digit is known where the error is below half of its unit.
  while (decimals > 0 && !(error < 0.5 * std::pow(10.0, -decimals))) --decimals;
  if (size < 0.5 * std::pow(10.0, -decimals)) return "0";
  return signed_fixed(value, decimals);
}

std::string human_maps(const FilmMaps& maps, std::optional<Quantity> quantity, AtlasLaws laws) {
  const auto points = points_of(maps, laws);
  const auto formulas = formulas_of(maps, quantity);
  std::string text = fmt::format(
      "Film formulas against the certified films of {},\n{}{}, flooded\n"
      "Published fits, for comparison only. Power laws with G = {}, mean speed in U.\n"
      "Percent = 100 (formula/film - 1), as many digits as are known, 0 where it is within its own error;\n"
      "* p_H above 4 GPa; - not known; L = 0 is isoviscous and incompressible.\n\n{}",
      maps.source, to_string(laws),
      laws == AtlasLaws::roelands ? " (z = 0.68, Dowson-Higginson density)" : ", incompressible", plain(usual_G),
      overview(formulas, points));
  for (const NamedFormula& formula : formulas) {
    const Field deviation = deviation_of(formula);
    text += fmt::format("\n{}, {}: deviation in percent\n{}", formula.name, to_string(formula.of),
                        percent_table(maps, points, deviation));
    std::vector<std::vector<std::string>> regions{{"L", "within 5 % at M =", "30 % or more off at M ="}};
    for (const double L : maps.L) {
      if (std::none_of(points.begin(), points.end(),
                       [&](const MapPoint* one) { return one->at.L == L && deviation(*one); }))
        continue;
      regions.push_back(
          {plain(L), runs_of_M(maps, points, L, deviation, is_close), runs_of_M(maps, points, L, deviation, is_poor)});
    }
    text += "\n" + aligned(regions, 3, "    ");
  }
  for (const Quantity film : judged_films) {
    if (quantity && quantity != film) continue;
    text += fmt::format("\nInlet cut at X = -4, {} against flooded, in percent\n{}", to_string(film),
                        percent_table(maps, points, [film](const MapPoint& point) { return point.cost(film); }));
  }
  return text;
}

// -- for programs -----------------------------------------------------------------------------------------------

namespace {

std::string point_cells(const MapPoint& point) {
  const double pressure = point.at.hertz_pressure_Pa();
  return fmt::format("{},{},{},{},{}", to_string(point.at.laws), plain(point.at.M), plain(point.at.L),
                     pressure > 0 ? plain(pressure / 1e9) : std::string(), point.at.numerical_test() ? "yes" : "no");
}
constexpr std::string_view point_header = "laws,M,L,p_H_GPa,numerical_test";

}  // namespace

std::string formula_maps_csv(const FilmMaps& maps) {
  std::string text = fmt::format(
      "# Film formulas over the atlas: films in Moes units, flooded; deviation = formula/certified - 1; G = "
      "{}\n{},quantity,certified_moes,certified_error,formula,formula_moes,deviation\n",
      plain(usual_G), point_header);
  for (const MapPoint& point : maps.points) {
    for (const MapFormula& formula : point.formulas) {
      const auto& certified = point.film(formula.of);
      text += fmt::format("{},{},{},{},{},{},{}\n", point_cells(point), to_string(formula.of),
                          plain(certified->value, most_digits), plain(certified->error), formula.name,
                          plain(formula.moes, 6), plain(formula.deviation, 6));
    }
  }
  return text;
}

std::string inlet_maps_csv(const FilmMaps& maps) {
  std::string text =
      "# Inlet cut at X = -4 over the atlas: films in Moes units; cost = cut/flooded - 1, its uncertainty absolute\n" +
      std::string(point_header) + ",quantity,flooded_moes,cost,cost_error\n";
  for (const MapPoint& point : maps.points) {
    for (const Quantity film : judged_films) {
      const auto& cost = point.cost(film);
      if (!cost) continue;
      text += fmt::format("{},{},{},{},{}\n", point_cells(point), to_string(film),
                          plain(point.film(film)->value, most_digits), plain(cost->value, 6), plain(cost->error, 2));
    }
  }
  return text;
}

}  // namespace ehd::verification
