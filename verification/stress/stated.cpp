// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/stress/stated.hpp"

namespace ehd::verification::stress {

namespace {

std::vector<Input> inputs_of(const Conditions&) {
  const auto SI = [](Stated& s) -> Conditions& { return std::get<Conditions>(s.statement); };
  return {{"load", [SI](Stated& s) -> double& { return SI(s).load_N_per_m; }},
          {"radius", [SI](Stated& s) -> double& { return SI(s).reduced_radius_m; }},
          {"modulus", [SI](Stated& s) -> double& { return SI(s).reduced_modulus_Pa; }},
          {"speed", [SI](Stated& s) -> double& { return *SI(s).speed_sum_m_per_s; }},
          {"viscosity", [SI](Stated& s) -> double& { return *SI(s).viscosity_Pa_s; }}};
}

std::vector<Input> inputs_of(const MoesGroups&) {
  return {{"M", [](Stated& s) -> double& { return std::get<MoesGroups>(s.statement).M; }},
          {"L", [](Stated& s) -> double& { return std::get<MoesGroups>(s.statement).L; }}};
}

std::vector<Input> inputs_of(const HertzGroups&) {
  return {{"lambda", [](Stated& s) -> double& { return std::get<HertzGroups>(s.statement).lambda; }},
          {"alpha_p_H", [](Stated& s) -> double& { return std::get<HertzGroups>(s.statement).alpha_p_H; }}};
}

}  // namespace

std::vector<Input> inputs_of(const Stated& stated) {
  std::vector<Input> all = std::visit([](const auto& statement) { return inputs_of(statement); }, stated.statement);
  all.push_back({"inlet", [](Stated& s) -> double& { return s.inlet; }});
  if (stated.lubricant.alpha_per_Pa)
    all.push_back({"alpha", [](Stated& s) -> double& { return *s.lubricant.alpha_per_Pa; }});
  if (stated.lubricant.viscosity == ViscosityLaw::roelands) {
    all.push_back({"z", [](Stated& s) -> double& { return *s.lubricant.z; }});
    all.push_back({"p0", [](Stated& s) -> double& { return s.lubricant.p0_Pa; }});
  }
  return all;
}

Conditions ordinary_conditions() {
  return {.load_N_per_m = 1.1e5,
          .reduced_radius_m = 0.0113,
          .reduced_modulus_Pa = 2.26e11,
          .speed_sum_m_per_s = 2.9,
          .viscosity_Pa_s = 0.021};
}

}  // namespace ehd::verification::stress
