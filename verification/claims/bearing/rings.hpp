// SPDX-License-Identifier: GPL-3.0-or-later
// What several claims about the parts of a bearing share: a roller contact, displaced rings, and claims about any law.
#pragma once

#include <string>
#include <vector>

#include "bearing/equilibrium.hpp"
#include "bearing/law_table.hpp"
#include "verification/claim.hpp"

namespace ehd::verification::bearing_parts {

[[nodiscard]] bearing::RollerContact some_contact();

/// A balanced roller of a ring that is displaced along and across the load.
struct PlacedRoller {
  double azimuth_rad = 0;
  bearing::RollerState state;
};
[[nodiscard]] std::vector<PlacedRoller> rollers_at(const bearing::Geometry& geometry, const bearing::LawPair& laws,
                                                   double centrifugal_N, double along_m, double across_m);

/// The radial load is the gradient of the energy that a balanced ring has stored.
void add_energy(Findings& found, const std::string& name, const bearing::Geometry& geometry,
                const bearing::LawPair& laws, double centrifugal_N, double radial_N);
/// Slopes and inverse of a law over nine decades of force, to 4 GPa. A film's law goes as far as its contacts are
/// solved.
void add_law(Findings& found, const std::string& name, const bearing::LawPair& laws);

}  // namespace ehd::verification::bearing_parts
