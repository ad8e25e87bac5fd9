// SPDX-License-Identifier: GPL-3.0-or-later
// The approach of the two bodies. The log kernel leaves it undetermined up to a reference length x_0, the datum:
//   delta = (4 w/(pi E')) [ ln(x_0/b) - 2 H_0 ].
// A film changes the dry approach by an amount that does not depend on the datum: delta - delta_dry = -(b^2/R)(H_0 -
// H_0,dry).
#pragma once

#include "contact/conditions.hpp"

namespace ehd {

/// delta [m] of a contact with offset H_0 and datum x_0 [m]; x_0 = b gives -H_0 b^2/R.
[[nodiscard]] double approach_m(const Conditions& conditions, double offset, double datum_m);
/// delta_dry = (4w/(pi E')) [ ln(2 x_0/b) + 1/2 ] [m].
[[nodiscard]] double dry_approach_m(const Conditions& conditions, double datum_m);
/// The datum with which the dry contact has approach `approach_m` [m] at these conditions; always positive.
[[nodiscard]] double datum_from_dry_approach_m(const Conditions& conditions, double approach_m);

}  // namespace ehd
