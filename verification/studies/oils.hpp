// SPDX-License-Identifier: GPL-3.0-or-later
// The two law sets that claims go over, and the atlas lists.
#pragma once

#include "contact/nondimensional.hpp"

namespace ehd::verification {

/// Roelands z = 0.68, alpha = 2.2e-8 1/Pa, p_0 = 1.96e8 Pa with Dowson and Higginson's density; or Barus,
/// incompressible, which at L = 0 is isoviscous.
inline Lubricant oil(bool roelands) {
  if (!roelands) return {};
  return {.viscosity = ViscosityLaw::roelands,
          .density = DensityLaw::dowson_higginson,
          .alpha_per_Pa = 2.2e-8,
          .z = 0.68,
          .p0_Pa = 1.96e8};
}

inline Problem problem_at(MoesGroups moes, bool roelands, Inlet inlet) {
  return nondimensionalise(moes, oil(roelands), inlet).problem;
}

}  // namespace ehd::verification
