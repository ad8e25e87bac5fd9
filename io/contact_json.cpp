// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/contact_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/json.hpp"

namespace ehd {

namespace {

std::optional<double> times(std::optional<double> a, std::optional<double> b) {
  if (!a || !b) return std::nullopt;
  return *a * *b;
}

const Reading* find(const ContactRun& run, Quantity quantity) {
  const auto at = run.solution.observables.find(quantity);
  return at == run.solution.observables.end() ? nullptr : &at->second;
}

void put_film(Json& film, const std::string& key, const ContactRun& run, Quantity quantity) {
  const Reading* reading = find(run, quantity);
  if (!reading || !std::isfinite(reading->value)) return;
  Json entry;
  put(entry, "hertz", reading->value);
  if (quantity != Quantity::film_offset) put(entry, "moes", times(reading->value, run.moes_per_hertz_film()));
  if (quantity != Quantity::film_offset) put(entry, "m", times(reading->value, run.m_per_hertz_film()));
  put(entry, "x", reading->place);
  put(entry, "error", reading->error);
  // Where the relative error of the films that a tolerance speaks of comes from.
  const SolveRecord& record = run.solution.record;
  const ErrorBudget* const budget = quantity == Quantity::film_minimum   ? &record.film_minimum
                                    : quantity == Quantity::film_central ? &record.film_central
                                                                         : nullptr;
  if (budget && reading->error) {
    put(entry["errors"], "discretisation", budget->discretisation);
    put(entry["errors"], "iteration", budget->iteration);
    put(entry["errors"], "truncation", budget->truncation);
  }
  film[key] = entry;
}

void put_pressure(Json& pressure, const std::string& key, const ContactRun& run, Quantity quantity) {
  const Reading* reading = find(run, quantity);
  if (!reading || !std::isfinite(reading->value)) return;
  Json entry;
  put(entry, "hertz", reading->value);
  if (run.scales) put(entry, "Pa", reading->value * run.scales->hertz_pressure_Pa);
  put(entry, "x", reading->place);
  put(entry, "error", reading->error);
  pressure[key] = entry;
}

Json groups_json(const ContactRun& run) {
  Json groups = Json::object();
  if (run.groups) {
    put(groups, "M", run.groups->M);
    put(groups, "L", run.groups->L);
    put(groups, "lambda", run.groups->lambda);
    put(groups, "alpha_p_H", run.groups->alpha_p_H);
  }
  if (run.scales) {
    put(groups, "hertz_pressure_Pa", run.scales->hertz_pressure_Pa);
    put(groups, "half_width_m", run.scales->half_width_m);
    if (run.scales->dowson) {
      put(groups, "W", run.scales->dowson->W);
      put(groups, "U_mean", run.scales->dowson->U_mean);
      put(groups, "G", run.known_G());
    }
  }
  return groups;
}

Json cost_json(const Cost& cost) {
  Json json;
  put(json, "wall_s", cost.wall_s);
  put(json, "planning_s", cost.planning_s);
  const bool accepted = cost.nodes > 0;  // a work unit is a product on the finest grid accepted
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

}  // namespace

Json to_json(const Plan& plan) {
  Json json;
  json["run"] = plan.run;
  json["skipped"] = Json::array();
  for (const auto& stage : plan.skipped) json["skipped"].push_back({{"stage", stage.stage}, {"why", stage.why}});
  return json;
}

Json to_json(const ContactRun& run) {
  Json json;
  if (!run.case_id.empty()) json["case"] = run.case_id;
  if (run.version > 0) json["version"] = run.version;
  if (!run.solver.empty()) json["solver"] = run.solver;
  json["status"] = to_string(run.status());
  if (!run.solution.record.reason.empty()) json["reason"] = run.solution.record.reason;
  json["groups"] = groups_json(run);

  Json film = Json::object();
  put_film(film, "minimum", run, Quantity::film_minimum);
  put_film(film, "central", run, Quantity::film_central);
  put_film(film, "couette", run, Quantity::film_couette);
  put_film(film, "offset", run, Quantity::film_offset);
  if (!film.empty()) json["film"] = film;

  Json pressure = Json::object();
  put_pressure(pressure, "maximum", run, Quantity::pressure_maximum);
  put_pressure(pressure, "spike", run, Quantity::pressure_spike);
  if (const Reading* exit = find(run, Quantity::pressure_exit)) put(pressure, "exit_x", exit->value);
  if (!pressure.empty()) json["pressure"] = pressure;

  if (const Reading* approach = find(run, Quantity::approach)) {
    Json entry = Json::object();
    put(entry, "hertz", approach->value);
    put(entry, "m", times(approach->value, run.m_per_hertz_film()));
    if (!entry.empty()) json["approach"] = entry;
  }
  if (const Reading* force = find(run, Quantity::rolling_force)) {
    Json entry = Json::object();
    put(entry, "dimensionless", force->value);
    if (!entry.empty()) json["rolling_force"] = entry;
  }
  if (const Reading* load = find(run, Quantity::load_error)) put(json, "load_error", load->value);
  if (const Reading* flux = find(run, Quantity::flux_variation)) put(json, "flux_variation", flux->value);
  json["cost"] = cost_json(run.solution.record.cost);
  json["plan"] = to_json(run.plan);
  json["notes"] = run.notes;
  return json;
}

}  // namespace ehd
