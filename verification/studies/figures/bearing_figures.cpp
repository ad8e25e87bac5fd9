// SPDX-License-Identifier: GPL-3.0-or-later
// The bearing: load over azimuth by each law, force over displacement of each law, and what the paper says of them.
#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "bearing/force_law.hpp"
#include "io/bearing_json.hpp"
#include "io/json.hpp"
#include "verification/studies/error_budget.hpp"
#include "verification/studies/figures/parts.hpp"
#include "verification/studies/paper_statements.hpp"
#include "verification/studies/statement_study.hpp"
#include "workflow/bearing_run.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

constexpr int curve_points = 80;
constexpr double beyond_heaviest = 1.1;  ///< of the largest roller load of any law
constexpr double lightest_share = 1e-3;  ///< the curves begin at this share of it

struct Made {
  Json bearings = Json::array(), laws = Json::array(), statements = Json::array(), study = Json::object();
};

Json law_json(const BearingResult& result) {
  Json whole = to_json(result), json = Json::object();
  for (const char* key : {"law", "status", "why", "displacement_m", "rollers", "fit", "balance_error", "errors"})
    if (whole.contains(key)) json[key] = whole[key];
  return json;
}

double largest_load_N(const std::vector<BearingResult>& results) {
  double largest = 0;
  for (const BearingResult& result : results)
    for (const RollerRow& roller : result.rollers)
      largest = std::max({largest, roller.inner.force_N, roller.outer.force_N});
  return largest;
}

/// Displacement over contact force, geometrically spaced; the film too where the law is a film curve.
Json curve_json(const bearing::ForceLaw& law, double heaviest_N) {
  std::vector<double> displacement, force, film;
  const auto* own = std::get_if<bearing::CurveLaw>(&law);
  for (int i = 0; i < curve_points; ++i) {
    const double share = std::pow(lightest_share, 1 - static_cast<double>(i) / (curve_points - 1));
    const double f = heaviest_N * share;
    if (own && f > own->curve().heaviest_N()) break;  // beyond the solved contacts
    const double delta = bearing::approach(law, f);
    if (!std::isfinite(delta)) continue;
    force.push_back(f);
    displacement.push_back(delta);
    if (own) film.push_back(own->curve().minimum_film(f).value);
  }
  Json json = {{"displacement_m", displacement}, {"force_N", force}};
  if (own) json["film_minimum_m"] = film;
  return json;
}

void make(const std::vector<Case>& cases, Made& made) {
  ContactMemory memory(default_solver().solve);
  std::vector<std::vector<BearingResult>> all;
  for (const Case& one : cases) {
    const auto& body = std::get<BearingCase>(one.body);
    std::vector<bearing::Law> laws = default_laws(body);
    if (body.operation.inner_speed_rpm == body.operation.outer_speed_rpm)  // at rest there is no film
      std::erase_if(laws, [](bearing::Law law) { return needs_film(law); });
    all.push_back(run_bearing(one, {.laws = laws, .explicitly = false, .films = true}, memory));
    Json bearing = Json::object();
    bearing["id"] = one.id;
    bearing["version"] = one.version;
    bearing["title"] = one.title;
    put(bearing, "clearance_m", body.geometry.clearance_m);
    put(bearing, "radial_load_N", body.operation.radial_load_N);
    put(bearing, "speed_rpm",
        std::max(std::abs(body.operation.inner_speed_rpm), std::abs(body.operation.outer_speed_rpm)));
    bearing["laws"] = Json::array();
    const double heaviest = beyond_heaviest * largest_load_N(all.back());
    for (const BearingResult& result : all.back()) {
      bearing["laws"].push_back(law_json(result));
      if (const auto budget = budget_of(one, all.back(), result.law, memory); !budget.empty())
        bearing["laws"].back()["error_budget"] = to_json(budget);
      const auto pair = result.rollers.empty() ? std::nullopt : laws_of(body, result);
      for (const bool inner : {true, false}) {
        if (!pair || !(heaviest > 0)) continue;
        const bearing::ForceLaw& law = inner ? pair->inner : pair->outer;
        Json curve = {{"id", one.id}, {"raceway", inner ? "inner" : "outer"}, {"law", to_string(result.law)}};
        curve.update(curve_json(law, heaviest));
        made.laws.push_back(std::move(curve));
      }
    }
    made.bearings.push_back(std::move(bearing));
  }
  if (cases.size() < 3 || !differ_only_in_clearance(cases)) return;
  if (const auto study = study_statements(cases, memory); !study.empty()) made.study = to_json(study);
  for (const bearing::Law law : film_laws()) {
    std::vector<ClearanceComparison> rows;
    for (std::size_t k = 0; k < cases.size(); ++k) {
      const BearingResult *dry = balance_by(bearing::Law::hertz, all[k]), *film = balance_by(law, all[k]);
      if (!dry || !film) break;
      rows.push_back({std::get<BearingCase>(cases[k].body).geometry.clearance_m, *dry, *film});
    }
    if (rows.size() < cases.size()) continue;  // a balance is missing
    for (const PaperStatement& one : judge_paper_statements(rows)) {
      made.statements.push_back({{"letter", std::string(1, one.letter)},
                                 {"law", to_string(law)},
                                 {"statement", one.statement},
                                 {"holds", one.holds},
                                 {"numbers", one.numbers}});
      if (one.holds_at_top) made.statements.back()["holds_at_psi_0"] = *one.holds_at_top;
    }
  }
}

}  // namespace

FigurePart bearing_part(const std::vector<Case>& cases) {
  FigurePart part{.name = "bearing"};
  auto made = std::make_shared<Made>();
  if (!cases.empty()) part.work.push_back({"bearing", [made, cases] { make(cases, *made); }});
  part.finish = [made](Json& figures) {
    if (!made->bearings.empty()) figures["bearing"] = std::move(made->bearings);
    if (!made->statements.empty()) figures["statements"] = std::move(made->statements);
    if (!made->study.empty()) figures["statement_study"] = std::move(made->study);
    if (!made->laws.empty()) figures["force_law"] = std::move(made->laws);
  };
  return part;
}

}  // namespace ehd::verification
