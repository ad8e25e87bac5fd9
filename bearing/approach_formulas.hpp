// SPDX-License-Identifier: GPL-3.0-or-later
// Approach of a roller of finite length and its raceway as the literature prints it (Teutsch & Sauer 2004, J. Tribol.
// 126, 436-442, table 1). Each stands once, as the coefficients of its form in the contact force. The force laws
// lundberg, tripp and houpert are made of them (force_law.hpp). Palmgren's law stands there as its rounded inverse.
#pragma once

#include "bearing/geometry.hpp"

namespace ehd::bearing {

/// One roller contact; SI.
struct RollerContact {
  double force_N = 0;  ///< not used by the ..._terms functions, which hold for every force
  double length_m = 0;
  double roller_diameter_m = 0;
  double pitch_diameter_m = 0;
  double modulus_Pa = 0;  ///< Young's modulus of both bodies
  double poisson = 0;
  double ring_thickness_m = 0;  ///< used by tripp and houpert at the outer raceway
};

/// delta = scale Q^exponent [m, N].
struct PowerApproach {
  double scale = 0, exponent = 0;
};
/// delta = scale Q ln(limit/Q) [m, N]. The logarithm is that of (length/b)^2: a length of the bodies over the contact's
/// half width b ~ sqrt(Q). The formulas are printed for b far below that length. Beyond Q = limit/e they fall with the
/// force.
struct LogarithmicApproach {
  double scale_m_per_N = 0, limit_N = 0;
};

[[nodiscard]] LogarithmicApproach lundberg_terms(const RollerContact& contact, Raceway raceway);
[[nodiscard]] LogarithmicApproach tripp_terms(const RollerContact& contact, Raceway raceway);
[[nodiscard]] PowerApproach houpert_terms(const RollerContact& contact, Raceway raceway);

// All return the approach in m.
/// 3.84e-5 Q^0.9/l^0.8 (N, mm), the same at both raceways.
[[nodiscard]] double palmgren_approach_m(const RollerContact& contact);
/// 4.05e-5 Q^0.925/l^0.85 (N, mm).
[[nodiscard]] double kunert_approach_m(const RollerContact& contact);
/// (2Q/(pi l)) Sum((1-nu^2)/E) (2 ln 2 + 1/2 + ln(l/2b)).
[[nodiscard]] double lundberg_approach_m(const RollerContact& contact, Raceway raceway);
/// Inner (2Q/(pi l)) Sum (1-nu^2)/E (ln(4 R_k/b) - 1/2), R_k the radius of each body; the outer ring's term is
/// ln(2 t/b) - nu/(2(1-nu)), t its thickness.
[[nodiscard]] double tripp_approach_m(const RollerContact& contact, Raceway raceway);
/// Inner [Q(1-nu^2) d_m^0.074/(0.2723 E l)]^(1/1.074), outer [Q(1-nu^2)/(0.27835 E l) (t/(1+D/d_m))^0.078]^(1/1.078).
[[nodiscard]] double houpert_approach_m(const RollerContact& contact, Raceway raceway);

}  // namespace ehd::bearing
