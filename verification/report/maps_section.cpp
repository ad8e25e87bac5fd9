// SPDX-License-Identifier: GPL-3.0-or-later
// Maps over the Moes groups M and L: certified films, deviations of the film formulas, the cost of a cut inlet,
// iterations and cost of `fast`.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <tuple>

#include "contact/text.hpp"
#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

struct Atlas {
  std::vector<double> M, L;
  std::vector<View> points;
  std::vector<std::string> law_sets;
};

/// A film, and its name at the beginning of a heading.
struct Film {
  std::string name, heading;
};
const Film films[] = {{"minimum", "Minimum"}, {"central", "Central"}};

/// The point of a law set at (M, L); L = 0 has one contact for all law sets.
const View* point_at(const Atlas& atlas, const std::string& laws, double M, double L) {
  const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b)); };
  for (const View& point : atlas.points) {
    const std::string of = point.text("laws");
    if ((of == laws || (of == "isoviscous" && L == 0)) && same(point.number("M").value_or(-1), M) &&
        same(point.number("L").value_or(-1), L))
      return &point;
  }
  return nullptr;
}

/// In per cent with a sign, with as many decimals as fit into a cell.
std::string short_percent(double share) {
  const double value = 100 * share, size = std::abs(value);
  if (!(size >= 0.005)) return "0.00";
  const int decimals = size < 0.0995 ? 2 : size < 9.95 ? 1 : 0;
  return with_minus_sign(signed_fixed(value, decimals));
}

std::string percent_hint(double share) { return percent(share, 3); }

std::string lawful(const std::string& laws) {
  if (laws == "roelands") return "Roelands, compressible";
  if (laws == "barus") return "Barus, incompressible";
  return laws;
}

/// A quantity as maps. One map for each law set, whose name is appended to id, title and heading.
struct Shown {
  std::string id, title, description, heading, caption;
  std::function<std::optional<double>(const View& point)> value;
  std::function<std::string(double)> text, hint;  ///< of a value: in its cell, in the read-out
  std::function<void(HeatMap&)> style = {};
};

/// The loads and materials at which the quantity is known anywhere: a map has no empty rows and columns.
std::pair<std::vector<double>, std::vector<double>> covered(
    const Atlas& atlas, const std::string& laws, const std::function<std::optional<double>(const View&)>& value) {
  std::set<double> Ms, Ls;
  for (const double M : atlas.M) {
    for (const double L : atlas.L) {
      const View* point = point_at(atlas, laws, M, L);
      const auto known = point ? value(*point) : std::nullopt;
      if (!known || !std::isfinite(*known)) continue;
      Ms.insert(M);
      Ls.insert(L);
    }
  }
  return {{Ms.begin(), Ms.end()}, {Ls.begin(), Ls.end()}};
}

/// The map of one law set; absent where no point has the quantity.
std::optional<HeatMap> map_of(const Atlas& atlas, const std::string& laws, const Shown& shown) {
  HeatMap map;
  map.x_label = "load group *M*";
  map.y_label = "lubricant group *L*";
  bool any = false;
  std::tie(map.x, map.y) = covered(atlas, laws, shown.value);
  for (const double L : map.y) {
    for (const double M : map.x) {
      const View* point = point_at(atlas, laws, M, L);
      Cell cell;
      cell.hint = fmt::format("M = {}, L = {}: ", plain(M), plain(L));
      if (point) {
        cell.value = shown.value(*point);
        cell.hatched = point->flag("numerical_test").value_or(false);
      }
      if (cell.value && std::isfinite(*cell.value)) {
        any = true;
        cell.text = shown.text(*cell.value);
        cell.hint += shown.hint(*cell.value);
        if (const auto pressure = point->number("p_H_Pa")) cell.hint += ", p_H = " + plain(*pressure / 1e9, 3) + " GPa";
      } else {
        cell.hint += "not known";
      }
      map.cells.push_back(std::move(cell));
    }
  }
  if (!any) return std::nullopt;
  map.id = shown.id + "-" + laws;
  map.title = shown.title + ", " + lawful(laws);
  map.description = shown.description;
  map.heading = shown.heading + ", " + lawful(laws);
  if (shown.style) shown.style(map);
  return map;
}

