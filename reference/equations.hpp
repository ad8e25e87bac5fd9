// SPDX-License-Identifier: GPL-3.0-or-later
// The discrete equations of the line contact on one monotone grid, and their exact Jacobian. README.md, section 1.
//
// Unknowns: P_1 … P_(n-1), H_0 and the exit X*; P_0 = P_n = 0. The nodes X_i = X* - s_i (X* - X_a) keep their
// fractions s_i while X* moves, so that the kernel is a matrix of the grid alone.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "contact/problem.hpp"
#include "reference/kernel.hpp"

namespace ehd::reference {

/// A monotone grid: where it begins, the fractions s_0 = 1 > … > s_n = 0 from exit to inlet, and the wedge's k on
/// the n faces (the first is not used).
struct Grid {
  double inlet = 0;
  Array fractions;
  Array kappa;
  [[nodiscard]] int intervals() const { return static_cast<int>(fractions.size()) - 1; }
  [[nodiscard]] Array nodes(double exit) const { return exit - fractions * (exit - inlet); }
};

/// Equal cells, k = 0 (Fromm).
[[nodiscard]] Grid uniform_grid(double inlet, int intervals);

struct State {
  Array P;            ///< n+1 nodes, P_0 = P_n = 0
  double offset = 0;  ///< H_0
  double exit = 0;    ///< X*
};

/// (e^-a - e^-b)/(b - a), the logarithmic mean of e^-a and e^-b, with its derivatives. Finite for a, b > -700.
struct LogarithmicMean {
  double value = 0;
  double by_a = 0;
  double by_b = 0;
};
[[nodiscard]] LogarithmicMean logarithmic_mean(double a, double b);

/// The logarithmic mean of 1/eta on the faces, and its derivatives to ln eta at the two nodes.
struct FaceFluidity {
  Array value, by_left, by_right;
};

/// Everything that the equations say about a state.
struct Evaluation {
  Array X, H;                   ///< nodes
  LawValues<double> viscosity;  ///< ln(eta/eta_0), nodes
  LawValues<double> density;    ///< rho/rho_0, nodes
  FaceFluidity mean_fluidity;
  Array gradient;                                 ///< (P_(i+1) - P_i)/(X_(i+1) - X_i), faces
  Array mobility;                                 ///< eps = rho H^3/(eta lambda), faces
  Array wedge;                                    ///< rho H, faces
  Array residual;                                 ///< n faces: eps P' - rho H + H_n; last: 2/pi Int P dX - 1
  Array rounding;                                 ///< what double precision may do to each residual
  Array deflection_by_exit;                       ///< dH_i/dX* at fixed P
  long viscosity_points = 0, density_points = 0;  ///< nodes at which a law was evaluated
  /// Largest residual, the fluxes relative to H_n.
  [[nodiscard]] double relative_residual() const;
};

class Equations {
 public:
  Equations(const Problem& problem, Grid grid);
  [[nodiscard]] const Grid& grid() const { return grid_; }
  /// H_i - H_0 = X_i^2/2 - (1/pi) Int P ln|X_i - X'| dX' (+ a source) at the nodes.
  [[nodiscard]] Array film_without_offset(const Array& P, double exit) const;
  [[nodiscard]] Evaluation evaluate(const State& state) const;
  /// d residual/d(P_1 … P_(n-1), H_0, X*), (n+1) x (n+1).
  [[nodiscard]] Eigen::MatrixXd jacobian(const State& state, const Evaluation& at) const;

 private:
  Viscosity viscosity_;
  Density density_;
  std::shared_ptr<const Sources> sources_;
  double lambda_;
  Grid grid_;
  Array weight_before_, weight_here_, weight_after_;  ///< of f_(i-1), f_i, f_(i+1) in the wedge, faces
  Array hats_;
  Eigen::MatrixXd kernel_;
};

}  // namespace ehd::reference
