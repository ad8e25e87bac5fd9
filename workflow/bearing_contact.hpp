// SPDX-License-Identifier: GPL-3.0-or-later
// One contact of a roller with a raceway: conditions in SI -> dimensionless problem -> solution -> the numbers that a
// contact force law needs.
#pragma once

#include "bearing/solved_contacts.hpp"
#include "contact/conditions.hpp"
#include "contact/solver.hpp"
#include "workflow/contact_cache.hpp"

namespace ehd {

/// The central film to 1e-4, the smallest film to 1e-3. The error of the central film is close to that of the offset
/// film, where 1e-4 moves a contact force by a few parts in 1e5.
[[nodiscard]] Request bearing_contact_request();

/// The solver as bearings use it. First it asks for the tolerance of the request. If that is not met, it accepts 1e-3,
/// which is all that a contact force law needs.
[[nodiscard]] ContactSolver with_fallback(ContactSolver solver);

/// The contact at a load [N/m]. `cache`: of a solver with fallback.
[[nodiscard]] bearing::ContactResult solve_bearing_contact(const bearing::RacewayContact& contact,
                                                           const Lubricant& lubricant, double load_N_per_m,
                                                           const Request& request, ContactCache& cache);

}  // namespace ehd