/// `seen` is called with each map and its law set.
void add_maps_of(Page& page, const Atlas& atlas, const Shown& shown,
                 const std::function<void(const HeatMap&, const std::string&)>& seen = {}) {
  for (const std::string& laws : atlas.law_sets) {
    auto map = map_of(atlas, laws, shown);
    if (!map) continue;
    if (seen) seen(*map, laws);
    page.figure(std::move(*map), shown.caption);
  }
}

bool any_point(const Atlas& atlas, const std::function<bool(const View&)>& has) {
  return std::any_of(atlas.points.begin(), atlas.points.end(), has);
}

/// 1, 2, 5, 10, ... between the extreme values; decades are left out where there are many.
std::vector<ContourLevel> decade_levels(const HeatMap& map) {
  constexpr int most_decades = 12;
  double low = 1e300, high = 0;
  for (const Cell& cell : map.cells) {
    if (!cell.value || !(*cell.value > 0) || !std::isfinite(*cell.value)) continue;
    low = std::min(low, *cell.value);
    high = std::max(high, *cell.value);
  }
  std::vector<ContourLevel> levels;
  if (!(low < high)) return levels;
  const int first = static_cast<int>(std::floor(std::log10(low))), last = static_cast<int>(std::log10(high));
  const int step = 1 + (last - first) / most_decades;
  for (int decade = first; decade <= last; decade += step) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double level = digit * std::pow(10, decade);
      if (level > low && level < high)
        levels.push_back({level, digit == 1 ? Line::solid : Line::dashed, number_markup(level, 3)});
    }
  }
  return levels;
}

void draw_decades(HeatMap& map) {
  map.logarithmic = true;
  map.contours = decade_levels(map);
}

void add_films(Page& page, const Atlas& atlas) {
  page.heading("Certified film");
  page.begin_fold("Maps of the smallest and the central film");
  page.begin_figures("maps");
  for (const Film& film : films)
    add_maps_of(page, atlas,
                {.id = "fig-film-" + film.name,
                 .title = "Certified " + film.name + " film over M and L",
                 .description = "Film in Moes units, flooded, a number a cell, with contour lines.",
                 .heading = film.heading + " film *H*_{Moes}",
                 .caption = "<i>H</i><sub>Moes</sub> = (<i>h</i>/<i>R</i>) <i>U</i><sub>s</sub><sup>\u22121/2</sup>, "
                            "flooded, by <code>reference</code>; contour lines at 1, 2 and 5 of each decade.",
                 .value = [&](const View& point) { return point.number("film_" + film.name + "_moes"); },
                 .text = [](double value) { return plain(value, 3); },
                 .hint = [](double value) { return "H_Moes = " + plain(value, 8); },
                 .style = draw_decades});
  page.end_figures();
  page.end_fold();
}

constexpr double good = 0.05, poor = 0.30;

void draw_percents(HeatMap& map) {
  map.colours = Colours::diverging;
  map.limit = 0.5;
  for (const double sign : {-1.0, 1.0}) {
    map.contours.push_back({sign * good, Line::solid, ""});
    map.contours.push_back({sign * poor, Line::dashed, ""});
  }
  map.keys = {{Line::solid, "\u00b15 %"}, {Line::dashed, "\u00b130 %"}};
}

/// One row of the table of formulas: the points of a map below 4 GPa.
std::vector<TableCell> formula_row(const std::string& name, const std::string& quantity, const std::string& laws,
                                   const HeatMap& map) {
  double lowest = 0, highest = 0;
  int points = 0, near = 0, fair = 0;
  for (const Cell& cell : map.cells) {
    if (!cell.value || !std::isfinite(*cell.value) || cell.hatched) continue;
    ++points;
    near += std::abs(*cell.value) <= good ? 1 : 0;
    fair += std::abs(*cell.value) <= poor ? 1 : 0;
    lowest = std::min(lowest, *cell.value);
    highest = std::max(highest, *cell.value);
  }
  return {words(name),
          words(quantity),
          words(lawful(laws)),
          integer_cell(points),
          integer_cell(near),
          integer_cell(fair),
          {short_percent(lowest) + " %", "number"},
          {short_percent(highest) + " %", "number"}};
}

