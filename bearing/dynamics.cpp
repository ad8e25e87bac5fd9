// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace ehd::bearing {

namespace {

/// k + i omega c. The damping is kept apart from omega, so that it has digits at omega = 0.
struct Spring {
  double stiffness = 0, damping = 0;
  [[nodiscard]] std::complex<double> at(double omega) const { return {stiffness, omega * damping}; }
  Spring& operator+=(const Spring& other) {
    stiffness += other.stiffness;
    damping += other.damping;
    return *this;
  }
};

/// l kappa/(a + d kappa), a = 4/E' and d = (4/(pi E')) ln(x_0/l): kappa has the datum l.
Spring with_datum(const RacewayContact& contact, double force_N, double datum_m, double omega, Spring kappa) {
  const double a = 4 / contact.reduced_modulus_Pa, d = a / std::numbers::pi * std::log(datum_m / contact.length_m);
  const double Omega_per_omega = Omega_of(contact, force_N, 1);
  const double squeeze = Omega_per_omega * omega * kappa.damping;  // Im kappa
  const double size = std::norm(a + d * std::complex<double>(kappa.stiffness, squeeze)), l = contact.length_m;
  return {.stiffness = l * (kappa.stiffness * (a + d * kappa.stiffness) + d * squeeze * squeeze) / size,
          .damping = l * a * kappa.damping * Omega_per_omega / size};
}

/// K_i (K_o - m omega^2)/(K_i + K_o - m omega^2). With A and B for the two factors,
/// Im(A B/(A + B)) = (Im A |B|^2 + Im B |A|^2)/|A + B|^2.
Spring between_contacts(const Spring& inner, Spring outer, double mass_kg, double omega) {
  outer.stiffness -= mass_kg * omega * omega;
  const std::complex<double> A = inner.at(omega), B = outer.at(omega);
  if (A == 0.0) return {};  // an unloaded roller gives the ring nothing
  return {.stiffness = (A * B / (A + B)).real(),
          .damping = (inner.damping * std::norm(B) + outer.damping * std::norm(A)) / std::norm(A + B)};
}

Spring spring_of(const ContactMotion& contact) {
  return {.stiffness = contact.stiffness_N_per_m, .damping = contact.damping_N_s_per_m.value_or(0)};
}

/// The errors of a spring that `make` makes of `one`, from the errors of `one`.
template <class Make>
Spring change(const Make& make, Spring one, double stiffness_error, double damping_error) {
  if (!std::isfinite(stiffness_error + damping_error)) return {.stiffness = unknown_error, .damping = unknown_error};
  const Spring made = make(one);
  const Spring stiffer = make({one.stiffness + stiffness_error, one.damping}),
               slower = make({one.stiffness, one.damping + damping_error});
  return {.stiffness = std::abs(stiffer.stiffness - made.stiffness) + std::abs(slower.stiffness - made.stiffness),
          .damping = std::abs(stiffer.damping - made.damping) + std::abs(slower.damping - made.damping)};
}

void add_along(Matrix2& matrix, double factor, double cosine, double sine) {
  matrix[0][0] += factor * cosine * cosine;
  matrix[0][1] += factor * cosine * sine;
  matrix[1][1] += factor * sine * sine;
  matrix[1][0] = matrix[0][1];
}

bool knows_damping(const RollerMotion& roller) {
  return roller.inner.damping_N_s_per_m && roller.outer.damping_N_s_per_m;
}

}  // namespace

ContactMotion contact_motion(const RacewayContact& contact, double force_N, double datum_m, double omega,
                             const Kappa& kappa) {
  const auto made = [&](const Spring& of) { return with_datum(contact, force_N, datum_m, omega, of); };
  const Spring film{kappa.stiffness, kappa.damping}, whole = made(film);
  const Spring error = change(made, film, kappa.stiffness_error, kappa.damping_error);
  return {.stiffness_N_per_m = whole.stiffness,
          .damping_N_s_per_m = whole.damping,
          .stiffness_error = error.stiffness,
          .damping_error = error.damping};
}

RingMotion ring_motion(const std::vector<RollerMotion>& rollers, double mass_kg, double omega) {
  RingMotion ring;
  Matrix2 damping = {};
  Spring sum, error;
  for (const RollerMotion& roller : rollers) {
    const Spring inner = spring_of(roller.inner), outer = spring_of(roller.outer);
    const auto by_inner = [&](const Spring& one) { return between_contacts(one, outer, mass_kg, omega); };
    const auto by_outer = [&](const Spring& one) { return between_contacts(inner, one, mass_kg, omega); };
    const Spring whole = by_inner(inner);
    const double cosine = cosine_of_degrees(roller.azimuth_deg), sine = sine_of_degrees(roller.azimuth_deg);
    add_along(ring.stiffness_N_per_m, whole.stiffness, cosine, sine);
    add_along(damping, whole.damping, cosine, sine);
    sum += whole;  // the trace of the matrices
    error += change(by_inner, inner, roller.inner.stiffness_error, roller.inner.damping_error);
    error += change(by_outer, outer, roller.outer.stiffness_error, roller.outer.damping_error);
  }
  ring.error = sum.stiffness != 0 ? error.stiffness / std::abs(sum.stiffness) : 0;
  if (!std::all_of(rollers.begin(), rollers.end(), knows_damping)) return ring;
  ring.damping_N_s_per_m = damping;
  ring.damping_error = sum.damping != 0 ? error.damping / std::abs(sum.damping) : 0;
  return ring;
}

}  // namespace ehd::bearing
