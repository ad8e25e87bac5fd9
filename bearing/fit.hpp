// SPDX-License-Identifier: GPL-3.0-or-later
// The reduced-order law of the paper: a straight line f = K delta + dF through solved contacts.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "bearing/fit_of.hpp"
#include "bearing/force_law.hpp"
#include "bearing/solved_contacts.hpp"

namespace ehd::bearing {

struct FitPoint {
  double force_N = 0;
  double approach_m = 0;
  double approach_error_m = 0;  ///< of the offset film, as the solver states it
  bool converged = true;        ///< of the contact: false where it missed its tolerance
};

/// A line that misses a contact by more than this part of the heaviest force does not describe its contacts. That holds
/// for the points of its fit and for the contacts of a bearing that uses it. Elastic contacts are missed by 0.02 at
/// most, rigid rollers with f ~ 1/film by 0.2 (200 random bearings; NA4908 0.01).
inline constexpr double largest_misfit = 0.05;

/// The loaded contacts of a bearing that uses a line (is_loaded). Where the same run balanced the law ehd too, also the
/// contacts that are loaded by ehd and carry nothing by the line; their force is that by ehd.
struct LineInUse {
  double lightest_N = 0, heaviest_N = 0;
  /// The largest difference, over these contacts, of the force by the line and the force by the solver at the same
  /// approach. NaN where the solver's force is not known.
  double residual_N = 0;
  [[nodiscard]] double misfit() const { return residual_N / heaviest_N; }
};

struct LinearFit {
  double K_N_per_m = 0;
  double dF_N = 0;
  double residual_N = 0;            ///< largest |f - (K delta + dF)| of the points
  double standard_deviation_N = 0;  ///< of f about the line, points - 2 degrees of freedom; 0 for two points
  double K_deviation_N_per_m = 0;   ///< standard deviations from the covariance of the fit
  double dF_deviation_N = 0;
  double correlation = 0;  ///< of K and dF
  std::vector<FitPoint> points;
  FitOf of = FitOf::force;
  std::optional<LineInUse> in_use = {};  ///< absent where no bearing loads a contact by this line

  /// First-order bound of the line's error of the approach at a force [m], from the points' approach_error_m with any
  /// signs.
  [[nodiscard]] double approach_error_m(double force_N) const;

  /// residual_N over the heaviest force of the points.
  [[nodiscard]] double misfit() const { return residual_N / points.back().force_N; }
  /// The line describes the contacts of its fit, and those of the bearing that uses it.
  [[nodiscard]] bool describes_contacts() const {
    return misfit() <= largest_misfit && (!in_use || in_use->misfit() <= largest_misfit);
  }

  [[nodiscard]] LinearLaw law(Unloading unloading = Unloading::at_zero_force) const;
};

/// Unweighted least squares (GSL). Throws std::invalid_argument for fewer than two points, equal approaches or forces,
/// or a slope that is not positive. Deviations of K and dF of a fit of delta on f are of first order.
[[nodiscard]] LinearFit fit_line(const std::vector<FitPoint>& points, FitOf of = FitOf::force);

/// The contact forces of a fit [N]: `points` equally spaced ones from `lowest_N` to `highest_N`.
[[nodiscard]] std::vector<double> fit_forces_N(double lowest_N, double highest_N, int points);

/// A line through these contacts; each is solved, or remembered, and a failure names its force.
[[nodiscard]] std::variant<LinearFit, SolveFailure> fit_contacts(const SolvableContact& contacts, double datum_m,
                                                                 double lowest_N, double highest_N, int points,
                                                                 FitOf of = FitOf::force);

}  // namespace ehd::bearing
