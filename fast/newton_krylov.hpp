// SPDX-License-Identifier: GPL-3.0-or-later
// Newton's method on one grid. Each step is solved for by flexible GMRES, with a multigrid cycle as right
// preconditioner, only as exactly as the target needs (inexact Newton).
#pragma once

#include <chrono>
#include <limits>

#include "contact/interruption.hpp"

namespace ehd::fast {

struct Counters;
struct Setting;
struct State;
struct Workspace;

/// What bounds a solve.
struct Limits {
  long newton_iterations = 2000;
  std::chrono::steady_clock::time_point deadline;
  /// The deadline has passed, or the caller wants the solve to end.
  [[nodiscard]] bool time_is_up() const { return std::chrono::steady_clock::now() > deadline || interrupted(); }
};

/// `stalled`: no further decrease, residual small but above the target. `failed`: the same at a large residual, or no
/// positive film. `limit`: Limits were reached.
enum class NewtonEnd { converged, stalled, failed, limit };

/// When Newton is done: the residual is at most `residual` (or near its rounding floor), or the estimated film error is
/// below `film_error` and the residual at most `film_residual`. In both cases the flux also varies by at most
/// `flux_variation`.
struct Target {
  double residual = 0;
  double film_error = 0;
  double film_residual = 1e-2;
  double flux_variation = std::numeric_limits<double>::infinity();
};

/// The same bound for the residual in units of the oil (Discretisation::oil) and in units of rho_n H_n.
[[nodiscard]] constexpr Target everywhere(double residual) {
  return {.residual = residual, .flux_variation = residual};
}

struct NewtonResult {
  NewtonEnd end = NewtonEnd::failed;
  int iterations = 0;
  double residual = 0;  ///< Discretisation::residual() or the relative load error, whichever is larger
  /// What iteration left in H_min and H_cen, relative, estimated; infinite where nothing is known.
  double film_error = std::numeric_limits<double>::infinity();
};

/// Improves `state` until the target is met. On return workspace.now() holds the fields of `state`.
[[nodiscard]] NewtonResult newton(const Setting& setting, State& state, const Target& target, int most_iterations,
                                  const Limits& limits, Workspace& workspace, Counters& counters);

}  // namespace ehd::fast
