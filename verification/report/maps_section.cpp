// SPDX-License-Identifier: GPL-3.0-or-later
// Maps over the Moes groups M and L: certified films, what formulas make of them, what a cut inlet costs, what `fast`
// needs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "contact/text.hpp"
#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

struct Atlas {
  std::vector<double> M, L;
  std::vector<View> points;
};

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

/// In per cent with a sign, as many decimals as a cell has room for.
std::string percent(double share) {
  const double value = 100 * share, size = std::abs(value);
  if (!(size >= 0.005)) return "0.00";
  const int decimals = size < 0.0995 ? 2 : size < 9.95 ? 1 : 0;
  std::string result = fmt::format("{:+.{}f}", value, decimals);
  if (result.front() == '-') result.replace(0, 1, "\u2212");
  return result;
}

std::string percent_hint(double share) { return plain(100 * share, 3) + " %"; }

using Value = std::function<std::optional<double>(const View&)>;
using Text = std::function<std::string(double)>;

/// A map of one quantity; nothing is drawn where no point has it.
std::optional<HeatMap> map_of(const Atlas& atlas, const std::string& laws, const Value& value, const Text& text,
                              const Text& hint) {
  HeatMap map;
  map.x = atlas.M;
  map.y = atlas.L;
  map.x_label = "load parameter *M*";
  map.y_label = "material parameter *L*";
  bool any = false;
  for (const double L : atlas.L) {
    for (const double M : atlas.M) {
      const View* point = point_at(atlas, laws, M, L);
      Cell cell;
      cell.hint = "M = " + plain(M) + ", L = " + plain(L) + ": ";
      if (point) {
        cell.value = value(*point);
        cell.hatched = point->flag("numerical_test").value_or(false);
      }
      if (cell.value && std::isfinite(*cell.value)) {
        any = true;
        cell.text = text(*cell.value);
        cell.hint += hint(*cell.value);
        if (const auto pressure = point->number("p_H_Pa")) cell.hint += ", p_H = " + plain(*pressure / 1e9, 3) + " GPa";
      } else {
        cell.hint += "not known";
      }
      map.cells.push_back(std::move(cell));
    }
  }
  return any ? std::optional(map) : std::nullopt;
}

std::string lawful(const std::string& laws) {
  if (laws == "roelands") return "Roelands, compressible";
  if (laws == "barus") return "Barus, incompressible";
  return laws;
}

/// 1, 2, 5, 10, ... between the extreme values.
std::vector<ContourLevel> decade_levels(const HeatMap& map) {
  double low = 1e300, high = 0;
  for (const Cell& cell : map.cells) {
    if (!cell.value || !(*cell.value > 0)) continue;
    low = std::min(low, *cell.value);
    high = std::max(high, *cell.value);
  }
  std::vector<ContourLevel> levels;
  if (!(low < high)) return levels;
  for (int decade = static_cast<int>(std::floor(std::log10(low))); decade <= std::log10(high); ++decade) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double level = digit * std::pow(10, decade);
      if (level > low && level < high)
        levels.push_back({level, digit == 1 ? Line::solid : Line::dashed, number_markup(level, 3)});
    }
  }
  return levels;
}

void add_films(Page& page, const Atlas& atlas, const std::vector<std::string>& sets) {
  page.heading("Certified film");
  page.begin_figures("maps");
  for (const char* which : {"minimum", "central"}) {
    for (const std::string& laws : sets) {
      auto map = map_of(
          atlas, laws, [&](const View& point) { return point.number(std::string("film_") + which + "_moes"); },
          [](double value) { return plain(value, 3); }, [](double value) { return "H_Moes = " + plain(value, 8); });
      if (!map) continue;
      map->id = std::string("fig-film-") + which + "-" + laws;
      map->title = std::string("Certified ") + which + " film over M and L, " + lawful(laws);
      map->description = "Film in Moes units, flooded, a number a cell, with contour lines.";
      map->heading =
          std::string(which == std::string("minimum") ? "Minimum" : "Central") + " film *H*_{Moes}, " + lawful(laws);
      map->logarithmic = true;
      map->contours = decade_levels(*map);
      page.figure(std::move(*map),
                  "<i>H</i><sub>Moes</sub> = (<i>h</i>/<i>R</i>) <i>U</i><sub>s</sub><sup>\u22121/2</sup>, flooded, by "
                  "<code>reference</code>; contour lines at 1, 2, 5 \u2026.");
    }
  }
  page.end_figures();
}

