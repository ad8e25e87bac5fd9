// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/film_table_oil.hpp"

#include "contact/nondimensional.hpp"
#include "contact/oil_laws.hpp"
#include "workflow/known_oil.hpp"

namespace ehd {

namespace {

/// What a case says about its oil, and a contact in SI that fixes what follows from eta_0.
struct StatedTableOil {
  TableOil oil;
  std::optional<Conditions> conditions = {};
};

StatedTableOil stated_oil(const Case& stated, const ContactCase& contact) {
  if (contact.dry()) throw case_error(stated, "", "is dry and has no film; allowed is a case with [lubricant]");
  StatedTableOil found{.oil = {.lubricant = *contact.lubricant, .inlet = *contact.inlet}};
  if (const auto* si = std::get_if<Conditions>(&contact.statement)) found.conditions = *si;
  return found;
}

StatedTableOil stated_oil(const Case& stated, const BearingCase& bearing) {
  if (!bearing.lubricant) throw case_error(stated, "", "is dry and has no film; allowed is a case with [lubricant]");
  // Any contact will do: alpha and z follow from eta_0 alone.
  const Conditions any{.load_N_per_m = 1e5,
                       .reduced_radius_m = 1e-2,
                       .reduced_modulus_Pa = 2e11,
                       .speed_sum_m_per_s = 1,
                       .viscosity_Pa_s = bearing.lubricant->viscosity_Pa_s};
  return {.oil = {.lubricant = bearing.lubricant->lubricant}, .conditions = any};
}

bool same_inlet(const Inlet& one, const Inlet& other) {
  const auto cut = [](const Inlet& inlet) -> std::optional<double> {
    const auto* at = std::get_if<TruncatedAt>(&inlet);
    return at ? std::optional(at->x) : std::nullopt;
  };
  return cut(one) == cut(other);
}

}  // namespace

TableOil table_oil(const Case& stated) {
  const StatedTableOil found = std::visit([&](const auto& body) { return stated_oil(stated, body); }, stated.body);
  TableOil oil = found.oil;
  const LawKeys keys = row_of(oil.lubricant.viscosity).keys;
  if (!keys.alpha_per_Pa)
    throw case_error(stated, "lubricant.viscosity",
                     "has no film that depends on L; allowed is " + piezoviscous_names());
  if (found.conditions) oil.lubricant = with_alpha_and_z(oil.lubricant, *found.conditions);
  try {
    (void)problem_of(oil, {.M = 1, .L = 1});
  } catch (const StatementError& error) {
    throw case_error(stated, error.key(), error.what());
  }
  return oil;
}

bool same_oil(const TableOil& one, const TableOil& other) {
  const Lubricant &a = one.lubricant, &b = other.lubricant;
  return a.viscosity == b.viscosity && a.density == b.density && a.alpha_per_Pa == b.alpha_per_Pa && a.z == b.z &&
         a.p0_Pa == b.p0_Pa && same_inlet(one.inlet, other.inlet);
}

Problem problem_of(const TableOil& oil, const MoesGroups& at) {
  return nondimensionalise(at, oil.lubricant, oil.inlet).problem;
}

}  // namespace ehd