void add_formulas(Page& page, const Atlas& atlas) {
  std::vector<std::pair<std::string, std::string>> formulas;
  for (const View& point : atlas.points) {
    for (const View& formula : point.list("formulas")) {
      const std::pair name{formula.text("name"), formula.text("quantity")};
      if (std::find(formulas.begin(), formulas.end(), name) == formulas.end()) formulas.push_back(name);
    }
  }
  if (formulas.empty()) return;
  page.heading("Film formulas: deviation from the certified film, in %");
  page.paragraph(
      "Formula over certified film, less 1. Between the solid lines a formula is within 5\u2009%, beyond the dashed "
      "ones it is more than 30\u2009% off. The formulas are published fits, for comparison only.");
  Table table;
  table.caption = "Where the formulas hold, of all points below 4 GPa";
  table.columns = {"formula", "film", "laws", "points", "within 5 %", "within 30 %", "largest below", "largest above"};
  page.begin_fold("Maps of the deviation, formula by formula");
  page.begin_figures("maps");
  for (const auto& formula : formulas) {
    const auto& [name, quantity] = formula;
    const auto deviation = [&formula](const View& point) -> std::optional<double> {
      for (const View& one : point.list("formulas"))
        if (one.text("name") == formula.first && one.text("quantity") == formula.second) return one.number("deviation");
      return std::nullopt;
    };
    add_maps_of(page, atlas,
                {.id = fmt::format("fig-formula-{}-{}", name, quantity),
                 .title = name + " against the certified " + quantity,
                 .description = "Deviation in per cent, a number a cell; contour lines at 5 and 30 per cent.",
                 .heading = literal(name) + ", " + literal(quantity),
                 .caption = fmt::format("<b>{}</b>: deviation of its {} [%].", escaped(name), escaped(quantity)),
                 .value = deviation,
                 .text = short_percent,
                 .hint = percent_hint,
                 .style = draw_percents},
                [&](const HeatMap& map, const std::string& laws) {
                  table.rows.push_back(formula_row(formula.first, formula.second, laws, map));
                });
  }
  page.end_figures();
  page.end_fold();
  page.begin_fold("Where the formulas hold: one row for each formula, film and law set", "formulas");
  page.add(table);
  page.end_fold();
}

void draw_inlet_cost(HeatMap& map) {
  map.colours = Colours::diverging;
  map.limit = 0.5;
  map.contours = {{-0.01, Line::dotted, ""}, {-0.05, Line::solid, ""}, {-0.30, Line::dashed, ""}};
  map.keys = {{Line::dotted, "\u22121 %"}, {Line::solid, "\u22125 %"}, {Line::dashed, "\u221230 %"}};
}

void add_inlet(Page& page, const Atlas& atlas) {
  if (!any_point(atlas,
                 [](const View& point) { return point.has("inlet_cost_minimum") || point.has("inlet_cost_central"); }))
    return;
  page.heading("Cost of an inlet cut at <i>X</i> = \u22124, in %");
  page.paragraph(
      "From <i>M</i> = 2 on. In a lighter contact the inlet zone begins before <i>X</i> = \u22124: such an inlet would "
      "cut the zone itself.");
  page.begin_fold("Maps of the cost");
  page.begin_figures("maps");
  for (const Film& film : films)
    add_maps_of(page, atlas,
                {.id = "fig-inlet-" + film.name,
                 .title = "Cost of an inlet cut at X = -4: " + film.name + " film",
                 .description =
                     "Film of the cut contact over that of the flooded one, less 1, in per cent; contour lines at 1, "
                     "5 and 30 per cent.",
                 .heading = film.heading + " film, cut over flooded",
                 .caption = "Film with the inlet cut at <i>X</i> = \u22124 over the flooded film, less 1 [%].",
                 .value = [&](const View& point) { return point.number("inlet_cost_" + film.name); },
                 .text = short_percent,
                 .hint = percent_hint,
                 .style = draw_inlet_cost});
  page.end_figures();
  page.end_fold();
}

/// A number that `fast` records of its solves.
struct Counted {
  std::string key, heading, unit;
  double factor;
  int digits;
};
const Counted counted[] = {{"newton_iterations", "Newton iterations", "", 1, 6},
                           {"krylov_iterations", "Krylov iterations", "", 1, 6},
                           {"work_units", "Work units", "", 1, 3},
                           {"wall_s", "Time [ms]", " ms", 1e3, 2},
                           {"nodes", "Intervals on the finest grid", "", 1, 6}};

