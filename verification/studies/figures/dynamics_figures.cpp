// SPDX-License-Identifier: GPL-3.0-or-later
// The first of the bearings in small motion: its contacts around it, and the ring over frequency, clearance and speed.
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "io/json.hpp"
#include "verification/studies/figures/parts.hpp"
#include "workflow/bearing_run.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

/// From the slow motion of a rotor to a few thousand Hz, where the films of NA4908 begin to be fast.
const std::vector<double> shown_frequencies_Hz = {10, 30, 100, 300, 1000, 2000, 3000, 5000, 10000};
/// Clearance and speed are changed at this frequency, that of a rotor at 6000 rpm; clearances up to the largest
/// printed.
constexpr double frequency_of_changes_Hz = 100;
const std::vector<double> shown_clearances_um = {0, 2.5, 5, 10};
const std::vector<double> shown_parts_of_speed = {0.1, 0.2, 0.5, 1, 2};

Json contacts_in_motion_json(const DynamicRow& row) {
  Json json = Json::object();
  const auto add = [&](const char* prefix, const bearing::ContactMotion& contact) {
    json[std::string(prefix) + "_stiffness_N_per_m"].push_back(contact.stiffness_N_per_m);
    json[std::string(prefix) + "_damping_N_s_per_m"].push_back(*contact.damping_N_s_per_m);
  };
  for (const bearing::RollerMotion& roller : row.rollers) {
    if (roller.azimuth_deg < 0 || !roller.inner.damping_N_s_per_m || !roller.outer.damping_N_s_per_m) continue;
    json["azimuth_deg"].push_back(roller.azimuth_deg);
    add("inner", roller.inner);
    add("outer", roller.outer);
  }
  return json;
}

/// The ring over what `key` names; results without damping are left out.
class RingSeries {
 public:
  explicit RingSeries(std::string key) : key_(std::move(key)) {}
  void add(double at, const bearing::RingMotion& ring) {
    if (!ring.damping_N_s_per_m) return;
    json_[key_].push_back(at);
    json_["stiffness_error"].push_back(ring.error);
    if (ring.damping_error) json_["damping_error"].push_back(*ring.damping_error);
    for (const auto& [prefix, i] : {std::pair{std::string("along"), 0u}, std::pair{std::string("across"), 1u}}) {
      json_[prefix + "_stiffness_N_per_m"].push_back(ring.stiffness_N_per_m[i][i]);
      json_[prefix + "_damping_N_s_per_m"].push_back((*ring.damping_N_s_per_m)[i][i]);
    }
  }
  [[nodiscard]] const Json& json() const { return json_; }

 private:
  std::string key_;
  Json json_ = Json::object();
};

std::vector<DynamicRow> moved(const Case& one, const std::vector<double>& frequencies_Hz, ContactMemory& memory) {
  const auto results = run_bearing(one, {.laws = {bearing::Law::ehd}, .frequencies_Hz = frequencies_Hz}, memory);
  return results.empty() ? std::vector<DynamicRow>() : results[0].dynamics;
}

/// The bearing changed by `set(body, value)`, at one frequency.
template <class Set>
Json over(const std::string& key, const Case& one, const std::vector<double>& values, const Set& set,
          ContactMemory& memory) {
  RingSeries series(key);
  for (const double value : values) {
    Case changed = one;
    set(std::get<BearingCase>(changed.body), value);
    for (const DynamicRow& row : moved(changed, {frequency_of_changes_Hz}, memory)) series.add(value, row.ring);
  }
  return series.json();
}

void make_dynamics(const Case& one, Json& made) {
  ContactMemory memory(default_solver().solve);
  const std::vector<DynamicRow> rows = moved(one, shown_frequencies_Hz, memory);
  if (rows.empty()) return;
  RingSeries ring("frequency_Hz");
  for (const DynamicRow& row : rows) ring.add(row.frequency_Hz, row.ring);
  const auto clearance = [](BearingCase& body, double um) { body.geometry.clearance_m = 1e-6 * um; };
  const auto speed = [](BearingCase& body, double part) {
    body.operation.inner_speed_rpm *= part;
    body.operation.outer_speed_rpm *= part;
  };
  made.push_back({{"id", one.id},
                  {"contacts", contacts_in_motion_json(rows.front())},
                  {"ring", ring.json()},
                  {"frequency_of_changes_Hz", frequency_of_changes_Hz},
                  {"over_clearance", over("clearance_um", one, shown_clearances_um, clearance, memory)},
                  {"over_speed", over("part_of_speed", one, shown_parts_of_speed, speed, memory)}});
}

}  // namespace

FigurePart dynamics_part(const std::vector<Case>& cases, bool quick) {
  FigurePart part{.name = "dynamics"};
  auto made = std::make_shared<Json>(Json::array());
  if (!cases.empty() && !quick)
    part.work.push_back({"bearing in motion", [made, one = cases.front()] { make_dynamics(one, *made); }});
  part.finish = [made](Json& figures) {
    if (!made->empty()) figures["dynamics"] = std::move(*made);
  };
  return part;
}

}  // namespace ehd::verification
