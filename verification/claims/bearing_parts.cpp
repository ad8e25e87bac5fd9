// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11, the parts of a bearing: the list of topics. What they judge stands in bearing/, a file a part.
#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "verification/claims/bearing/parts.hpp"
#include "verification/claims/topics.hpp"
#include "verification/solution_memory.hpp"
#include "workflow/contact_memory.hpp"

namespace ehd::verification {

using namespace bearing_parts;

std::vector<Topic> bearing_part_topics(const std::vector<LoadedCase>& cases) {
  std::vector<Topic> topics;
  const auto add = [&](const std::string& name, std::function<Findings()> judge) {
    topics.push_back({.name = name, .rungs = {11}, .judge = std::move(judge)});
  };
  add("energy", judge_energy);
  add("many rollers", judge_many_rollers);
  add("dry laws", judge_dry_laws);
  add("ring in the plane", judge_plane);
  add("light load", judge_light_load);
  add("random bearings", judge_random_bearings);
  add("rollers in motion", judge_rollers_in_motion);
  for (const LoadedCase& loaded : cases) {
    const auto* one = std::get_if<Case>(&loaded.content);
    if (!one || !std::holds_alternative<BearingCase>(one->body)) continue;
    topics.push_back({.name = one->id + ", forms", .rungs = {11}, .case_id = one->id, .judge = [c = *one] {
                        return judge_forms(c);
                      }});
  }
  const auto na4908 =
      std::find_if(cases.begin(), cases.end(), [](const LoadedCase& loaded) { return loaded.id == "na4908"; });
  if (na4908 == cases.end() || !std::holds_alternative<Case>(na4908->content)) return topics;
  const Case one = std::get<Case>(na4908->content);
  add("kinematics", [one] { return judge_kinematics(one); });
  add("contacts of a bearing", [one] { return judge_contacts_asked(one); });
  const auto add_with_memory = [&](const std::string& name, Findings (*judge)(const Case&, ContactMemory&)) {
    add(name, [one, judge] {
      ContactMemory memory(remembered(default_solver().name).solve);
      return judge(one, memory);
    });
  };
  add_with_memory("datum", judge_datum);
  add_with_memory("fit", judge_fit);
  add_with_memory("roughness", judge_roughness);
  add_with_memory("curve", judge_curve);
  add_with_memory("full relation", judge_full_relation);
  add_with_memory("zero speed", judge_zero_speed);
  add_with_memory("torque", judge_torque);
  add_with_memory("bearing in motion", judge_dynamics);
  topics.back().expected_s = 5;  // four contacts by `reference`
  return topics;
}

}  // namespace ehd::verification
