// SPDX-License-Identifier: GPL-3.0-or-later
// The contact in time, step by step: the full nonlinear equations of problem.hpp with squeeze, by finite volumes and
// BDF2, both of second order. It shares no line and no idea of discretisation with the harmonic response, and is slow.
//
// Cells between the middles of equal intervals of [X_a, X*(T)] move with the exit. For f = rho H and a cell (a, b)
//   d/dT Int_a^b f dX = [ rho H^3/(eta lambda) P' - f + f dX/dT ]_a^b.
// The last cell ends at the exit, where P = P' = 0. From rest, either the bodies move, H_0(T) = offset (1 + amplitude
// sin(Omega T)), or a waviness R = amplitude cos(k X - Omega T) rolls through at the load of rest, and H_0 follows.
#pragma once

#include <complex>
#include <vector>

#include "contact/problem.hpp"
#include "contact/response.hpp"
#include "contact/solution.hpp"

namespace ehd::verification::exact {

struct TimeSteps {
  double Omega = 1;
  double amplitude = 1e-3;  ///< of H_0, in units of |H_0|
  int intervals = 64;       ///< of the grid
  int steps = 64;           ///< a period
  int periods = 4;          ///< the last one is read
};

struct MotionInTime {
  std::complex<double> kappa;  ///< -W_1/H_01
  double film = 0;             ///< amplitude of the film at X = 0 over its mean
};

/// From the first Fourier coefficients of load and film over the last period; NaN where an iteration fails.
/// Measured: 64 intervals with steps below 0.015 end in NaN (a mode of the coarse grid grows); 128 intervals with 0.004
/// do not. `start` is a steady solution of the problem, whose inlet is cut: it gives the offset and the first guess.
[[nodiscard]] MotionInTime motion_by_time_steps(const Problem& problem, const Fields& start, const TimeSteps& request);

struct WavinessSteps {
  Waviness waviness;        ///< slip above 0
  double amplitude = 1e-3;  ///< of the film at X = 0
  int intervals = 64;       ///< of the grid
  int steps = 64;           ///< a period
  int periods = 6;          ///< in the first one the waviness grows, the last one is read
};

/// H_1(0) for R_1(0) = 1, from the first Fourier coefficient of the film over the last period; NaN likewise.
[[nodiscard]] std::complex<double> film_by_time_steps(const Problem& problem, const Fields& start,
                                                      const WavinessSteps& request);

}  // namespace ehd::verification::exact
