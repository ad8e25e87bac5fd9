// SPDX-License-Identifier: GPL-3.0-or-later
// The response of a contact as JSON, which `ehd response --json` writes, its frequencies as CSV, and tables for a
// terminal.
#pragma once

#include <string>

#include "io/json.hpp"
#include "workflow/response_run.hpp"

namespace ehd {

/// Numbers are finite; what is unknown, not asked for or not in SI is absent.
[[nodiscard]] Json to_json(const ResponseRun& run);
/// A header, and a line for each frequency, then for each wave. kappa has the relative error of the complex number. If
/// the case is in SI, the line has stiffness and damping per length, with absolute errors. A cell is empty if its
/// number is not known. Columns of frequencies or of waves are there where the run has some.
[[nodiscard]] std::string response_csv(const ResponseRun& run);
[[nodiscard]] std::string human_table(const ResponseRun& run, const std::string& title);

}  // namespace ehd
