// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/approach.hpp"

#include <cmath>
#include <numbers>

#include "contact/hertz.hpp"

namespace ehd {

using std::numbers::pi;

namespace {
double compliance_m(const Conditions& c) { return 4 * c.load_N_per_m / (pi * c.reduced_modulus_Pa); }
}  // namespace

double approach_m(const Conditions& conditions, double offset, double datum_m) {
  return compliance_m(conditions) * (std::log(datum_m / hertz::half_width_m(conditions)) - 2 * offset);
}

double dry_approach_m(const Conditions& conditions, double datum_m) {
  return approach_m(conditions, hertz::dry_offset(), datum_m);
}

double datum_from_dry_approach_m(const Conditions& conditions, double approach) {
  return hertz::half_width_m(conditions) * std::exp(approach / compliance_m(conditions) + 2 * hertz::dry_offset());
}

}  // namespace ehd
