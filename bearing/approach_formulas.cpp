// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/approach_formulas.hpp"

#include <cmath>
#include <numbers>

#include "contact/hertz.hpp"

namespace ehd::bearing {

using std::numbers::ln2;
using std::numbers::pi;

namespace {

Geometry geometry_of(const RollerContact& contact) {
  Geometry geometry;
  geometry.pitch_diameter_m = contact.pitch_diameter_m;
  geometry.roller_diameter_m = contact.roller_diameter_m;
  return geometry;
}

double half_width_of(const RollerContact& contact, Raceway raceway) {
  return hertz::half_width_m({.load_N_per_m = contact.force_N / contact.length_m,
                              .reduced_radius_m = reduced_radius_m(geometry_of(contact), raceway),
                              .reduced_modulus_Pa = reduced_modulus_Pa(contact.modulus_Pa, contact.poisson)});
}

/// (2Q/(pi l)) (1-nu^2)/E, of one body [m].
double compliance_of_one_body_m(const RollerContact& contact) {
  return 2 * contact.force_N / (pi * contact.length_m) * (1 - contact.poisson * contact.poisson) / contact.modulus_Pa;
}

}  // namespace

double palmgren_approach_m(const RollerContact& contact) {
  return 1e-3 * 3.84e-5 * std::pow(contact.force_N, 0.9) / std::pow(1e3 * contact.length_m, 0.8);
}

double kunert_approach_m(const RollerContact& contact) {
  return 1e-3 * 4.05e-5 * std::pow(contact.force_N, 0.925) / std::pow(1e3 * contact.length_m, 0.85);
}

double lundberg_approach_m(const RollerContact& contact, Raceway raceway) {
  const double b = half_width_of(contact, raceway);
  return 2 * compliance_of_one_body_m(contact) * (2 * ln2 + 0.5 + std::log(contact.length_m / (2 * b)));
}

double tripp_approach_m(const RollerContact& contact, Raceway raceway) {
  const double b = half_width_of(contact, raceway);
  const double roller = std::log(2 * contact.roller_diameter_m / b) - 0.5;
  const double inner_ring = std::log(4 * raceway_radius_m(geometry_of(contact), Raceway::inner) / b) - 0.5;
  const double outer_ring = std::log(2 * contact.ring_thickness_m / b) - contact.poisson / (2 * (1 - contact.poisson));
  return compliance_of_one_body_m(contact) * (roller + (raceway == Raceway::inner ? inner_ring : outer_ring));
}

double houpert_approach_m(const RollerContact& contact, Raceway raceway) {
  // Fractional powers of lengths: printed for mm and MPa.
  const double Q = contact.force_N * (1 - contact.poisson * contact.poisson), E = contact.modulus_Pa * 1e-6,
               l = 1e3 * contact.length_m, d_m = 1e3 * contact.pitch_diameter_m, t = 1e3 * contact.ring_thickness_m,
               gamma = contact.roller_diameter_m / contact.pitch_diameter_m;
  if (raceway == Raceway::inner) return 1e-3 * std::pow(Q * std::pow(d_m, 0.074) / (0.2723 * E * l), 1 / 1.074);
  return 1e-3 * std::pow(Q / (0.27835 * E * l) * std::pow(t / (1 + gamma), 0.078), 1 / 1.078);
}

}  // namespace ehd::bearing
