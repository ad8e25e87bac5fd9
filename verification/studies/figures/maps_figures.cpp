// SPDX-License-Identifier: GPL-3.0-or-later
// Maps over M and L: the atlas's certified films, the formulas, the cost of a cut inlet, and the default solver at
// 1e-4.
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>

#include "contact/nondimensional.hpp"
#include "io/json.hpp"
#include "verification/studies/figures/parts.hpp"
#include "verification/studies/film_maps.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

constexpr double map_tolerance = 1e-4;
constexpr double time_limit_s = 20;

Json fast_json(const MapPoint& point) {
  const ContactCase contact = point.at.contact();
  Problem problem = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet).problem;
  problem.wanted = {Quantity::film_minimum, Quantity::film_central};
  const Solution solution = default_solver().solve(problem, {.tolerance = map_tolerance, .time_limit_s = time_limit_s});
  const Cost& cost = solution.record.cost;
  Json json = {{"status", to_string(solution.record.status)},
               {"tolerance", map_tolerance},
               {"newton_iterations", cost.newton_iterations},
               {"krylov_iterations", cost.krylov_iterations}};
  if (cost.nodes > 0) {
    put(json, "work_units", cost.work_units);
    json["nodes"] = cost.nodes;
  }
  put(json, "wall_s", cost.wall_s);
  const auto deviation = [&](const char* key, Quantity quantity, const std::optional<MapValue>& certified) {
    const auto at = solution.observables.find(quantity);
    if (!certified || at == solution.observables.end()) return;
    put(json, key, at->second.value * moes_film_per_hertz_film(point.at.M) / certified->value - 1);
    put(json, std::string(key) + "_stated", at->second.error);
  };
  deviation("deviation_minimum", Quantity::film_minimum, point.minimum);
  deviation("deviation_central", Quantity::film_central, point.central);
  return json;
}

Json point_json(const MapPoint& point) {
  Json json = Json::object();
  json["laws"] = to_string(point.at.laws);
  put(json, "M", point.at.M);
  put(json, "L", point.at.L);
  json["numerical_test"] = point.at.numerical_test();
  if (const double pressure = point.at.hertz_pressure_Pa(); pressure > 0) put(json, "p_H_Pa", pressure);
  const auto film = [&](const std::string& key, const std::optional<MapValue>& value) {
    if (!value) return;
    put(json, key + "_moes", value->value);
    put(json, key + "_error", value->error);
  };
  film("film_minimum", point.minimum);
  film("film_central", point.central);
  film("film_couette", point.couette);
  if (point.minimum_cost) put(json, "inlet_cost_minimum", point.minimum_cost->value);
  if (point.central_cost) put(json, "inlet_cost_central", point.central_cost->value);
  json["formulas"] = Json::array();
  for (const MapFormula& formula : point.formulas)
    json["formulas"].push_back({{"name", formula.name},
                                {"quantity", to_string(formula.of)},
                                {"moes", formula.moes},
                                {"deviation", formula.deviation}});
  return json;
}

/// A few points of one law set, from light to heavy.
bool in_quick_run(const AtlasPoint& point) {
  const bool load = point.M == 0.1 || point.M == 1 || point.M == 10 || point.M == 100 || point.M == 1000;
  return point.laws == AtlasLaws::roelands && load && (point.L == 5 || point.L == 15);
}

}  // namespace

FigurePart map_part(const std::filesystem::path& folder, bool quick) {
  FigurePart part{.name = "maps"};
  std::error_code missing;
  if (!std::filesystem::exists(folder / "atlas.csv", missing)) return part;
  struct Maps {
    FilmMaps films;
    std::vector<Json> fast;
  };
  auto maps = std::make_shared<Maps>(Maps{film_maps(folder), {}});
  maps->fast.resize(maps->films.points.size());
  // The atlas goes from light to heavy loads; the heavy ones take longer.
  for (std::size_t i = maps->films.points.size(); i-- > 0;) {
    const AtlasPoint& at = maps->films.points[i].at;
    if (quick && !in_quick_run(at)) continue;
    part.work.push_back({"maps: " + at.id(), [maps, i] { maps->fast[i] = fast_json(maps->films.points[i]); }});
  }
  part.finish = [maps](Json& figures) {
    Json json = {{"M", maps->films.M}, {"L", maps->films.L}, {"source", maps->films.source}};
    json["points"] = Json::array();
    for (std::size_t i = 0; i < maps->films.points.size(); ++i) {
      Json point = point_json(maps->films.points[i]);
      if (!maps->fast[i].is_null()) point["fast"] = std::move(maps->fast[i]);
      json["points"].push_back(std::move(point));
    }
    figures["maps"] = std::move(json);
  };
  return part;
}

}  // namespace ehd::verification
