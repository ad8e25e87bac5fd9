// SPDX-License-Identifier: GPL-3.0-or-later
// Cells (io/csv) of the tables that benchmarks and the atlas write.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/solution.hpp"
#include "io/csv.hpp"

namespace ehd::verification {

/// "converged", ...; "not-run" without a status.
[[nodiscard]] std::string status_cell(const std::optional<StopReason>& status);
/// A number of a table for people; "-" where it is unknown.
[[nodiscard]] std::string dash(const std::optional<double>& value, int digits);

}  // namespace ehd::verification
