// SPDX-License-Identifier: GPL-3.0-or-later
// What a bearing case says, in the types of bearing/.
#pragma once

#include "bearing/approach_formulas.hpp"
#include "bearing/geometry.hpp"
#include "workflow/case.hpp"

namespace ehd {

[[nodiscard]] bearing::RollerContact roller_contact_of(const BearingCase& body);
[[nodiscard]] bearing::Speeds speeds_of(const BearingCase& body);
/// The contact of a roller with each raceway; its viscosity is 0 where the case has no lubricant.
[[nodiscard]] bearing::BothRaceways<bearing::RacewayContact> raceway_contacts_of(const BearingCase& body);
/// The rings do not move against each other.
[[nodiscard]] bool at_rest(const BearingCase& body);
/// The datum follows from the dry balance.
[[nodiscard]] bool datum_from_dry(const BearingCase& body);

}  // namespace ehd
