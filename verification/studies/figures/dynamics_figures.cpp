// SPDX-License-Identifier: GPL-3.0-or-later
// The first of the bearings in small motion: its contacts around it, and the ring over the frequency.
#include <memory>
#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "verification/studies/figures/parts.hpp"
#include "workflow/bearing_run.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

/// From the slow motion of a rotor to a few thousand Hz, where the films of NA4908 begin to be fast.
const std::vector<double> shown_frequencies_Hz = {10, 30, 100, 300, 1000, 2000, 3000, 5000, 10000};

Json contacts_in_motion_json(const DynamicRow& row) {
  Json json = Json::object();
  const auto add = [&](const char* prefix, const bearing::ContactMotion& contact) {
    json[std::string(prefix) + "_stiffness_N_per_m"].push_back(contact.stiffness_N_per_m);
    json[std::string(prefix) + "_damping_N_s_per_m"].push_back(contact.damping_N_s_per_m.value_or(0));
  };
  for (const bearing::RollerMotion& roller : row.rollers) {
    if (roller.azimuth_deg < 0) continue;
    json["azimuth_deg"].push_back(roller.azimuth_deg);
    add("inner", roller.inner);
    add("outer", roller.outer);
  }
  return json;
}

Json ring_json(const std::vector<DynamicRow>& rows) {
  Json json = Json::object();
  for (const DynamicRow& row : rows) {
    if (!row.ring.damping_N_s_per_m) continue;
    json["frequency_Hz"].push_back(row.frequency_Hz);
    json["stiffness_error"].push_back(row.ring.error);
    if (row.ring.damping_error) json["damping_error"].push_back(*row.ring.damping_error);
    for (const auto& [prefix, i] : {std::pair{std::string("along"), 0u}, std::pair{std::string("across"), 1u}}) {
      json[prefix + "_stiffness_N_per_m"].push_back(row.ring.stiffness_N_per_m[i][i]);
      json[prefix + "_damping_N_s_per_m"].push_back((*row.ring.damping_N_s_per_m)[i][i]);
    }
  }
  return json;
}

void make_dynamics(const Case& one, Json& made) {
  ContactMemory memory(default_solver().solve);
  const auto results = run_bearing(one, {.laws = {bearing::Law::ehd}, .frequencies_Hz = shown_frequencies_Hz}, memory);
  if (results.empty() || results[0].dynamics.empty()) return;
  made.push_back({{"id", one.id},
                  {"contacts", contacts_in_motion_json(results[0].dynamics.front())},
                  {"ring", ring_json(results[0].dynamics)}});
}

}  // namespace

FigurePart dynamics_part(const std::vector<Case>& cases, bool quick) {
  FigurePart part;
  auto made = std::make_shared<Json>(Json::array());
  if (!cases.empty() && !quick)
    part.work.push_back({"bearing in motion", [made, one = cases.front()] { make_dynamics(one, *made); }});
  part.finish = [made](Json& figures) {
    if (!made->empty()) figures["dynamics"] = std::move(*made);
  };
  return part;
}

}  // namespace ehd::verification
