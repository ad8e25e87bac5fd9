// SPDX-License-Identifier: GPL-3.0-or-later
// Static equilibrium of a roller bearing under a radial load, rollers eliminated:
//   f_o - f_i - F_c = 0 on each roller,  delta_o + delta_i = delta_r cos psi - P_d/2,  Sum f_i cos psi = F_r.
// Radial form: the ring moves along the load only. Where the cage position is not symmetric to the load line, the
// lateral force Sum f_i sin psi that this needs is reported, not balanced.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "bearing/force_law.hpp"
#include "bearing/geometry.hpp"

namespace ehd::bearing {

/// The laws at the two contacts of every roller.
struct LawPair {
  ForceLaw inner, outer;
};

struct ContactState {
  double force_N = 0;
  double approach_m = 0;  ///< negative where there is a gap (or a film thicker than the approach)
};

/// One roller between its raceways at a given total approach.
struct RollerState {
  ContactState inner, outer;
  double stiffness_N_per_m = 0;  ///< d f_i/d(delta_i + delta_o), 0 where the inner contact is unloaded
  bool at_jump = false;          ///< on the vertical part of a law that lets go at a finite force
};

/// Splits the total approach delta_i + delta_o of one roller so that f_o = f_i + F_c. An unloaded inner contact leaves
/// the roller on the outer ring, f_o = F_c. `guess_N`: a start for f_i, 0 for none.
[[nodiscard]] RollerState balance_roller(const LawPair& laws, double centrifugal_N, double total_approach_m,
                                         double guess_N = 0);

struct Loading {
  double radial_N = 0;
  double centrifugal_N = 0;  ///< on each roller
};

struct Equilibrium {
  double displacement_m = 0;  ///< delta_r, along the load
  std::vector<double> azimuths_deg;
  std::vector<RollerState> rollers;
  double balance_error = 0;    ///< of ring and rollers, relative to the larger of F_r and the sum of roller forces
  double lateral_force_N = 0;  ///< Sum f_i sin psi
  int newton_iterations = 0;
  long rollers_balanced = 0;  ///< calls of balance_roller: groups of mirrored rollers times iterations
  int groups = 0;             ///< rollers that are not the mirror image of another
};

/// Why there is no balance; a sentence.
struct NoEquilibrium {
  std::string why;
};

/// What a balance must meet to be returned at all.
inline constexpr double largest_balance_error = 1e-10;

/// Newton-Raphson on the approach of the most loaded roller, with exact derivatives, kept in a bracket.
[[nodiscard]] std::variant<Equilibrium, NoEquilibrium> balance(const Geometry& geometry, const LawPair& laws,
                                                               const Loading& loading);

}  // namespace ehd::bearing
