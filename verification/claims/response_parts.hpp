// SPDX-License-Identifier: GPL-3.0-or-later
// What the claims about the harmonic response share.
#pragma once

#include <complex>
#include <string>
#include <utility>

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "reference/hp/response.hpp"
#include "verification/claims/shared.hpp"

namespace ehd::verification {

/// The oil of these claims: Roelands z = 0.68, alpha = 2.2e-8 1/Pa, p_0 = 1.96e8 Pa, Dowson-Higginson.
inline constexpr Lubricant response_oil{.viscosity = ViscosityLaw::roelands,
                                        .density = DensityLaw::dowson_higginson,
                                        .alpha_per_Pa = 2.2e-8,
                                        .z = 0.68,
                                        .p0_Pa = 1.96e8};
inline const Inlet cut_at_4 = TruncatedAt{-4};

[[nodiscard]] inline Problem response_problem(MoesGroups moes, const Inlet& inlet,
                                              const Lubricant& oil = response_oil) {
  return nondimensionalise(moes, oil, inlet).problem;
}

[[nodiscard]] inline Response certified_response(const Problem& problem, const ResponseRequest& request) {
  return reference::hp::response(problem, request);
}

[[nodiscard]] inline Sentence response_says(const std::string& id, int rung, std::string statement) {
  return {.id = "response/" + id, .rung = rung, .statement = std::move(statement), .solver = "reference"};
}

/// NaN where they are not within the tolerance.
[[nodiscard]] inline std::complex<double> known_kappa(const Stiffness& at) {
  return at.status == StopReason::converged ? at.kappa : std::complex<double>(nothing);
}
[[nodiscard]] inline std::complex<double> known_film(const WavinessResponse& at) {
  return at.status == StopReason::converged ? at.film : std::complex<double>(nothing);
}

[[nodiscard]] inline std::string contact_name(MoesGroups moes, const Inlet& inlet) {
  return plain(moes.M) + "-" + plain(moes.L) + (std::holds_alternative<Flooded>(inlet) ? "/flooded" : "/cut");
}

/// Order of errors at steps that differ by `ratio`.
[[nodiscard]] inline double observed_order(double coarse, double fine, double ratio) {
  return std::log(coarse / fine) / std::log(ratio);
}

}  // namespace ehd::verification
