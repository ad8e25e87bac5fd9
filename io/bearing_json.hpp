// SPDX-License-Identifier: GPL-3.0-or-later
// The result of one bearing and law as JSON: the object that `ehd bearing --json` writes.
#pragma once

#include "io/json.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd {

[[nodiscard]] Json to_json(const BearingResult& result);

}  // namespace ehd
