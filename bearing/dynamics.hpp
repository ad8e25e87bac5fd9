// SPDX-License-Identifier: GPL-3.0-or-later
// A roller bearing in small harmonic motion e^(i omega t) about its balance: contacts, rollers, ring.
//
// A contact is a spring with a damper, K = k + i omega c. A roller of mass m between the contacts K_i and K_o moves
// along its azimuth. From its equation of motion, -m omega^2 v = K_i (u - v) - K_o v for a displacement u of the inner
// ring, it gives the ring the stiffness
//   k_j = K_i (u - v)/u = K_i (K_o - m omega^2)/(K_i + K_o - m omega^2).
// The ring has K(omega) = Sum_j k_j [cos^2, cos sin; cos sin, sin^2]: stiffness Re K, damping Im K/omega.
// Left out: the rollers' own turning and gyroscopic motion, the cage, and the passage of rollers through the load zone.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "bearing/geometry.hpp"
#include "bearing/response_curve.hpp"

namespace ehd::bearing {

/// K = stiffness + i omega damping [N/m, N s/m]. A law without a film knows no damping. Errors are absolute.
struct ContactMotion {
  double stiffness_N_per_m = 0;
  std::optional<double> damping_N_s_per_m = {};
  double stiffness_error = 0, damping_error = 0;
};

/// K = l/[4/(E' kappa) + (4/(pi E')) ln(x_0/l)] of a contact with a film at a force [N]; kappa has the datum l
/// (response_curve.hpp), and another datum x_0 is a compliance in series. The errors are the changes that the errors of
/// kappa make.
[[nodiscard]] ContactMotion contact_motion(const RacewayContact& contact, double force_N, double datum_m, double omega,
                                           const Kappa& kappa);

struct RollerMotion {
  double azimuth_deg = 0;
  ContactMotion inner, outer;
};

using Matrix2 = std::array<std::array<double, 2>, 2>;

/// The ring, x along the load and y across it. Errors are relative to the trace; damping is absent where a contact
/// knows none.
struct RingMotion {
  Matrix2 stiffness_N_per_m = {};
  std::optional<Matrix2> damping_N_s_per_m = {};
  double error = 0;                          ///< of the stiffness
  std::optional<double> damping_error = {};  ///< of the damping
};

/// omega in rad/s, 0 is legal: the damping is then its limit.
[[nodiscard]] RingMotion ring_motion(const std::vector<RollerMotion>& rollers, double mass_kg, double omega);

}  // namespace ehd::bearing
