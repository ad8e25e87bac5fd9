// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 3: the film of every scheme under a pressure that is given.
#pragma once

#include "verification/claim.hpp"
#include "verification/claims/schemes.hpp"

namespace ehd::verification {

[[nodiscard]] Findings judge_film(const schemes::Named& scheme);
/// The same of polynomial elements.
[[nodiscard]] Findings judge_collocation_film();

}  // namespace ehd::verification