constexpr double good = 0.05, poor = 0.30;

void add_percent_contours(HeatMap& map) {
  map.colours = Colours::diverging;
  map.limit = 0.5;
  for (const double sign : {-1.0, 1.0}) {
    map.contours.push_back({sign * good, Line::solid, ""});
    map.contours.push_back({sign * poor, Line::dashed, ""});
  }
  map.keys = {{Line::solid, "\u00b15 %"}, {Line::dashed, "\u00b130 %"}};
}

void add_formulas(Page& page, const Atlas& atlas, const std::vector<std::string>& sets) {
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
      "ones it is more than 30\u2009% off. "
      "Formulas are regressions, never a verdict here.");
  Table table;
  table.caption = "Where the formulas hold, of all points below 4 GPa";
  table.columns = {"formula", "film", "laws", "points", "within 5 %", "within 30 %", "largest below", "largest above"};
  page.begin_figures("maps");
  for (const auto& [name, quantity] : formulas) {
    for (const std::string& laws : sets) {
      const auto deviation = [&, &name = name, &quantity = quantity](const View& point) -> std::optional<double> {
        for (const View& formula : point.list("formulas")) {
          if (formula.text("name") == name && formula.text("quantity") == quantity) return formula.number("deviation");
        }
        return std::nullopt;
      };
      auto map = map_of(atlas, laws, deviation, percent, percent_hint);
      if (!map) continue;
      double lowest = 0, highest = 0;
      int points = 0, near = 0, fair = 0;
      for (const Cell& cell : map->cells) {
        if (!cell.value || !std::isfinite(*cell.value) || cell.hatched) continue;
        ++points;
        near += std::abs(*cell.value) <= good ? 1 : 0;
        fair += std::abs(*cell.value) <= poor ? 1 : 0;
        lowest = std::min(lowest, *cell.value);
        highest = std::max(highest, *cell.value);
      }
      table.rows.push_back({words(name),
                            words(quantity),
                            words(lawful(laws)),
                            integer_cell(points),
                            integer_cell(near),
                            integer_cell(fair),
                            {percent(lowest) + " %", "number"},
                            {percent(highest) + " %", "number"}});
      map->id = "fig-formula-" + name + "-" + quantity + "-" + laws;
      map->title = name + " against the certified " + quantity + ", " + lawful(laws);
      map->description = "Deviation in per cent, a number a cell; contour lines at 5 and 30 per cent.";
      map->heading = literal(name) + ", " + literal(quantity) + ", " + lawful(laws);
      add_percent_contours(*map);
      page.figure(std::move(*map), "<b>" + escaped(name) + "</b>: deviation of its " + escaped(quantity) + " [%].");
    }
  }
  page.end_figures();
  page.add(table);
}

void add_inlet(Page& page, const Atlas& atlas, const std::vector<std::string>& sets) {
  bool any = false;
  for (const View& point : atlas.points)
    any = any || point.has("inlet_cost_minimum") || point.has("inlet_cost_central");
  if (!any) return;
  page.heading("What an inlet cut at <i>X</i> = \u22124 costs, in %");
  page.paragraph(
      "From <i>M</i> = 2 on: below, the oil that the film is made of begins to be felt before <i>X</i> = \u22124, and "
      "such an "
      "inlet is not one that only truncates.");
  page.begin_figures("maps");
  for (const char* which : {"minimum", "central"}) {
    for (const std::string& laws : sets) {
      auto map = map_of(
          atlas, laws, [&](const View& point) { return point.number(std::string("inlet_cost_") + which); }, percent,
          percent_hint);
      if (!map) continue;
      map->id = std::string("fig-inlet-") + which + "-" + laws;
      map->title = std::string("Cost of an inlet cut at X = -4: ") + which + " film, " + lawful(laws);
      map->description =
          "Film of the cut contact over that of the flooded one, less 1, in per cent; contour lines at 1, 5 and 30 per "
          "cent.";
      map->heading = std::string(which == std::string("minimum") ? "Minimum" : "Central") +
                     " film, cut over flooded, " + lawful(laws);
      map->colours = Colours::diverging;
      map->limit = 0.5;
      map->contours = {{-0.01, Line::dotted, ""}, {-0.05, Line::solid, ""}, {-0.30, Line::dashed, ""}};
      map->keys = {{Line::dotted, "\u22121 %"}, {Line::solid, "\u22125 %"}, {Line::dashed, "\u221230 %"}};
      page.figure(std::move(*map), "Film with the inlet cut at <i>X</i> = \u22124 over the flooded film, less 1 [%].");
    }
  }
  page.end_figures();
}

