// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/atlas/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/contact_json.hpp"
#include "io/json.hpp"
#include "verification/atlas/columns.hpp"
#include "verification/studies/bit_digest.hpp"
#include "workflow/contact_run.hpp"

namespace ehd::verification {

namespace {

constexpr int record_schema = 1;
constexpr double safety = 3, steepness = 30;  ///< of the place of the spike
constexpr double looser = 1000;               ///< from one tolerance to the next

double relative_error(const AtlasRecord& record, const std::string& name) {
  const auto at = record.readings.find(name);
  if (at == record.readings.end() || at->second.value == 0) return std::numeric_limits<double>::infinity();
  const double error = at->second.error / std::abs(at->second.value);
  return error >= 0 ? error : std::numeric_limits<double>::infinity();  // NaN too
}

double film_error(const AtlasRecord& record) {
  return std::max(relative_error(record, "H_min"), relative_error(record, "H_cen"));
}

/// The solver states no error of the spike's place. The error is estimated as `safety` times the difference of the two
/// discretisations, plus `steepness` times the relative error of the height times the distance from the exit.
std::optional<AtlasReading> place_of_spike(const Solution& solution) {
  const auto at = solution.observables.find(Quantity::pressure_spike);
  const auto exit = solution.observables.find(Quantity::pressure_exit);
  const auto& grids = solution.record.grids;
  if (at == solution.observables.end() || exit == solution.observables.end() || !at->second.place ||
      !at->second.error || grids.size() < 2)
    return std::nullopt;
  const double place = *at->second.place;
  double farthest = 0;
  for (const GridRecord& grid : grids) {
    const auto seen = grid.observed.find(Quantity::pressure_spike);
    if (seen == grid.observed.end() || !seen->second.place) return std::nullopt;
    farthest = std::max(farthest, std::abs(*seen->second.place - place));
  }
  return AtlasReading{place, safety * farthest + steepness * *at->second.error * std::abs(exit->second.value - place)};
}

std::map<std::string, AtlasReading> readings_of(const Solution& solution) {
  std::map<std::string, AtlasReading> readings;
  for (const AtlasColumn& column : columns_of_values) {
    if (!column.quantity) continue;
    const auto at = solution.observables.find(*column.quantity);
    if (at == solution.observables.end() || !at->second.error) continue;
    const Reading& reading = at->second;
    const double error = *reading.error * (column.absolute ? 1 : std::abs(reading.value));
    if (std::isfinite(reading.value) && std::isfinite(error))
      readings[std::string(column.name)] = {reading.value, error};
  }
  if (const auto place = place_of_spike(solution)) readings["X_spike"] = *place;
  return readings;
}

}  // namespace

bool AtlasRecord::has_digits() const { return film_error(*this) <= atlas_worst_error; }

std::string json_of(const AtlasRecord& record) {
  Json json;
  json["schema"] = record_schema;
  json["id"] = record.id;
  json["solver"] = record.solver;
  json["tolerance"] = record.tolerance;
  json["time_limit_s"] = record.time_limit_s;
  json["status"] = to_string(record.status);
  json["reason"] = record.reason;
  json["nodes"] = record.nodes;
  json["wall_s"] = record.wall_s;
  Json readings = Json::object();
  for (const auto& [name, reading] : record.readings)
    readings[name] = {{"value", reading.value}, {"absolute_error", reading.error}};
  json["readings"] = readings;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<AtlasRecord> record_from(const std::string& text) {
  try {
    const Json json = json_from(text);
    if (json.at("schema") != record_schema) return std::nullopt;
    AtlasRecord record;
    record.id = json.at("id").get<std::string>();
    record.solver = json.at("solver").get<std::string>();
    record.tolerance = json.at("tolerance").get<double>();
    record.time_limit_s = json.at("time_limit_s").get<double>();
    const auto status = stop_reason_from(json.at("status").get<std::string>());
    if (!status) return std::nullopt;
    record.status = *status;
    record.reason = json.at("reason").get<std::string>();
    record.nodes = json.at("nodes").get<long>();
    record.wall_s = json.at("wall_s").get<double>();
    for (const auto& [name, reading] : json.at("readings").items())
      record.readings[name] = {reading.at("value").get<double>(), reading.at("absolute_error").get<double>()};
    return record;
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const JsonError&) {
    return std::nullopt;
  }
}

AtlasRecord solve_point(const AtlasPoint& point, const RegisteredSolver& solver, double tolerance,
                        double time_limit_s) {
  AtlasRecord best{.id = point.id(),
                   .solver = {},
                   .tolerance = tolerance,
                   .time_limit_s = time_limit_s,
                   .reason = {},
                   .readings = {}};
  bool first = true;
  for (double asked = tolerance;;) {
    const Solution solution =
        run_contact(point.contact(), solver, {.tolerance = asked, .time_limit_s = time_limit_s}).solution;
    best.wall_s += solution.record.cost.wall_s;
    if (first) {
      best.status = solution.record.status;
      best.reason = solution.record.reason;
    }
    AtlasRecord tried = best;
    tried.readings = readings_of(solution);
    tried.nodes = solution.record.cost.nodes;
    if (first || film_error(tried) < film_error(best)) best = std::move(tried);
    if (best.has_digits() || asked >= atlas_worst_error) break;
    // A solve that ran out of time would do so again a little looser.
    const bool out_of_time = solution.record.status == StopReason::limit_reached;
    asked = out_of_time ? atlas_worst_error : std::min(asked * looser, atlas_worst_error);
    first = false;
  }
  const bool failed = best.status == StopReason::diverged || best.status == StopReason::under_resolved;
  if (!first && failed && best.has_digits()) best.status = StopReason::tolerance_not_met;
  return best;
}

std::string atlas_solver_version(const RegisteredSolver& solver) {
  BitDigest digest;
  const AtlasPoint probes[] = {{AtlasLaws::isoviscous, 0.7, 0, Flooded{}},
                               {AtlasLaws::barus, 7, 3, TruncatedAt{usual_cut}},
                               {AtlasLaws::roelands, 15, 7, Flooded{}}};
  for (const AtlasPoint& probe : probes) {
    const Solution solution = run_contact(probe.contact(), solver, {.tolerance = 1e-6}).solution;
    digest.add(static_cast<std::uint64_t>(solution.record.status));
    digest.add(static_cast<std::uint64_t>(solution.record.cost.nodes));
    for (const auto& [quantity, reading] : solution.observables) {
      digest.add(static_cast<std::uint64_t>(quantity));
      digest.add(reading.value);
      digest.add(reading.error.value_or(0));
    }
  }
  return fmt::format("{} {}", solver.name, digest.text());
}

}  // namespace ehd::verification
