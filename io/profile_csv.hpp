// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of one contact as columns, and as CSV: what `ehd solve --profile` writes.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "workflow/contact_run.hpp"

namespace ehd {

/// A column that a profile may have. x_m, p_Pa, h_m exist where SI is known. rho and eta are relative to rho_0 and
/// eta_0, and absent for a dry contact; where eta/eta_0 overflows, it is NaN. H_error and P_error are the relative
/// errors of the fields (contact/stated_error.hpp), the same at every node, NaN beside a spike of unknown height,
/// absent where they are not known at all. P_unresolved exists where the largest pressure is not known
/// (workflow/shown_pressure.hpp). It is 1 where a spike of unknown height is cut, P and p_Pa at 1.5 p_H, rho and eta
/// NaN, else 0.
struct ProfileRow {
  std::string_view name, unit;
  std::optional<Array> (*values)(const ContactRun& run);  ///< one a node; NaN where there is no number
};
inline constexpr std::size_t most_profile_columns = 11;

/// X, P, H, rho, eta, x_m, p_Pa, h_m, H_error, P_unresolved, P_error.
[[nodiscard]] std::span<const ProfileRow, most_profile_columns> profile_rows();

struct ProfileColumn {
  std::string_view name, unit;
  Array values;
};

/// The columns that this profile has.
[[nodiscard]] std::vector<ProfileColumn> profile_of(const ContactRun& run);

/// The columns under a header line with units; a NaN is left empty.
[[nodiscard]] std::string profile_csv(const ContactRun& run);

}  // namespace ehd
