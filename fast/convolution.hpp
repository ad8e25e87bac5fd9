// SPDX-License-Identifier: GPL-3.0-or-later
// The logarithmic kernel on a uniform grid: a symmetric Toeplitz product by one pair of FFTs.
#pragma once

#include <memory>
#include <string>

#include "contact/array.hpp"

namespace ehd::fast {

/// Int hat(t) ln|k - t| dt for the hat function on [-1, 1], k >= 0: the exact weight of piecewise-linear pressure at a
/// node k spacings away. Second difference of G(u) = u^2 ln|u|/2 - 3u^2/4; beyond 24 spacings, where that difference
/// cancels, its asymptotic series (next term below 1e-17). On spacing h the weight is h g_k + h ln h: the matrix stays
/// Toeplitz when X* moves.
[[nodiscard]] double hat_moment(int k);

/// Int_0^1 (1 - s) ln(k + s) ds: the outer half of the hat at node 0, seen from node k >= 0.
[[nodiscard]] double half_hat_moment(int k);

/// Quadrature rule for the integral of a pressure times the logarithm.
enum class Rule {
  piecewise_linear,     ///< hat_moment: exact for piecewise linear pressures
  corrected_trapezoid,  ///< trapezoid_weight: fifth order for smooth ones
};

/// Weights of the trapezoid rule with zeta corrections at the singular point (Kapur & Rokhlin 1997):
/// Int g(s) ln|s_i - s| ds ~ h Sum_j g_j (w_|i-j| + ln h) with w_0 = -ln 2 pi + 2c, w_1 = -c, w_k = ln k, c =
/// zeta(3)/(4 pi^2).
[[nodiscard]] double trapezoid_weight(int k);

/// From now on FFTW measures the plans of this process. `wisdom`: FFTW's text of earlier measurements (measured_plans),
/// or empty. Measured plans may make two runs differ by rounding, so verification plans by estimate. False where the
/// text is not wisdom of this FFTW.
[[nodiscard]] bool measure_plans(const std::string& wisdom);
/// The wisdom of this process: plans that FFTW has measured, and those it was given.
[[nodiscard]] std::string measured_plans();

/// Throws std::bad_alloc where FFTW could not plan a forward and a backward transform of this length: FFTW itself ends
/// the process when it gets no memory. Call before planning.
void require_plan_memory(int length);

/// y_i = Sum_j g_|i-j| x_j for i, j = 0..n, where x_n = 0 (the exit). Holds its FFTW plans; not copyable, one thread
/// at a time. Plans are made with FFTW_ESTIMATE, so that two runs do the same arithmetic, unless measure_plans was
/// called.
class Convolution {
 public:
  explicit Convolution(int intervals, Rule rule = Rule::piecewise_linear);
  ~Convolution();
  Convolution(const Convolution&) = delete;
  Convolution& operator=(const Convolution&) = delete;

  /// Makes the plans, where they are not made yet. Weights need none.
  void plan();
  /// Sizes n + 1 both; x[n] is ignored. `y` may not alias `x`. Plans first.
  void apply(const Array& x, Array& y);

  [[nodiscard]] double weight(int k) const { return weights_[k]; }
  /// The weight of the inner half of node 0 (the first node's share), seen from node k: Int_0^1 (1 - s) ln|k - s| ds
  /// for the hat, half the weight for the trapezoid rule.
  [[nodiscard]] double inner_half_weight(int k) const { return inner_half_[k]; }
  [[nodiscard]] double planning_s() const { return planning_s_; }

 private:
  struct Plans;
  void make_factors();

  int intervals_;
  Array weights_;  ///< g_0..g_n
  Array inner_half_;
  Array same_, mirrored_;  ///< p_k and q_k of convolution.cpp, each twice; both hold 1/N
  std::unique_ptr<Plans> plans_;
  double planning_s_ = 0;
};

}  // namespace ehd::fast
