// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of one contact as CSV: what `ehd solve --profile` writes.
#pragma once

#include <string>

#include "workflow/contact_run.hpp"

namespace ehd {

/// Columns X, P, H, rho, eta (and x_m, p_Pa, h_m where SI is known), a header line with units. rho and eta are
/// relative to rho_0 and eta_0, and absent for a dry contact; where eta/eta_0 overflows, eta is left empty. H_error is
/// the relative error of the fields (contact/stated_error.hpp), the same in every line, absent where it is not known.
/// Where the spike's height is not known, P and p_Pa are cut at 1.5 p_H (workflow/shown_pressure.hpp), rho and eta are
/// left empty there, and a last column P_unresolved is 1.
[[nodiscard]] std::string profile_csv(const ContactRun& run);

}  // namespace ehd
