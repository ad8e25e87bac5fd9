// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/hertz.hpp"

#include <cmath>
#include <numbers>

namespace ehd::hertz {

using std::numbers::pi;

double dry_offset() { return -(0.25 + std::numbers::ln2 / 2); }

double half_width_m(const Conditions& c) {
  // One factor at a time: the product of two extreme inputs may overflow where the width does not.
  return std::sqrt(8 * c.load_N_per_m / (pi * c.reduced_modulus_Pa)) * std::sqrt(c.reduced_radius_m);
}

double pressure_Pa(const Conditions& c) { return 2 * c.load_N_per_m / (pi * half_width_m(c)); }

Array pressure(const Array& X) { return (1 - X.square()).max(0).sqrt(); }

Array gap(const Array& X) {
  const Array a = X.abs().max(1.0);
  const Array root = ((a - 1) * (a + 1)).sqrt();
  return (a * root - (a + root).log()) / 2;
}

}  // namespace ehd::hertz
