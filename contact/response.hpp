// SPDX-License-Identifier: GPL-3.0-or-later
// The linear response of the film contact about its steady state: what a caller asks for and what a solver answers.
//
// Hertz scaling as in problem.hpp, and T = t u_m/b, Omega = omega b/u_m with the mean speed u_m = u_s/2. All
// oscillating numbers are amplitudes of e^(i Omega T). To first order in the amplitude
//   d/dX [rho H^3/(eta lambda) P' - rho H]_1 = i Omega (rho H)_1,
//   H_1 = H_01 + R_1(X) - (1/pi) Int P_1(X') ln|X - X'| dX'.
// Moving bodies: R_1 = 0 and H_01, the change of the offset, drives; kappa = -W_1/H_01, W_1 = Int P_1 dX.
// Waviness: R_1 = e^(-2 pi i X/wavelength) drives, at a constant load, W_1 = 0.
#pragma once

#include <complex>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/solution.hpp"

namespace ehd {

/// A harmonic surface feature of amplitude 1 that moves through the contact.
struct Waviness {
  double wavelength = 0;  ///< in b
  /// s: the feature moves at s u_m. 1: pure rolling; 0: the feature is at rest; 2: the other surface is at rest.
  double slip = 1;
  [[nodiscard]] double wavenumber() const { return 2 * std::numbers::pi / wavelength; }
  [[nodiscard]] double Omega() const { return slip * wavenumber(); }
  bool operator==(const Waviness&) const = default;
};

struct ResponseRequest {
  std::vector<double> frequencies = {};  ///< Omega >= 0
  std::vector<Waviness> waviness = {};
  double tolerance = 1e-8;  ///< relative, of kappa and of the amplitude ratio
  int max_iterations = 2000;
  double time_limit_s = 300;
  bool seeks_highest = true;  ///< without it Response::highest_certified is absent
  /// Called after the steady state, and after each frequency and wave: how many of them are done.
  std::function<void(std::size_t done, std::size_t all)> progress = {};
  void tell(std::size_t done) const {
    if (progress) progress(done, frequencies.size() + waviness.size());
  }
};

/// The error of a number that was not computed.
inline constexpr double unknown_error = std::numeric_limits<double>::infinity();

/// kappa at one frequency.
struct Stiffness {
  double Omega = 0;
  std::complex<double> kappa = {};
  double error = unknown_error;  ///< of kappa, relative to |kappa|
  double lag_error = 0;          ///< of the lag, relative; nothing at Omega = 0
  StopReason status = StopReason::diverged;
  /// -Im(1/kappa)/Omega
  [[nodiscard]] double lag() const { return kappa.imag() / Omega / std::norm(kappa); }
};

/// kappa = kappa_0 + i Omega kappa_1 + O(Omega^2): stiffness and damping of slow motion.
struct SlowStiffness {
  double kappa_0 = 0, kappa_1 = 0;
  double error_0 = 0, error_1 = 0;  ///< relative
  double lag = 0, lag_error = 0;    ///< kappa_1/kappa_0^2, and its relative error
};

/// kappa = stiffness + i Omega damping with some datum. Errors are absolute, in the same units.
struct Kappa {
  double stiffness = 0, damping = 0;
  double stiffness_error = 0, damping_error = 0;
};

/// kappa with a compliance in series: 1/kappa + compliance = 1/kappa_0 + compliance - i Omega lag. Where the compliance
/// is large, the damping lag kappa^2 is known as well as the lag, which a solver knows better than kappa_1.
[[nodiscard]] Kappa in_series(const Stiffness& at, double compliance);
/// The same for slow motion.
[[nodiscard]] Kappa in_series(const SlowStiffness& slow, double compliance);

/// What the contact leaves of a waviness: H_1(0) for R_1(0) = 1.
struct WavinessResponse {
  Waviness waviness;
  std::complex<double> film = {};  ///< H_1 at X = 0
  double error = unknown_error;    ///< of it, relative to |H_1(0)|
  StopReason status = StopReason::diverged;
  [[nodiscard]] double amplitude_ratio() const { return std::abs(film); }
  [[nodiscard]] double phase_deg() const { return std::arg(film) * 180 / std::numbers::pi; }
};

struct Response {
  StopReason status = StopReason::diverged;  ///< converged where every number is within the tolerance
  std::string reason = {};                   ///< one sentence where it is not
  std::optional<SlowStiffness> slow = {};
  std::vector<Stiffness> frequencies = {};      ///< in the order of the request
  std::vector<WavinessResponse> waviness = {};  ///< in the order of the request
  /// kappa is known within the tolerance at this Omega, and up to it wherever it was tried. Where kappa is known at all
  /// requested Omega, it is the highest of these. Else it is searched for, and at most 7 % below the lowest Omega at
  /// which kappa was found unknown. Absent where not even kappa_0 is known.
  std::optional<double> highest_certified = {};
  Cost cost = {};
  std::vector<std::string> notes = {};
};

/// `found` answers the request with nothing: every number is unknown, for this reason.
void answer_nothing(Response& found, const ResponseRequest& request, StopReason status, std::string_view why);

/// Sets highest_certified. Where kappa is not known at every requested Omega, `certified` tells by solving whether it
/// is known at another one: at `resolved_up_to`, beyond which kappa is never known, then by bisection below the lowest
/// Omega that failed, until `spent`.
void find_highest_certified(Response& found, double tolerance, const std::function<bool(double Omega)>& certified,
                            const std::function<bool()>& spent, double resolved_up_to = unknown_error);

/// Sets status and reason. `why` is the reason where a number is not within the tolerance.
void conclude(Response& found, double tolerance, bool spent, std::string_view why);

}  // namespace ehd
