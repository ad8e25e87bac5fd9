// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/contact_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "contact/enum_words.hpp"
#include "contact/oil_laws.hpp"
#include "contact/stated_error.hpp"
#include "io/json.hpp"
#include "io/result_head.hpp"
#include "workflow/film_table_run.hpp"
#include "workflow/shown_pressure.hpp"

namespace ehd {

namespace {

constexpr std::size_t members_of_reading = 7, members_of_cost = 13, readings_of_field = 6;  // at most; for object_of

/// The key of a quantity in SI.
const char* key_in_SI(SIScale scale) {
  switch (scale) {
    case SIScale::pressure: return "Pa";
    case SIScale::force: return "N_per_m";
    case SIScale::none:
    case SIScale::film:
    case SIScale::length: return "m";
  }
  return "m";
}

bool has_place(const QuantityRow& row) {
  return row.kind == QuantityKind::film || row.kind == QuantityKind::offset || row.kind == QuantityKind::pressure_peak;
}

Json budget_json(const ErrorBudget& budget) {
  Json json = Json::object();
  put(json, "discretisation", budget.discretisation);
  put(json, "iteration", budget.iteration);
  put(json, "truncation", budget.truncation);
  return json;
}

Json reading_json(const ContactRun& run, const QuantityRow& row, const Reading& reading) {
  if (row.json_value.empty()) return reading.value;
  Json json = object_of(members_of_reading);
  put(json, std::string(row.json_value), reading.value);
  const auto put_scaled = [&](const char* key, std::optional<double> unit) {
    if (unit) put(json, key, reading.value * *unit);
  };
  if (row.in_moes_units) put_scaled("moes", run.moes_per_hertz_film());
  put_scaled(key_in_SI(row.SI), run.SI_per_hertz(row.SI));
  if (has_place(row)) {
    put(json, "x", reading.place);
    const auto b_m = run.SI_per_hertz(SIScale::length);
    if (reading.place && b_m) put(json, "x_m", *reading.place * *b_m);
  }
  put(json, "error", reading.error);
  const bool has_parts = run.solver != table_solver;  // a table knows the whole error alone
  if (row.budget && reading.error && has_parts) json["errors"] = budget_json(run.solution.record.*row.budget);
  return json;
}

/// json["film"]["minimum"] for the entry "film.minimum".
Json& entry_at(Json& json, std::string_view entry) {
  const auto dot = entry.find('.');
  Json& level = json[std::string(entry.substr(0, dot))];
  if (dot == std::string_view::npos) return level;
  if (level.is_null()) level = object_of(readings_of_field);
  return entry_at(level, entry.substr(dot + 1));
}

/// "exit_x_error" for "pressure.exit_x" and "error".
std::string name_beside(const QuantityRow& row, const char* key) {
  return fmt::format("{}_{}", row.json_entry.substr(row.json_entry.rfind('.') + 1), key);
}

void put_observables(Json& json, const ContactRun& run) {
  for (const auto& [quantity, reading] : run.solution.observables) {
    if (!std::isfinite(reading.value)) continue;
    const QuantityRow& row = row_of(quantity);
    entry_at(json, row.json_entry) = reading_json(run, row, reading);
    if (!row.json_value.empty() || is_self_check(quantity)) continue;
    // A number has no room for its error and for its value in SI.
    Json& level = entry_at(json, row.json_entry.substr(0, row.json_entry.rfind('.')));
    put(level, name_beside(row, "error"), reading.error);
    if (const auto unit = run.SI_per_hertz(row.SI))
      put(level, name_beside(row, key_in_SI(row.SI)), reading.value * *unit);
  }
}

Json cost_json(const Cost& cost) {
  Json json = object_of(members_of_cost);
  put(json, "wall_s", cost.wall_s);
  put(json, "planning_s", cost.planning_s);
  put(json, "total_s", cost.wall_s + cost.planning_s);
  const bool accepted = cost.nodes > 0;  // a work unit is a product on the finest accepted grid
  if (accepted) put(json, "work_units", cost.work_units);
  json["convolutions"] = cost.convolutions;
  json["newton_iterations"] = cost.newton_iterations;
  json["krylov_iterations"] = cost.krylov_iterations;
  if (accepted) {
    json["nodes"] = cost.nodes;
    json["levels"] = cost.levels;
  }
  json["viscosity_points"] = cost.viscosity_points;
  json["density_points"] = cost.density_points;
  json["fft_plans"] = cost.fft_plans;
  for (const auto& [stage, seconds] : cost.stage_s) put(json["stage_s"], stage, seconds);
  return json;
}

/// What is known of the fields themselves, which --profile writes. Films above may be extrapolated; they are then
/// better known.
Json fields_json(const ContactRun& run) {
  Json json = Json::object();
  put(json, "film_error", field_error(run.solution));
  put(json, "pressure_error", pressure_error(run.solution));
  json["pressure_resolved"] = pressure_known(run);
  return json;
}

}  // namespace

std::optional<StopReason> stop_reason_from(std::string_view text) { return word_from<StopReason>(text); }

Json to_json(const Plan& plan) {
  Json json = object_of(2);
  json["run"] = plan.run;
  Json& skipped = json["skipped"] = Json::array();
  for (const auto& stage : plan.skipped) skipped.push_back({{"stage", stage.stage}, {"why", stage.why}});
  return json;
}

Json groups_json(const std::optional<Groups>& known, const std::optional<Scales>& scales) {
  Json groups = Json::object();
  if (known) {
    put(groups, "M", known->M);
    put(groups, "L", known->L);
    put(groups, "lambda", known->lambda);
    put(groups, "alpha_p_H", known->alpha_p_H);
  }
  if (!scales) return groups;
  put(groups, "hertz_pressure_Pa", scales->hertz_pressure_Pa);
  put(groups, "half_width_m", scales->half_width_m);
  if (!scales->dowson) return groups;
  put(groups, "W", scales->dowson->W);
  put(groups, "U_mean", scales->dowson->U_mean);
  if (scales->dowson->G > 0) put(groups, "G", scales->dowson->G);
  return groups;
}

Json to_json(const GradedOil& oil) {
  Json json = Json::object();
  put(json, "iso_vg", oil.iso_vg);
  put(json, "viscosity_40C_mm2_per_s", oil.viscosity_40C_mm2_per_s);
  put(json, "viscosity_100C_mm2_per_s", oil.viscosity_100C_mm2_per_s);
  put(json, "viscosity_index", oil.viscosity_index);
  put(json, "temperature_C", oil.temperature_C);
  put(json, "density_15C_kg_per_m3", oil.density_15C_kg_per_m3);
  put(json, "viscosity_mm2_per_s", oil.viscosity_mm2_per_s);
  put(json, "density_kg_per_m3", oil.density_kg_per_m3);
  put(json, "viscosity_Pa_s", oil.viscosity_Pa_s);
  put(json, "estimated_alpha_per_Pa", oil.estimated_alpha_per_Pa);
  return json;
}

Json to_json(const Lubricant& lubricant) {
  const LawKeys keys = row_of(lubricant.viscosity).keys;
  Json json = Json::object();
  json["viscosity"] = to_string(lubricant.viscosity);
  json["density"] = to_string(lubricant.density);
  put(json, "alpha_per_Pa", lubricant.alpha_per_Pa);
  if (keys.z) put(json, "z", lubricant.z);
  if (keys.p0_Pa) put(json, "p0_Pa", lubricant.p0_Pa);
  return json;
}

std::optional<Json> observable_json(const ContactRun& run, std::string_view entry) {
  for (const auto& [quantity, reading] : run.solution.observables)
    if (row_of(quantity).json_entry == entry && std::isfinite(reading.value))
      return reading_json(run, row_of(quantity), reading);
  return std::nullopt;
}

Json to_json(const ContactRun& run) {
  Json json = result_head("ehd-solve-1");
  if (!run.case_id.empty()) json["case"] = run.case_id;
  if (run.version > 0) json["version"] = run.version;
  if (!run.solver.empty()) json["solver"] = run.solver;
  json["status"] = to_string(run.status());
  if (!run.solution.record.reason.empty()) json["reason"] = run.solution.record.reason;
  if (run.oil) json["lubricant"] = to_json(*run.oil);
  json["groups"] = groups_json(run.groups, run.scales);
  put_observables(json, run);
  if (run.status() != StopReason::diverged && run.solution.fields.X.size() > 0) json["fields"] = fields_json(run);
  json["cost"] = cost_json(run.solution.record.cost);
  json["plan"] = to_json(run.plan);
  json["notes"] = run.notes;
  return json;
}

}  // namespace ehd
