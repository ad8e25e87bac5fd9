// SPDX-License-Identifier: GPL-3.0-or-later
// Static equilibrium of a roller bearing under a radial load, rollers eliminated:
//   f_o - f_i - F_c = 0 on each roller,  delta_o + delta_i = x cos psi + y sin psi - P_d/2,
//   Sum f_i cos psi = F_r,  Sum f_i sin psi = 0.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "bearing/force_law.hpp"
#include "bearing/geometry.hpp"

namespace ehd::bearing {

/// What the ring may do. The two agree where the cage stands symmetric to the load.
enum class Form {
  plane,  ///< it moves along the load (x) and across it (y): any cage position is balanced
  radial  ///< it moves along the load only, y = 0; the force across it that this needs is reported, not balanced
};
[[nodiscard]] std::string_view to_string(Form form);  ///< "plane", "radial"

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

/// Where the ring stands, to more digits than its displacement has: at light load and wide clearance the approach is
/// 1e-9 m beside 1e-4 m. The displacement is that at which two directions just touch, and `beyond` it.
struct Position {
  /// The azimuths at which a roller would just touch, x cos a + y sin a - P_d/2 = approach at which a roller begins to
  /// carry, and likewise b; absent where the position counts from the middle.
  std::optional<std::pair<double, double>> touching_deg;
  double beyond_x_m = 0, beyond_y_m = 0;
};

struct Equilibrium {
  double displacement_m = 0;          ///< x, along the load
  double lateral_displacement_m = 0;  ///< y, towards psi = 90 degrees; exactly 0 in the radial form and by symmetry
  Position position;
  std::vector<double> azimuths_deg;
  std::vector<RollerState> rollers;
  /// Of the ring (both components in the plane form) and of every roller, relative to the larger of F_r and the sum of
  /// the outer contacts' forces, which are the larger ones.
  double balance_error = 0;
  double lateral_force_N = 0;  ///< Sum f_i sin psi
  /// d(Sum f_i cos psi, Sum f_i sin psi)/d(x, y), from the rollers' exact slopes; symmetric.
  std::array<std::array<double, 2>, 2> stiffness_N_per_m = {};
  int newton_iterations = 0;  ///< positions of the ring at which the rollers were balanced
  long rollers_balanced = 0;  ///< groups of rollers times iterations
  int groups = 0;             ///< rollers that are balanced; fewer than all where mirrored ones are one
};

/// Why there is no balance; a sentence.
struct NoEquilibrium {
  std::string why;
};

/// What a balance must meet to be returned at all.
inline constexpr double largest_balance_error = 1e-12;

/// Newton's method with exact derivatives. The energy of increasing laws is convex, so that the force along any line is
/// increasing: along the load (radial form) its zero is kept in a bracket, in the plane every step ends where the force
/// along it has at least halved. A plane form whose cage is symmetric to the load is the radial one. No balance:
/// a load that no roller can carry, a law used beyond its domain (LogarithmicLaw), and a law that is cut at delta = 0
/// (Unloading::at_zero_approach) under an asymmetric cage in the plane form where rollers stand on the jump.
[[nodiscard]] std::variant<Equilibrium, NoEquilibrium> balance(const Geometry& geometry, const LawPair& laws,
                                                               const Loading& loading, Form form = Form::plane);

/// A film unloads no roller: far from the load it carries some per mille to some per cent of the largest force. Rollers
/// of a law with films count as loaded from this part of the largest inner contact force on.
inline constexpr double load_zone_share = 0.01;
/// From the smallest to the largest azimuth of the rollers that carry something, and at least `share` of the largest
/// inner contact force; absent where nothing is loaded.
[[nodiscard]] std::optional<std::pair<double, double>> load_zone_deg(const Equilibrium& equilibrium, double share = 0);

}  // namespace ehd::bearing
