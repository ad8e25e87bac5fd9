// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_contact.hpp"

#include <fmt/format.h>

#include <cmath>
#include <variant>

#include "contact/nondimensional.hpp"
#include "contact/oil_laws.hpp"
#include "contact/overloaded.hpp"
#include "io/case_keys.hpp"
#include "io/case_tree.hpp"
#include "io/case_values.hpp"

namespace ehd {

namespace {

Inlet read_inlet(const CaseTree& tree) {
  const std::string key = "domain.inlet";
  const CaseKey& row = row_of_case_key(key);
  const auto& range = std::get<allowed::Inlet>(row.allowed);
  const std::string allowed = "; allowed is " + text_of(row.allowed);
  const CaseNode& node = required(tree, key, text_of(row.allowed));
  if (const auto* word = std::get_if<std::string>(&node.content)) {
    if (*word == range.word) return Flooded{};
    tree.fail(key, "is unknown" + allowed);
  }
  const auto x = node.number();
  if (!x) tree.fail(key, "is " + node.type + allowed);
  if (!std::isfinite(*x)) tree.fail(key, "is not finite" + allowed);
  if (!(*x < range.edge)) tree.fail(key, "lies inside or behind the contact" + allowed);
  if (*x < range.farthest) tree.fail(key, "is out of range" + allowed);
  return TruncatedAt{*x};
}

Conditions read_conditions(const CaseTree& tree, bool dry) {
  Conditions conditions;
  conditions.load_N_per_m = number(tree, "conditions.load_N_per_m");
  conditions.reduced_radius_m = number(tree, "conditions.reduced_radius_m");
  conditions.reduced_modulus_Pa = number(tree, "conditions.reduced_modulus_Pa");
  const std::string speed = "conditions.speed_sum_m_per_s", viscosity = "conditions.viscosity_Pa_s";
  if (dry) {
    Interval speed_or_rest = interval_of(speed);
    speed_or_rest.or_zero = true;
    conditions.speed_sum_m_per_s = maybe_number(tree, speed, speed_or_rest);
    conditions.viscosity_Pa_s = maybe_number(tree, viscosity);
  } else {
    conditions.speed_sum_m_per_s = number(tree, speed);
    conditions.viscosity_Pa_s = number(tree, viscosity);
  }
  return conditions;
}

Statement read_statement(const CaseTree& tree, const std::string& name, bool dry) {
  if (name == "moes") return MoesGroups{.M = number(tree, "moes.M"), .L = number(tree, "moes.L")};
  if (name == "hertz")
    return HertzGroups{.lambda = number(tree, "hertz.lambda"), .alpha_p_H = number(tree, "hertz.alpha_p_H")};
  return read_conditions(tree, dry);
}

/// A lubricated contact needs [lubricant] and [domain]; the viscosity stands in [conditions].
void require_tables_of_lubricated(const CaseTree& tree, const std::string& statement) {
  for (const auto& table : names_of_companions(false)) {
    if (tree.has(table)) continue;
    const char* const or_dry = statement == "conditions" ? ", or neither for a dry contact" : "";
    tree.fail(table, fmt::format("is missing; required is [lubricant] with [domain]{}", or_dry));
  }
  for (const CaseKey& key : find_case_table("lubricant")->keys) {
    const std::string path = fmt::format("lubricant.{}", key.name);
    if (!key.bearing_only || !tree.has(path)) continue;
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

Lubricant read_lubricant(const CaseTree& tree) {
  Lubricant lubricant;
  lubricant.viscosity = *viscosity_law_from(word(tree, "lubricant.viscosity"));
  lubricant.density = *density_law_from(word(tree, "lubricant.density"));
  lubricant.alpha_per_Pa = maybe_number(tree, "lubricant.alpha_per_Pa");
  lubricant.z = maybe_number(tree, "lubricant.z");
  lubricant.p0_Pa = number_or_standard(tree, "lubricant.p0_Pa");
  return lubricant;
}

ContactCase read_contact(const CaseTree& tree, const std::string& statement) {
  ContactCase contact;
  const bool dry = statement == "conditions" && !tree.has("lubricant") && !tree.has("domain");
  if (!dry) require_tables_of_lubricated(tree, statement);
  contact.statement = read_statement(tree, statement, dry);
  if (dry) return contact;
  contact.lubricant = read_lubricant(tree);
  contact.inlet = read_inlet(tree);
  require_pressure_scale(tree, contact);
  try {
    (void)nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet);
  } catch (const StatementError& error) {
    fail_statement(tree, key_at_fault(error.key(), statement), error);
  }
  return contact;
}

}  // namespace ehd
