// SPDX-License-Identifier: GPL-3.0-or-later
// Orders fitted to errors, and the claim that one is as declared.
#pragma once

#include <string>
#include <vector>

#include "verification/claim.hpp"

namespace ehd::verification {

/// The slope of y over x by least squares; NaN where a y is not finite.
[[nodiscard]] double slope(const std::vector<double>& x, const std::vector<double>& y);

/// |fitted - declared| against the tolerance.
[[nodiscard]] Claim order_claim(Sentence says, double fitted, double declared, Tolerance tolerance, std::string note);

}  // namespace ehd::verification
