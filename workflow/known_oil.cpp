// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/known_oil.hpp"

#include <variant>

#include "contact/nondimensional.hpp"
#include "contact/oil_laws.hpp"

namespace ehd {

Lubricant with_alpha_and_z(Lubricant oil, const Conditions& contact) {
  const LawKeys keys = row_of(oil.viscosity).keys;
  if (!keys.alpha_per_Pa || !keys.z || (oil.alpha_per_Pa && oil.z)) return oil;
  const Nondimensional made = nondimensionalise(contact, oil, Flooded{});
  if (!oil.alpha_per_Pa) oil.alpha_per_Pa = made.problem.groups.alpha_p_H / made.scales->hertz_pressure_Pa;
  if (!oil.z) oil.z = std::get<Roelands>(made.problem.viscosity).z;
  return oil;
}

}  // namespace ehd
