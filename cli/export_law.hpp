// SPDX-License-Identifier: GPL-3.0-or-later
// ehd export law: the contact force law of one raceway as a table.
#pragma once

#include <optional>
#include <string>

#include "cli/case_choice.hpp"

namespace ehd::cli {

struct LawExportOptions {
  std::string case_name, format;
  CaseChanges changes;
  std::optional<std::string> raceway, law, knots, output, time_limit, time_limit_total;
};

/// Returns the exit code. Throws UsageError, CaseError, OutputError.
[[nodiscard]] int export_law(const LawExportOptions& options);

}  // namespace ehd::cli
