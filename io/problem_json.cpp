// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/problem_json.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <variant>

#include "contact/nondimensional.hpp"
#include "contact/rheology.hpp"
#include "io/contact_json.hpp"
#include "io/result_head.hpp"

namespace ehd {

namespace {

constexpr const char* problem_schema = "ehd-problem-1";

template <class Law>
Json law_json(const Law& law) {
  Json json{{"law", name(law)}, {"formula", formula(law)}};
  for (const LawParameter& one : parameters(law)) put(json, std::string(one.name), one.value);
  return json;
}

Json groups_json(const Nondimensional& stated) {
  const Groups& groups = stated.problem.groups;
  Json json = Json::object();
  put(json, "M", groups.M);
  put(json, "L", groups.L);
  put(json, "lambda", groups.lambda);
  put(json, "alpha_p_H", groups.alpha_p_H);
  if (!stated.scales) return json;
  put(json, "hertz_pressure_Pa", stated.scales->hertz_pressure_Pa);
  put(json, "half_width_m", stated.scales->half_width_m);
  put(json, "film_m_per_hertz", stated.scales->film_m_per_hertz_film());
  return json;
}

Json conditions_json(const Conditions& conditions) {
  Json json = Json::object();
  put(json, "load_N_per_m", conditions.load_N_per_m);
  put(json, "reduced_radius_m", conditions.reduced_radius_m);
  put(json, "reduced_modulus_Pa", conditions.reduced_modulus_Pa);
  put(json, "speed_sum_m_per_s", conditions.speed_sum_m_per_s);
  put(json, "viscosity_Pa_s", conditions.viscosity_Pa_s);
  return json;
}

/// A dry contact has neither a film nor an inlet and an exit: the bodies touch where there is pressure.
Json equations_json(bool dry) {
  const char* const film = "H = H_0 + X^2/2 - (1/pi) Int P(S) ln|X - S| dS";
  const char* const load = "Int P dX = pi/2";
  if (dry) return {film, load, "P >= 0, H >= 0 and P H = 0"};
  return {"d/dX(rho H^3/(eta lambda) dP/dX) = d(rho H)/dX from the inlet to the exit", film, load,
          "P = 0 at the inlet; P = dP/dX = 0 at the exit, whose place is unknown; P >= 0"};
}

}  // namespace

Json problem_json(const Case& contact_case) {
  const auto& contact = std::get<ContactCase>(contact_case.body);
  Json json = result_head(problem_schema);
  json["case"] = contact_case.id;
  json["version"] = contact_case.version;
  json["title"] = contact_case.title;
  json["units"] = "X = x/b, P = p/p_H, H = h R/b^2";
  json["equations"] = equations_json(contact.dry());
  if (const auto* conditions = std::get_if<Conditions>(&contact.statement))
    json["conditions"] = conditions_json(*conditions);
  if (contact.dry()) return json;
  const Nondimensional stated = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet);
  json["groups"] = groups_json(stated);
  json["viscosity"] = law_json(stated.problem.viscosity);
  json["density"] = law_json(stated.problem.density);
  if (const auto* cut = std::get_if<TruncatedAt>(&*contact.inlet)) {
    put(json, "inlet", cut->x);
  } else {
    json["inlet"] = "flooded";
  }
  return json;
}

Json bearing_inputs_json(const BearingCase& body) {
  Json json = Json::object();
  const bearing::Geometry& geometry = body.geometry;
  Json& of_bearing = json["bearing"];
  of_bearing["rollers"] = geometry.rollers;
  put(of_bearing, "pitch_diameter_m", geometry.pitch_diameter_m);
  put(of_bearing, "roller_diameter_m", geometry.roller_diameter_m);
  put(of_bearing, "length_m", geometry.length_m);
  put(of_bearing, "clearance_m", geometry.clearance_m);
  put(of_bearing, "density_kg_per_m3", geometry.density_kg_per_m3);
  put(of_bearing, "first_azimuth_deg", geometry.first_azimuth_deg);
  put(of_bearing, "ring_thickness_m", body.ring_thickness_m);
  put(of_bearing, "roughness_m", body.roughness_m);
  put(json["operation"], "inner_speed_rpm", body.operation.inner_speed_rpm);
  put(json["operation"], "outer_speed_rpm", body.operation.outer_speed_rpm);
  put(json["operation"], "radial_load_N", body.operation.radial_load_N);
  put(json["material"], "modulus_Pa", body.modulus_Pa);
  put(json["material"], "poisson", body.poisson);
  if (!body.lubricant) return json;  // the rest is of contacts with films
  json["lubricant"] = to_json(body.lubricant->lubricant);
  put(json["lubricant"], "viscosity_Pa_s", body.lubricant->viscosity_Pa_s);
  if (body.lubricant->oil) json["oil"] = to_json(*body.lubricant->oil);
  json["datum"]["law"] = std::visit([](const auto& datum) { return datum.name; }, body.datum);
  if (const auto* palmgren = std::get_if<PalmgrenDatum>(&body.datum)) put(json["datum"], "load_N", palmgren->load_N);
  if (const auto* length = std::get_if<LengthDatum>(&body.datum)) put(json["datum"], "x0_m", length->x0_m);
  if (body.fit.load_N) json["fit"]["load_N"] = {body.fit.load_N->first, body.fit.load_N->second};
  json["fit"]["points"] = body.fit.points;
  return json;
}

}  // namespace ehd