void add_fast(Page& page, const Atlas& atlas, const std::vector<std::string>& sets) {
  bool any = false;
  for (const View& point : atlas.points) any = any || point.has("fast");
  if (!any) return;
  struct Shown {
    const char* key;
    const char* heading;
    const char* unit;
    double factor;
    int digits;
  };
  constexpr Shown shown[] = {{"newton_iterations", "Newton iterations", "", 1, 6},
                             {"krylov_iterations", "Krylov iterations", "", 1, 6},
                             {"work_units", "Work units", "", 1, 3},
                             {"wall_s", "Time [ms]", " ms", 1e3, 2},
                             {"nodes", "Intervals on the finest grid", "", 1, 6}};
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
    summary += (summary.empty() ? "" : ", ") + std::to_string(count) + " " + escaped(status);
  page.heading("Iterations and cost of <code>fast</code>" +
               (tolerance.empty() ? std::string() : " at tolerance " + escaped(tolerance)));
  page.paragraph("Of all points: " + summary + ".");
  page.begin_figures("maps");
  for (const Shown& one : shown) {
    for (const std::string& laws : sets) {
      const auto text = [&](double value) { return plain(value, one.digits); };
      auto map = map_of(
          atlas, laws,
          [&](const View& point) {
            const auto value = point["fast"].number(one.key);
            return value ? std::optional(one.factor * *value) : std::nullopt;
          },
          text, [&](double value) { return plain(value, 4) + one.unit; });
      if (!map) continue;
      map->id = std::string("fig-fast-") + one.key + "-" + laws;
      map->title = std::string(one.heading) + " of fast over M and L, " + lawful(laws);
      map->description = std::string(one.heading) + ", a number a cell, with contour lines.";
      map->heading = std::string(one.heading) + ", " + lawful(laws);
      map->logarithmic = true;
      map->contours = decade_levels(*map);
      page.figure(std::move(*map),
                  std::string(one.heading) + " of <code>fast</code>; contour lines at 1, 2, 5 \u2026.");
    }
  }
  for (const char* which : {"minimum", "central"}) {
    for (const std::string& laws : sets) {
      auto map = map_of(
          atlas, laws,
          [&](const View& point) {
            const auto value = point["fast"].number(std::string("deviation_") + which);
            return value ? std::optional(std::max(std::abs(*value), 1e-16)) : std::nullopt;
          },
          [](double value) { return plain(value, 1); },
          [](double value) { return "|fast/certified - 1| = " + plain(value, 3); });
      if (!map) continue;
      map->id = std::string("fig-fast-deviation-") + which + "-" + laws;
      map->title = std::string("Achieved error of fast, ") + which + " film, " + lawful(laws);
      map->description = "Magnitude of the relative difference from the certified film, a number a cell.";
      map->heading = std::string("Achieved error, ") + which + " film, " + lawful(laws);
      map->logarithmic = true;
      page.figure(std::move(*map),
                  std::string("|<code>fast</code>/certified \u2212 1| of the ") + which + " film, flooded.");
    }
  }
  page.end_figures();
}

}  // namespace

void add_maps(Page& page, const View& results) {
  page.section("maps", "Maps over M and L");
  const View maps = results["figures"]["maps"];
  Atlas atlas{.M = maps.numbers("M"), .L = maps.numbers("L"), .points = maps.list("points")};
  for (auto* axis : {&atlas.M, &atlas.L}) {
    std::erase_if(*axis, [](double value) { return !std::isfinite(value); });
    std::sort(axis->begin(), axis->end());
  }
  if (atlas.points.empty() || atlas.M.empty() || atlas.L.empty()) {
    page.absent("Maps over (M, L) are", "ehd verify --output DIR");
    return;
  }
  std::vector<std::string> sets;
  for (const char* laws : {"roelands", "barus", "isoviscous"}) {
    bool own = false;
    for (const View& point : atlas.points) own = own || point.text("laws") == laws;
    // The isoviscous row, L = 0, is part of the other sets where there are any.
    if (own && (std::string(laws) != "isoviscous" || sets.empty())) sets.push_back(laws);
  }
  if (const auto source = maps.text("source"); !source.empty()) page.paragraph("Points: " + escaped(source) + ".");
  add_films(page, atlas, sets);
  add_formulas(page, atlas, sets);
  add_inlet(page, atlas, sets);
  add_fast(page, atlas, sets);
}

}  // namespace ehd::report
