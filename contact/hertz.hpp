// SPDX-License-Identifier: GPL-3.0-or-later
// The dry line contact (Hertz 1881), dimensional scales and dimensionless fields.
#pragma once

#include "contact/array.hpp"
#include "contact/conditions.hpp"

namespace ehd::hertz {

/// H_0 of the dry contact, -(1/4 + ln(2)/2) = -0.5965736.
[[nodiscard]] double dry_offset();
/// b = sqrt(8 w R/(pi E')) [m].
[[nodiscard]] double half_width_m(const Conditions& conditions);
/// p_H = 2 w/(pi b) [Pa].
[[nodiscard]] double pressure_Pa(const Conditions& conditions);
/// P(X) = sqrt(1 - X^2) inside |X| < 1, 0 outside.
[[nodiscard]] Array pressure(const Array& X);
/// H - H_c: 0 inside, [ |X| sqrt(X^2-1) - ln(|X| + sqrt(X^2-1)) ]/2 outside.
[[nodiscard]] Array gap(const Array& X);

}  // namespace ehd::hertz
