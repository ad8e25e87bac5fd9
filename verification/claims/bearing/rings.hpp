// SPDX-License-Identifier: GPL-3.0-or-later
// What several claims about the parts of a bearing share: a roller contact, the dry laws, and claims about any law.
#pragma once

#include <string>

#include "bearing/equilibrium.hpp"
#include "bearing/law_table.hpp"
#include "verification/claim.hpp"

namespace ehd::verification::bearing_parts {

inline constexpr bearing::Law printed_laws[] = {bearing::Law::hertz, bearing::Law::iso, bearing::Law::lundberg,
                                                bearing::Law::tripp, bearing::Law::houpert};

[[nodiscard]] bearing::RollerContact some_contact();

/// The radial load is the gradient of the energy that a balanced ring has stored.
void add_energy(Findings& found, const std::string& name, const bearing::Geometry& geometry,
                const bearing::LawPair& laws, double centrifugal_N, double radial_N);
/// Slopes and inverse of a law, over nine decades of force, to 4 GPa; the law of a film as far as contacts are solved.
void add_law(Findings& found, const std::string& name, const bearing::LawPair& laws);

}  // namespace ehd::verification::bearing_parts
