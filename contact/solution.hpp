// SPDX-License-Identifier: GPL-3.0-or-later
// What a solver returns: fields on its finest grid, what was observed and with which error, and the record of how.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "contact/array.hpp"
#include "contact/problem.hpp"

namespace ehd {

/// Fields on the nodes X_0 < … < X_n, the last being the exit.
struct Fields {
  Array X, P, H;
  Array density;        ///< rho/rho_0 at the nodes
  Array log_viscosity;  ///< ln(eta/eta_0) at the nodes
  Array flux;           ///< rho H - rho H^3/(eta lambda) dP/dX on the n faces, as the scheme computes it
  double offset = 0;    ///< H_0
  /// Where polynomial elements begin, and where the last one ends: nodes elements[k] … elements[k+1] are the
  /// Gauss-Lobatto nodes of one polynomial. Empty for second-order schemes.
  std::vector<Eigen::Index> elements = {};
  Array weights = {};            ///< of the scheme's own Int … dX on the nodes; empty: the trapezoid rule in X
  double load_beyond_inlet = 0;  ///< Int P dX from -infinity to X_0 (an asymptotic tail), 0 without
  double work_beyond_inlet = 0;  ///< Int H dP/dX dX from -infinity to X_0, likewise
};

/// X, P and elements alone.
[[nodiscard]] inline Fields pressure_alone(const Fields& fields) {
  Fields alone;
  alone.X = fields.X;
  alone.P = fields.P;
  alone.elements = fields.elements;
  return alone;
}

/// One observed number. Errors are relative, for film.offset and approach absolute (Hertz units).
struct Reading {
  double value = 0;
  std::optional<double> place = {};  ///< X where it is found
  std::optional<double> error = {};  ///< estimated, all sources
};

/// Unknown and unwanted quantities are absent. Films and offset in Hertz units.
using Observables = std::map<Quantity, Reading>;

enum class StopReason {
  converged,
  tolerance_not_met,  ///< best solution, honest error
  under_resolved,     ///< the grid is too coarse for the inlet zone, or a film's stated error is 10 % or more
  limit_reached,      ///< iterations or time
  diverged,           ///< no film is reported
};
[[nodiscard]] std::string_view to_string(StopReason reason);  ///< "converged", "tolerance-not-met", …

/// Where a relative error comes from; the total is their sum.
struct ErrorBudget {
  double discretisation = 0;
  double iteration = 0;
  double truncation = 0;
  [[nodiscard]] double total() const { return discretisation + iteration + truncation; }
};

/// One grid that was solved on the way to the finest.
struct GridRecord {
  int nodes = 0;  ///< intervals, inlet to exit
  int newton_iterations = 0;
  double residual = 0;     ///< final; relative to H_n, of `fast` and `fast.uniform` to the oil at each face
  double inlet_cells = 0;  ///< cells in the inlet zone, which is l min(1, H)^(2/3) wide
  Observables observed;
};

/// What a solve cost. One work unit is one kernel product on the finest grid; a product on a coarser level counts by
/// its points over those of the finest.
struct Cost {
  double wall_s = 0;      ///< without FFT planning
  double planning_s = 0;  ///< FFT planning
  double work_units = 0;
  long convolutions = 0;  ///< kernel products on all levels
  long newton_iterations = 0;
  long krylov_iterations = 0;
  int nodes = 0;
  int levels = 0;
  long viscosity_points = 0;  ///< nodes at which a viscosity law needed an exponential or power
  long density_points = 0;    ///< nodes at which a density law was evaluated
  long fft_plans = 0;
  std::vector<std::pair<std::string, double>> stage_s = {};  ///< name, seconds: where wall_s went, where it is known
};

struct SolveRecord {
  StopReason status = StopReason::diverged;
  std::string reason;  ///< one sentence where status is not converged
  ErrorBudget film_minimum, film_central;
  Cost cost;
  std::vector<GridRecord> grids;  ///< coarse to fine
  std::vector<std::string> notes;
};

struct Solution {
  Fields fields;  ///< on the finest grid that was solved
  /// X, P and elements of other discretisations of the same contact. Most solvers keep the grid before the last one.
  /// `reference` keeps its second scheme, and a solution at a fluidity floor at least three times the last one.
  /// pressure_error() compares them with `fields`. Empty where there is only one discretisation.
  std::vector<Fields> beside = {};
  Observables observables;  ///< with errors; empty where status is diverged
  SolveRecord record;
};

}  // namespace ehd