void add_fast(Page& page, const Atlas& atlas) {
  if (!any_point(atlas, [](const View& point) { return point.has("fast"); })) return;
  std::string tolerance;
  std::map<std::string, int> endings;
  for (const View& point : atlas.points) {
    const View fast = point["fast"];
    if (!fast.exists()) continue;
    if (tolerance.empty()) tolerance = fast.cell("tolerance", 3);
    ++endings[fast.text("status")];
  }
  std::string summary;
  for (const auto& [status, count] : endings)
    summary += fmt::format("{}{} {}", summary.empty() ? "" : ", ", count, escaped(status));
  page.heading("Iterations and cost of <code>fast</code>" +
               (tolerance.empty() ? std::string() : " at tolerance " + escaped(tolerance)));
  page.paragraph("How the solves of the points ended: " + summary + ".");
  page.begin_fold("Maps of iterations, work, time and achieved error");
  page.begin_figures("maps");
  for (const Counted& one : counted)
    add_maps_of(page, atlas,
                {.id = "fig-fast-" + one.key,
                 .title = one.heading + " of fast over M and L",
                 .description = one.heading + ", a number a cell, with contour lines.",
                 .heading = one.heading,
                 .caption = one.heading + " of <code>fast</code>; contour lines at 1, 2 and 5 of each decade.",
                 .value = [&](const View& point) { return scaled(point["fast"].number(one.key), one.factor); },
                 .text = [&](double value) { return plain(value, one.digits); },
                 .hint = [&](double value) { return plain(value, 4) + one.unit; },
                 .style = draw_decades});
  const auto achieved = [](const View& point, const Film& film) -> std::optional<double> {
    const auto value = point["fast"].number("deviation_" + film.name);
    return value ? std::optional(std::max(std::abs(*value), 1e-16)) : std::nullopt;
  };
  for (const Film& film : films)
    add_maps_of(page, atlas,
                {.id = "fig-fast-deviation-" + film.name,
                 .title = "Achieved error of fast, " + film.name + " film",
                 .description = "Magnitude of the relative difference from the certified film, a number a cell.",
                 .heading = "Achieved error, " + film.name + " film",
                 .caption = "|<code>fast</code>/certified \u2212 1| of the " + film.name + " film, flooded.",
                 .value = [&](const View& point) { return achieved(point, film); },
                 .text = [](double value) { return plain(value, 1); },
                 .hint = [](double value) { return "|fast/certified - 1| = " + plain(value, 3); },
                 .style = [](HeatMap& map) { map.logarithmic = true; }});
  page.end_figures();
  page.end_fold();
}

}  // namespace

void add_maps(Page& page, const View& results) {
  page.section("maps", "Maps over M and L", "Maps");
  const View maps = results["figures"]["maps"];
  Atlas atlas{.M = maps.numbers("M"), .L = maps.numbers("L"), .points = maps.list("points"), .law_sets = {}};
  for (auto* axis : {&atlas.M, &atlas.L}) {
    std::erase_if(*axis, [](double value) { return !std::isfinite(value); });
    std::sort(axis->begin(), axis->end());
  }
  if (atlas.points.empty() || atlas.M.empty() || atlas.L.empty()) {
    page.absent("Maps over (M, L) are", "ehd verify --output DIR");
    return;
  }
  for (const std::string laws : {"roelands", "barus", "isoviscous"}) {
    const bool own = any_point(atlas, [&](const View& point) { return point.text("laws") == laws; });
    // The isoviscous row, L = 0, is part of the other sets where there are any.
    if (own && (laws != "isoviscous" || atlas.law_sets.empty())) atlas.law_sets.push_back(laws);
  }
  const auto source = maps.text("source");
  page.paragraph(
      "Each cell is one contact, its number the computed value; colours and contour lines show the same numbers. "
      "Contour lines are straight between the centres of the cells." +
      (source.empty() ? std::string() : " The points are those of <code>" + escaped(source) + "</code>."));
  add_films(page, atlas);
  add_formulas(page, atlas);
  add_inlet(page, atlas);
  add_fast(page, atlas);
}

}  // namespace ehd::report
