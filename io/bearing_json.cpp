// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bearing_json.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "io/bearing_notes.hpp"
#include "io/contact_json.hpp"
#include "io/json.hpp"
#include "io/result_head.hpp"

namespace ehd {

using bearing::FilmCurve;
using bearing::LinearFit;

namespace {

/// An object of those numbers that are known and finite.
Json numbers(std::initializer_list<std::pair<const char*, std::optional<double>>> entries) {
  Json json = Json::object();
  for (const auto& [key, value] : entries) put(json, key, value);
  return json;
}

Json to_json(const ContactRow& row) {
  return numbers({{"force_N", row.force_N},
                  {"displacement_m", row.displacement_m},
                  {"film_minimum_m", row.film_minimum_m},
                  {"hertz_pressure_Pa", row.hertz_pressure_Pa},
                  {"lambda_ratio", row.lambda_ratio}});
}

Json to_json(const std::vector<RollerRow>& rows) {
  Json json = Json::array();
  for (const RollerRow& row : rows) {
    Json roller = numbers({{"azimuth_deg", row.azimuth_deg}});
    roller["inner"] = to_json(row.inner);
    roller["outer"] = to_json(row.outer);
    json.push_back(std::move(roller));
  }
  return json;
}

/// A contact, and where it is.
Json to_json(const BearingResult& result, const ContactPlace& place) {
  const RollerRow& roller = result.rollers[place.roller];
  const ContactRow& row = roller.at(place.raceway);
  Json json = numbers({{"azimuth_deg", roller.azimuth_deg}});
  json["raceway"] = to_string(place.raceway);
  json.update(to_json(row));
  return json;
}

Json to_json(const BearingErrors& errors) {
  return numbers({{"displacement_m", errors.displacement_m},
                  {"displacement_lateral_m", errors.displacement_lateral_m},
                  {"largest_force_N", errors.largest_force_N},
                  {"any_force_N", errors.any_force_N},
                  {"smallest_film_relative", errors.smallest_film}});
}

Json to_json(const CageTurn& turn) {
  const auto range = [](const CageTurn::Range& one) {
    return numbers({{"mean", one.mean}, {"peak_to_peak", one.peak_to_peak}});
  };
  Json json = Json::object();
  json["positions"] = turn.positions;
  json["displacement_m"] = range(turn.displacement_m);
  json["displacement_lateral_m"] = range(turn.displacement_lateral_m);
  put(json, "largest_force_N", turn.largest_force_N);
  return json;
}

Json to_json(const LinearFit& fit) {
  Json json = numbers({{"K_N_per_m", fit.K_N_per_m},
                       {"dF_N", fit.dF_N},
                       {"residual_N", fit.residual_N},
                       {"misfit", fit.misfit()},
                       {"standard_deviation_N", fit.standard_deviation_N},
                       {"K_standard_deviation_N_per_m", fit.K_deviation_N_per_m},
                       {"dF_standard_deviation_N", fit.dF_deviation_N},
                       {"correlation", fit.correlation}});
  put(json, "load_N", {fit.points.front().force_N, fit.points.back().force_N});
  json["points"] = fit.points.size();
  if (fit.in_use) {
    json["in_use"] = numbers({{"residual_N", fit.in_use->residual_N}, {"misfit", fit.in_use->misfit()}});
    put(json["in_use"], "load_N", {fit.in_use->lightest_N, fit.in_use->heaviest_N});
  }
  json["describes_contacts"] = fit.describes_contacts();
  return json;
}

/// The contacts that the curve goes through; between them it is read from the same splines.
Json points_of(const FilmCurve& curve) {
  std::vector<double> offset, minimum, rolling;
  for (const double force_N : curve.forces_N()) {
    offset.push_back(curve.offset_film(force_N).value);
    minimum.push_back(curve.minimum_film(force_N).value);
    if (const auto per_m = curve.rolling_force_N_per_m(force_N)) rolling.push_back(*per_m);
  }
  Json json = {{"force_N", curve.forces_N()}, {"offset_film_m", offset}, {"film_minimum_m", minimum}};
  if (!rolling.empty()) json["rolling_force_N_per_m"] = rolling;
  return json;
}

Json to_json(const FilmCurve& curve) {
  Json json = Json::object();
  json["points"] = curve.forces_N().size();
  put(json, "load_N", {curve.lightest_N(), curve.heaviest_N()});
  put(json, "interpolation_error", curve.errors().interpolation);
  put(json, "joint_error", curve.errors().joint);
  put(json, "joint_force_error", curve.errors().joint_force);
  put(json, "force_error", std::max(curve.errors().interpolation_force, curve.errors().joint_force));
  put(json, "solver_error", curve.errors().solver_offset_film);
  json["lightest_because"] = curve.errors().lightest_because;
  json["solved"] = points_of(curve);
  return json;
}

/// kappa of slow motion at the contacts that were solved. Errors are absolute.
Json to_json(const bearing::ResponseCurve& curve) {
  std::vector<double> kappa_0, kappa_1, error_0, error_1;
  for (const double force_N : curve.forces_N()) {
    const bearing::Kappa slow = curve.slow(force_N);
    kappa_0.push_back(slow.stiffness);
    kappa_1.push_back(slow.damping);
    error_0.push_back(slow.stiffness_error);
    error_1.push_back(slow.damping_error);
  }
  return {{"datum_m", curve.contact().length_m},
          {"force_N", curve.forces_N()},
          {"kappa_0", kappa_0},
          {"kappa_0_error", error_0},
          {"kappa_1", kappa_1},
          {"kappa_1_error", error_1}};
}

/// Without what is not known of the ring.
Json to_json(const bearing::ContactMotion& contact, bool stiffness, bool damping) {
  Json json = Json::object();
  if (stiffness) put(json, "stiffness_N_per_m", contact.stiffness_N_per_m);
  if (damping) put(json, "damping_N_s_per_m", contact.damping_N_s_per_m);
  return json;
}

Json motion_json(const BearingResult& result, const BearingResult* full) {
  Json json = Json::array();
  for (std::size_t k = 0; k < result.dynamics.size(); ++k) {
    const DynamicRow& row = result.dynamics[k];
    Json one = numbers({{"frequency_Hz", row.frequency_Hz}});
    const bool stiffness = knows_motion(result, full, k), damping = knows_damping(row);
    if (stiffness) one["stiffness_N_per_m"] = row.ring.stiffness_N_per_m;
    if (damping && row.ring.damping_N_s_per_m) one["damping_N_s_per_m"] = *row.ring.damping_N_s_per_m;
    put(one, "error", motion_error(result, full, k));
    put(one, "damping_error", row.ring.damping_error);
    one["rollers"] = Json::array();
    for (const bearing::RollerMotion& roller : row.rollers) {
      Json contacts = numbers({{"azimuth_deg", roller.azimuth_deg}});
      contacts["inner"] = to_json(roller.inner, stiffness, damping);
      contacts["outer"] = to_json(roller.outer, stiffness, damping);
      one["rollers"].push_back(std::move(contacts));
    }
    json.push_back(std::move(one));
  }
  return json;
}

}  // namespace

Json to_json(const BearingResult& result, const BearingResult* full) {
  Json json = result_head("ehd-bearing-1");
  json["case"] = result.case_id;
  json["version"] = result.version;
  json["law"] = to_string(result.law);
  json["status"] = to_string(result.status);
  if (result.oil) json["lubricant"] = to_json(*result.oil);
  if (!result.rollers.empty()) {
    put(json, "displacement_m", result.displacement_m);
    put(json, "displacement_lateral_m", result.displacement_lateral_m);
    const auto put_zone = [&](const char* key, const std::optional<std::pair<double, double>>& zone) {
      if (zone) put(json, key, {zone->first, zone->second});
    };
    put_zone("load_zone_deg", result.load_zone_deg);
    put_zone("geometric_load_zone_deg", result.geometric_load_zone_deg);
    json["loaded_rollers"] = loaded_rollers(result.rollers);
    if (const auto place = largest_pressure_place(result)) json["largest_pressure"] = to_json(result, *place);
    if (const auto place = smallest_film_place(result)) json["smallest_film"] = to_json(result, *place);
    if (const auto& K = result.stiffness_N_per_m;
        knows_stiffness(result, full) && std::isfinite(K[0][0] + K[0][1] + K[1][0] + K[1][1])) {
      json["stiffness_N_per_m"] = K;
      put(json, "stiffness_error", stiffness_error(result, full));
    }
    if (!result.dynamics.empty()) json["dynamics"] = motion_json(result, full);
    if (result.torque) {
      put(json, "torque_N_m", result.torque->torque_N_m);
      put(json, "torque_error", torque_error(result, full));
    }
    if (result.cage) json["cage"] = to_json(*result.cage);
    json["rollers"] = to_json(result.rollers);
    put(json, "balance_error", result.balance_error);
    if (result.errors) json["errors"] = to_json(*result.errors);
  } else {
    json["why"] = result.why;
  }
  if (result.fit) json["fit"] = {{"inner", to_json(result.fit->inner)}, {"outer", to_json(result.fit->outer)}};
  if (result.curve) json["curve"] = {{"inner", to_json(result.curve->inner)}, {"outer", to_json(result.curve->outer)}};
  if (result.response)
    for (const bearing::Raceway raceway : bearing::both_raceways)
      json["curve"][std::string(to_string(raceway))]["response"] = to_json(result.response->at(raceway));
  if (result.datum_m)
    json["datum"] = numbers({{"inner_x0_m", result.datum_m->inner}, {"outer_x0_m", result.datum_m->outer}});
  for (const VariantResult& variant : result.variants) {
    Json one{{"name", variant.name}};
    put(one, "displacement_m", variant.displacement_m);
    put(one, "displacement_lateral_m", variant.displacement_lateral_m);
    one["rollers"] = to_json(variant.rollers);
    put(one, "balance_error", variant.balance_error);
    json["variants"].push_back(std::move(one));
  }
  json["cost"] = {{"wall_s", result.wall_s},
                  {"contact_solves", result.contact_solves},
                  {"contacts_from_memory", result.contact_recalls},
                  {"newton_iterations", result.newton_iterations},
                  {"rollers_balanced", result.rollers_balanced}};
  if (result.responses > 0) json["cost"]["responses"] = result.responses;
  json["plan"] = to_json(result.plan);
  json["notes"] = notes_of(result);
  return json;
}

}  // namespace ehd
