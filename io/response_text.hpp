// SPDX-License-Identifier: GPL-3.0-or-later
// The response of a contact as JSON, which `ehd response --json` writes, and as tables for a terminal.
#pragma once

#include <string>

#include "io/json.hpp"
#include "workflow/response_run.hpp"

namespace ehd {

/// Numbers are finite; what is unknown, not asked for or not in SI is absent.
[[nodiscard]] Json to_json(const ResponseRun& run);
[[nodiscard]] std::string human_table(const ResponseRun& run, const std::string& title);

}  // namespace ehd
