// SPDX-License-Identifier: GPL-3.0-or-later
// Newton's method with the full Jacobian, and the states that it starts from.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include "contact/interruption.hpp"
#include "contact/solution.hpp"
#include "reference/equations.hpp"

namespace ehd::reference {

/// What is left of the caller's limits.
struct Budget {
  int newton_iterations = 0;
  std::chrono::steady_clock::time_point end;
  /// Or the caller wants the solve to end.
  [[nodiscard]] bool spent() const {
    return newton_iterations <= 0 || std::chrono::steady_clock::now() >= end || interrupted();
  }
};

enum class NewtonEnd {
  solved,         ///< at the rounding floor, with P >= 0 and a film that opens at the exit
  no_solution,    ///< a root with negative pressure or a film that closes, or no root found
  limit_reached,  ///< iterations or time
};

struct NewtonResult {
  NewtonEnd end = NewtonEnd::no_solution;
  State state;
  Evaluation at;
  double iteration_error = 0;  ///< of the film, relative: last step x residual after it / residual before it
  int iterations = 0;
  long kernel_products = 0;  ///< film evaluations and Jacobians
  long viscosity_points = 0, density_points = 0;
  std::vector<double> residuals;  ///< relative, one an iterate; [0] is the start's
};

/// Full Newton steps, shortened where the state would change by too much.
[[nodiscard]] NewtonResult newton(const Equations& equations, const State& start, const Budget& budget);

/// The cubic through the four nodes about x; at least four nodes, increasing.
[[nodiscard]] double local_cubic(const Array& nodes, const Array& values, double x);

/// Hertz' pressure with its film lifted to `central_film`: the start for M above about 1.
[[nodiscard]] State hertz_start(const Equations& equations, double central_film, double exit);
/// Pressure of the rigid parabolic gap central_film + X^2/2 (Martin), scaled to the load: the start for light loads.
[[nodiscard]] State martin_start(const Equations& equations, double central_film);
/// A solution on another grid, by cubic interpolation; its central film is kept where interpolation would spoil it.
[[nodiscard]] State interpolated_start(const Equations& equations, const State& solved, const Evaluation& at);

}  // namespace ehd::reference
