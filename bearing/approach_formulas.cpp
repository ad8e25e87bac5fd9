// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/approach_formulas.hpp"

#include <cmath>
#include <numbers>

#include "contact/hertz.hpp"

namespace ehd::bearing {

using std::numbers::e;
using std::numbers::pi;

namespace {

Geometry geometry_of(const RollerContact& contact) {
  Geometry geometry;
  geometry.pitch_diameter_m = contact.pitch_diameter_m;
  geometry.roller_diameter_m = contact.roller_diameter_m;
  return geometry;
}

/// b^2/Q [m^2/N].
double half_width_squared_per_N(const RollerContact& contact, Raceway raceway) {
  const double b = hertz::half_width_m({.load_N_per_m = 1 / contact.length_m,
                                        .reduced_radius_m = reduced_radius_m(geometry_of(contact), raceway),
                                        .reduced_modulus_Pa = reduced_modulus_Pa(contact.modulus_Pa, contact.poisson)});
  return b * b;
}

/// (2/(pi l)) (1-nu^2)/E, of one body [m/N].
double compliance_of_one_body(const RollerContact& contact) {
  return 2 / (pi * contact.length_m) * (1 - contact.poisson * contact.poisson) / contact.modulus_Pa;
}

/// (2Q/(pi l)) (1-nu^2)/E ln(area/b^2): two bodies, each with ln(length/b), and what is added to either.
LogarithmicApproach from_area(const RollerContact& contact, Raceway raceway, double area_m2) {
  return {compliance_of_one_body(contact), area_m2 / half_width_squared_per_N(contact, raceway)};
}

double at(const LogarithmicApproach& terms, double Q) { return terms.scale_m_per_N * Q * std::log(terms.limit_N / Q); }
double at(const PowerApproach& terms, double Q) { return terms.scale * std::pow(Q, terms.exponent); }

}  // namespace

double palmgren_approach_m(const RollerContact& contact) {
  return 1e-3 * 3.84e-5 * std::pow(contact.force_N, 0.9) / std::pow(1e3 * contact.length_m, 0.8);
}

double kunert_approach_m(const RollerContact& contact) {
  return 1e-3 * 4.05e-5 * std::pow(contact.force_N, 0.925) / std::pow(1e3 * contact.length_m, 0.85);
}

LogarithmicApproach lundberg_terms(const RollerContact& contact, Raceway raceway) {
  // 2 (2 ln 2 + 1/2 + ln(l/2b)) = ln(4 e l^2/b^2)
  return from_area(contact, raceway, 4 * e * contact.length_m * contact.length_m);
}

LogarithmicApproach tripp_terms(const RollerContact& contact, Raceway raceway) {
  const double roller = 2 * contact.roller_diameter_m * std::exp(-0.5);
  const double inner_ring = 4 * raceway_radius_m(geometry_of(contact), Raceway::inner) * std::exp(-0.5);
  const double outer_ring = 2 * contact.ring_thickness_m * std::exp(-contact.poisson / (2 * (1 - contact.poisson)));
  return from_area(contact, raceway, roller * (raceway == Raceway::inner ? inner_ring : outer_ring));
}

PowerApproach houpert_terms(const RollerContact& contact, Raceway raceway) {
  // Fractional powers of lengths: printed for mm and MPa.
  const double per_force =
                   (1 - contact.poisson * contact.poisson) / (contact.modulus_Pa * 1e-6 * 1e3 * contact.length_m),
               d_m = 1e3 * contact.pitch_diameter_m, t = 1e3 * contact.ring_thickness_m,
               gamma = contact.roller_diameter_m / contact.pitch_diameter_m;
  const auto in_mm = [](double factor, double power) {
    return PowerApproach{1e-3 * std::pow(factor, 1 / power), 1 / power};
  };
  if (raceway == Raceway::inner) return in_mm(per_force * std::pow(d_m, 0.074) / 0.2723, 1.074);
  return in_mm(per_force / 0.27835 * std::pow(t / (1 + gamma), 0.078), 1.078);
}

double lundberg_approach_m(const RollerContact& contact, Raceway raceway) {
  return at(lundberg_terms(contact, raceway), contact.force_N);
}
double tripp_approach_m(const RollerContact& contact, Raceway raceway) {
  return at(tripp_terms(contact, raceway), contact.force_N);
}
double houpert_approach_m(const RollerContact& contact, Raceway raceway) {
  return at(houpert_terms(contact, raceway), contact.force_N);
}

}  // namespace ehd::bearing
