// SPDX-License-Identifier: GPL-3.0-or-later
// The result of one bearing and law as JSON: the object that `ehd bearing --json` writes.
#pragma once

#include "io/json.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd {

/// `full`: the result of the law ehd for the same bearing (full_relation_in). Without it a fitted law states no error
/// of its stiffness.
[[nodiscard]] Json to_json(const BearingResult& result, const BearingResult* full = nullptr);

}  // namespace ehd
