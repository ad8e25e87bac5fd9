// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_contact.hpp"

#include <fmt/format.h>

#include <cmath>
#include <variant>

#include "contact/nondimensional.hpp"
#include "contact/oil_laws.hpp"
#include "contact/overloaded.hpp"
#include "io/case_faults.hpp"
#include "io/case_keys.hpp"
#include "io/case_tree.hpp"
#include "io/case_values.hpp"
#include "io/read_oil.hpp"

namespace ehd {

namespace {

/// eta_0 stays open where the oil's grade sets it.
Conditions read_conditions(const CaseTree& tree, bool dry) {
  Conditions conditions;
  conditions.load_N_per_m = number(tree, "conditions.load_N_per_m");
  conditions.reduced_radius_m = number(tree, "conditions.reduced_radius_m");
  conditions.reduced_modulus_Pa = number(tree, "conditions.reduced_modulus_Pa");
  constexpr const char *speed = "conditions.speed_sum_m_per_s", *viscosity = "conditions.viscosity_Pa_s";
  if (dry) {
    Interval speed_or_rest = interval_of(speed);
    speed_or_rest.or_zero = true;
    conditions.speed_sum_m_per_s = maybe_number(tree, speed, speed_or_rest);
    conditions.viscosity_Pa_s = maybe_number(tree, viscosity);
  } else {
    conditions.speed_sum_m_per_s = number(tree, speed);
    if (!states_grade(tree)) conditions.viscosity_Pa_s = number(tree, viscosity);
  }
  return conditions;
}

Statement read_statement(const CaseTree& tree, const std::string& name, bool dry) {
  if (name == "moes") return MoesGroups{.M = number(tree, "moes.M"), .L = number(tree, "moes.L")};
  if (name == "hertz")
    return HertzGroups{.lambda = number(tree, "hertz.lambda"), .alpha_p_H = number(tree, "hertz.alpha_p_H")};
  return read_conditions(tree, dry);
}

/// The viscosity of a contact stands in [conditions].
void refuse_bearing_keys(const CaseTree& tree) {
  for (const CaseKey& key : find_case_table("lubricant")->keys) {
    if (!key.bearing_only) continue;
    const std::string path = fmt::format("lubricant.{}", key.name);
    if (!tree.has(path)) continue;
    tree.fail(path, fmt::format("is unknown in the [lubricant] of a contact; allowed is {} (eta_0 stands in "
                                "[conditions])",
                                list(names_of_keys(*find_case_table("lubricant"), true))));
  }
}

/// Groups alone fix no pressure in Pa. A law that needs such pressures needs alpha, which is then a missing key.
void require_pressure_scale(const CaseTree& tree, const ContactCase& contact) {
  const bool without_scale = std::visit(Overloaded{[](const MoesGroups& groups) { return groups.L > 0; },
                                                   [](const HertzGroups& groups) { return groups.alpha_p_H > 0; },
                                                   [](const Conditions&) { return false; }},
                                        contact.statement);
  const Lubricant& lubricant = *contact.lubricant;
  if (!without_scale || lubricant.alpha_per_Pa) return;
  const ViscosityLawRow& law = row_of(lubricant.viscosity);
  if (!law.keys.p0_Pa && lubricant.density == DensityLaw::incompressible) return;
  const std::string key = "lubricant.alpha_per_Pa";
  tree.fail(key, fmt::format("is missing; required is {}, since {} needs pressures in Pa",
                             text_of(row_of_case_key(key).allowed),
                             law.keys.p0_Pa ? law.name : to_string(lubricant.density)));
}

/// Where M or L follows from other keys: the key that sets the group, else the table that the group follows from.
std::string key_at_fault(const std::string& key, const std::string& statement) {
  if (key != "M" && key != "L") return key;
  if (statement == "moes") return "moes." + key;
  if (statement == "hertz") return key == "M" ? "hertz.lambda" : "hertz.alpha_p_H";
  return statement;
}

}  // namespace

ContactCase read_contact(const CaseTree& tree, const std::string& statement) {
  refuse_unknown(tree);
  ContactCase contact;
  const bool dry = statement == "conditions" && !tree.has("lubricant") && !tree.has("domain");
  if (!dry) refuse_bearing_keys(tree);
  contact.statement = read_statement(tree, statement, dry);
  if (dry) return contact;
  const OilOfCase oil = read_oil(tree);
  contact.lubricant = oil.lubricant;
  contact.oil = oil.grade;
  if (auto* conditions = std::get_if<Conditions>(&contact.statement)) {
    refuse_beside_grade(tree, "conditions.viscosity_Pa_s");
    if (oil.grade) conditions->viscosity_Pa_s = oil.grade->viscosity_Pa_s;
  } else {
    refuse_grade_beside(tree, statement);
  }
  contact.inlet = inlet(tree, "domain.inlet");
  require_pressure_scale(tree, contact);
  try {
    (void)nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet);
  } catch (const StatementError& error) {
    fail_statement(tree, key_at_fault(error.key(), statement), error);
  }
  return contact;
}

}  // namespace ehd
