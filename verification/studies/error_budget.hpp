// SPDX-License-Identifier: GPL-3.0-or-later
// The error budget of a load distribution: its numerical errors (workflow/bearing_errors.hpp), and what another datum
// changes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "workflow/bearing_errors.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification {

/// The source of the rows that say what another datum changes: a choice of the case, not an error of the numerics.
inline constexpr const char* datum_source = "datum";

/// The rows of one EHD law among the results of a case; empty for a dry law, and where a balance is missing. The line
/// ehd-linear is as far off as it differs from ehd ("fit") and as ehd itself is; ehd is balanced where it is not among
/// the results, on the curve that the memory has. The case's datum is compared with palmgren, lundberg (where it is not
/// that itself) and twice its x_0. The datum does not change the contacts: they are taken from the memory.
[[nodiscard]] std::vector<BudgetRow> budget_of(const Case& bearing_case, const std::vector<BearingResult>& results,
                                               bearing::Law law, ContactMemory& memory);

/// The sum of a budget without the datum (BearingResult::errors).
[[nodiscard]] std::optional<BearingErrors> numerical_errors(std::vector<BudgetRow> budget);

/// Why the balance of a law with films has no budget; absent where it has one, and where there is nothing to budget.
[[nodiscard]] std::optional<std::string> why_no_budget(const Case& bearing_case,
                                                       const std::vector<BearingResult>& results, bearing::Law law,
                                                       ContactMemory& memory);

/// A number that is not finite is no bound: its key is then in the row's list "unknown".
[[nodiscard]] Json to_json(const std::vector<BudgetRow>& rows);
[[nodiscard]] std::string human_budget(const std::vector<BudgetRow>& rows);

}  // namespace ehd::verification
