// SPDX-License-Identifier: GPL-3.0-or-later
// Reynolds' equation, film and load on a grid X_i = X_a + l phi_i, l = X* - X_a, phi_i = phi(i/n), and their linearisation.
//
//   H_i = H_0 + X_i^2/2 - (l/pi) (Sum_j K_ij P_j + ln l Int P dphi) (+ deflection by the far inlet)
//   face i between nodes i and i + 1:  F_i = f_(i+1/2) - eps_i (P_(i+1) - P_i)/(X_(i+1) - X_i),  f = rho H
//     eps_i = rho_f H_f^3 m/lambda, rho_f and H_f the means of the nodes, m the logarithmic mean of 1/eta
//     f_(i+1/2) = f_i + [(1 + k_i)(f_(i+1) - f_i) + (1 - k_i)(f_i - f_(i-1))]/4, on the first face the mean
//   flux error e_i = F_i - rho_n H_n for i = 0..n-1 (P = P' = 0 at the exit);  load l Int P dphi - pi/2.
//
// Unknowns P_1..P_(n-1), H_0, X*: as many as equations. Every array is owned by the caller's workspace.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <string_view>
#include <utility>

#include "contact/array.hpp"
#include "contact/problem.hpp"
#include "contact/rheology.hpp"
#include "fast/grid.hpp"
#include "fast/inlet_tail.hpp"

namespace ehd::fast {

/// The iterate. P has n + 1 entries; P_0 is the inlet's (0, or the tail's), P_n = 0.
struct State {
  Array P;
  double offset = 0;  ///< H_0
  double exit = 1;    ///< X*
  InletTail tail;     ///< flooded: held while Newton runs, refreshed between steps (see newton)
};

/// What a solve is about, apart from the iterate.
struct Setting {
  Groups groups;
  Viscosity viscosity;
  Density density;
  double inlet = -4;        ///< X_a
  bool with_tail = false;   ///< flooded: the asymptotic inlet beyond X_a
  double fluidity_floor = 0;  ///< added to the mean of 1/eta at each face: a homotopy parameter, 0 in every solution
  std::shared_ptr<const Sources> sources = {};  ///< of a manufactured solution; empty in the physics
};

/// A correction; P has n + 1 entries with zero ends.
struct Step {
  Array P;
  double offset = 0;
  double exit = 0;
  Array product = {};   ///< K P and Int P dphi, made by Discretisation::apply
  double integral = 0;
};

/// Where the time goes. `other`: starts, interpolation, line search, observation.
enum class Stage { product, laws, residual, linearise, factorise, smooth, coarsest, krylov, grids, other };
inline constexpr std::string_view stage_names[] = {"kernel products", "laws", "residual", "linearisation", "factorisation",
                                                   "smoothing and transfer", "coarsest grid", "orthogonalisation",
                                                   "maps and tables", "other"};

/// A stop watch that belongs to one stage at a time; 30 ns a change.
class StageClock {
 public:
  using Clock = std::chrono::steady_clock;
  /// What ran until now belongs to the stage before, which is returned.
  Stage change_to(Stage next) {
    const auto now = Clock::now();
    seconds_[static_cast<std::size_t>(stage_)] += std::chrono::duration<double>(now - since_).count();
    since_ = now;
    return std::exchange(stage_, next);
  }
  [[nodiscard]] double seconds(Stage stage) const { return seconds_[static_cast<std::size_t>(stage)]; }

 private:
  Stage stage_ = Stage::other;
  Clock::time_point since_ = Clock::now();
  std::array<double, std::size(stage_names)> seconds_ = {};
};

/// Counts that a solve reports.
struct Counters {
  StageClock clock;
  long convolutions = 0;
  double convolution_points = 0;  ///< Sum of intervals over all kernel products
  long newton = 0;
  long krylov = 0;
  long viscosity_points = 0;
  long density_points = 0;
};

/// Within its scope, time belongs to `stage`.
class InStage {
 public:
  InStage(Counters& counters, Stage stage) : clock_(counters.clock), before_(clock_.change_to(stage)) {}
  ~InStage() { clock_.change_to(before_); }
  InStage(const InStage&) = delete;
  InStage& operator=(const InStage&) = delete;

 private:
  StageClock& clock_;
  Stage before_;
};

/// Fields, residual and linearisation at one iterate.
struct Discretisation {
  int n = 0;
  const Grid* grid = nullptr;
  double length = 0;  ///< l = X* - X_a

  // Nodes, n + 1.
  Array product;     ///< K P over the inner nodes
  double product_integral = 0;  ///< Int P dphi over the inner nodes
  Array deflection;  ///< Int P ln|X_i - X'| dX' over the grid
  double integral = 0;  ///< Int P dphi
  Array H;
  LawValues<double> log_viscosity, density;
  Array fluidity;  ///< 1/eta

  // Faces, n.
  Array eps;   ///< rho H^3/(eta lambda)
  Array flux;  ///< F_i
  Array e;     ///< F_i - rho_n H_n
  double load_error = 0;  ///< Int P dX + tail - pi/2
  double floor = 0;       ///< rounding floor of max|e|/(rho_n H_n)

  // Linearisation: dF_i = Sum_{j = i-1..i+1} (p_ij dP_j + w_ij dH_j) + x_i dX*, dH/dX* at fixed P.
  Array p_left, p_mid, p_right, w_left, w_mid, w_right, by_exit;
  Array film_by_exit;
  double load_by_exit = 0;

  /// Fields and residual. False where the film is not positive or a number is not finite; then only H is meaningful.
  [[nodiscard]] bool evaluate(const Setting& setting, State& state, Grid& on, Counters& counters);
  /// The same where `product` and `product_integral` are those of the state's pressure already.
  [[nodiscard]] bool evaluate_with_product(const Setting& setting, State& state, Grid& on, Counters& counters);
  /// The tail that belongs to the present fields.
  [[nodiscard]] InletTail tail_of(const Setting& setting, const State& state) const;
  /// The same laws and fields taken from the nodes of a grid with twice the intervals (or, for an odd number, by
  /// linear interpolation): what a coarse level needs to linearise.
  void inject(const Discretisation& fine, const Array& fine_pressure, Array& pressure, const Grid& on);
  /// X_i.
  [[nodiscard]] Array places(double inlet) const { return inlet + length * grid->place; }
  /// A node next to X = 0.
  [[nodiscard]] Eigen::Index centre(double inlet) const {
    return std::min<Eigen::Index>(std::lower_bound(grid->place.begin(), grid->place.end(), -inlet / length) -
                                      grid->place.begin(), n);
  }
  /// Coefficients of the linearisation at the present fields.
  void linearise(const Setting& setting, const Array& P, double exit);
  /// e' = J step, n entries, and the change of the load; makes step.product and step.integral.
  void apply(Step& step, Grid& on, Counters& counters, Array& change, double& load_change) const;

  [[nodiscard]] double exit_flux() const { return density.value[n] * H[n]; }
  /// max|e|/(rho_n H_n).
  [[nodiscard]] double residual() const { return e.abs().maxCoeff() / std::abs(exit_flux()); }

 private:
  mutable Array film_change_;
  double tail_[5] = {};  ///< deflection by the far inlet, of the state evaluated last
};

}  // namespace ehd::fast
