// SPDX-License-Identifier: GPL-3.0-or-later
// What the claims about the harmonic response share.
#pragma once

#include <fmt/format.h>

#include <complex>
#include <numbers>
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

/// H_0 and M dH_0/dM at fixed L and fixed inlet in metres, by differences of sixth order in ln M; uncertainty: of both.
struct OffsetSlope {
  double offset = 0, slope = 0, uncertainty = 0;
  /// With w in the unit of one load, b^2 ~ w and delta = -(b^2/R)(H_0 + ln(b)/2): dW/dH_0 in Hertz units of the load.
  [[nodiscard]] double kappa() const { return std::numbers::pi / (-0.5 - 2 * offset - 2 * slope); }
};
/// Of steady solves to this tolerance.
[[nodiscard]] OffsetSlope offset_slope(MoesGroups moes, const Inlet& inlet, const std::string& solver,
                                       double tolerance);

/// NaN where they are not within the tolerance.
[[nodiscard]] inline std::complex<double> known_kappa(const Stiffness& at) {
  return at.status == StopReason::converged ? at.kappa : std::complex<double>(nothing);
}
[[nodiscard]] inline std::complex<double> known_film(const WavinessResponse& at) {
  return at.status == StopReason::converged ? at.film : std::complex<double>(nothing);
}

[[nodiscard]] inline std::string contact_name(MoesGroups moes, const Inlet& inlet) {
  return fmt::format("{}-{}{}", plain(moes.M), plain(moes.L),
                     std::holds_alternative<Flooded>(inlet) ? "/flooded" : "/cut");
}

/// Order of errors at steps that differ by `ratio`.
[[nodiscard]] inline double observed_order(double coarse, double fine, double ratio) {
  return std::log(coarse / fine) / std::log(ratio);
}

}  // namespace ehd::verification
