// SPDX-License-Identifier: GPL-3.0-or-later
// Newton's method on the collocation equations of one mesh, and where it starts.
#pragma once

#include <chrono>
#include <limits>

#include "contact/interruption.hpp"
#include "reference/hp/collocation.hpp"

namespace ehd::reference::hp {

/// The part of the caller's limits that is left, and the work that is done.
struct Meter {
  long iterations_left = 0;
  std::chrono::steady_clock::time_point end;
  int iterations = 0;
  long kernel_products = 0;   ///< film evaluations and Jacobians
  double point_products = 0;  ///< the same, times their intervals
  long viscosity_points = 0, density_points = 0;
  /// Or the caller wants the solve to end.
  [[nodiscard]] bool spent() const {
    return iterations_left <= 0 || std::chrono::steady_clock::now() >= end || interrupted();
  }
};
/// The limits of a request that began at `begin`. Its iterations are those of meshes with a thousand nodes; most meshes
/// here have a hundred, so that ten times as many are allowed.
[[nodiscard]] Meter meter_of(int max_iterations, double time_limit_s, std::chrono::steady_clock::time_point begin);

struct NewtonLimits {
  int iterations = 25;
  int patience = 12;    ///< it gives up after so many iterations without a new smallest residual
  double step = 1e-10;  ///< relative change of flux, offset and exit at which it ends
};

struct NewtonRun {
  bool solved = false;
  State<double> state;
  Evaluation<double> at;
  int iterations = 0;
  double residual = std::numeric_limits<double>::quiet_NaN();  ///< largest, each in units of its scale
  double iteration_error = 0;  ///< relative change of the flux that a further step would make
};

/// Steps with the exact Jacobian, halved where the film would close or the residual explode.
[[nodiscard]] NewtonRun newton(const Collocation<double>& equations, const State<double>& start, double floor,
                               const NewtonLimits& limits, Meter& meter);

/// Hertz' pressure, scaled to the load, with the offset that makes the smallest film `film`.
[[nodiscard]] State<double> hertz_start(const Collocation<double>& equations, double exit, double film);
/// Pressure of the rigid parabolic gap film + X^2/2, scaled to the load: light loads.
[[nodiscard]] State<double> martin_start(const Collocation<double>& equations, double exit, double film);
/// The state on another mesh of the same domain, or of one that is cut from it, by the polynomials of its elements.
[[nodiscard]] State<double> transferred(const Collocation<double>& from, const State<double>& state,
                                        const Collocation<double>& to);

}  // namespace ehd::reference::hp
