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
#include "bearing/ring.hpp"
#include "bearing/roller.hpp"

namespace ehd::bearing {

[[nodiscard]] std::string_view to_string(Form form);  ///< "plane", "radial"

/// Where the ring stands. A displacement alone has too few digits: at light load and wide clearance the approach is
/// 1e-9 m beside a displacement of 1e-4 m. So it has two parts: to the place where rollers at two azimuths just touch,
/// and from there the small `beyond`.
struct Position {
  /// The azimuths a and b: with the ring at the first part, rollers at a and b just touch. At a, the approach
  /// x cos a + y sin a - P_d/2 is then that at which a roller begins to carry, and likewise at b. Absent: `beyond`
  /// counts from the middle.
  std::optional<std::pair<double, double>> touching_deg;
  double beyond_x_m = 0, beyond_y_m = 0;
};

struct Equilibrium {
  double displacement_m = 0;          ///< x, along the load
  double lateral_displacement_m = 0;  ///< y, towards psi = 90 degrees; exactly 0 in the radial form and by symmetry
  Position position;
  std::vector<double> azimuths_deg;
  std::vector<RollerState> rollers;
  /// Largest error of balance of the ring (both components in the plane form) and of every roller, relative to the
  /// larger of F_r and the sum of the outer contacts' forces.
  double balance_error = 0;
  double lateral_force_N = 0;  ///< Sum f_i sin psi
  /// d(Sum f_i cos psi, Sum f_i sin psi)/d(x, y), from the rollers' exact slopes; symmetric.
  std::array<std::array<double, 2>, 2> stiffness_N_per_m = {};
  int newton_iterations = 0;  ///< positions of the ring at which the rollers were balanced
  long rollers_balanced = 0;  ///< groups of rollers times iterations
  int groups = 0;             ///< rollers that are balanced; fewer than all where mirrored rollers are one group
};

/// Why there is no balance; a sentence.
struct NoEquilibrium {
  std::string why;
};

/// Newton's method with exact derivatives (ring_search.hpp). Three or more equally spaced rollers always have two less
/// than a half turn apart with the load between them, so in the plane form there is a balance. Without a load the ring
/// stays in the middle, where equal rollers hold it. With a cage symmetric to the load both forms agree. There is no
/// balance in three cases:
/// 1. no roller can carry the load;
/// 2. a law is used where it is refused (force_law.hpp);
/// 3. a law is cut at delta = 0 (Unloading::at_zero_approach), the cage is asymmetric, the form is the plane one, and
///    rollers stand on the jump.
[[nodiscard]] std::variant<Equilibrium, NoEquilibrium> balance(const Geometry& geometry, const LawPair& laws,
                                                               const Loading& loading, Form form = Form::plane);

/// A film unloads no roller: far from the load it carries some per mille to some per cent of the largest force. So a
/// roller counts as loaded from this part of the largest inner contact force on, with every law and everywhere.
inline constexpr double loaded_share = 0.01;
/// A roller whose inner contact carries `force_N`, where the most loaded one of the bearing carries `largest_N`.
[[nodiscard]] bool is_loaded(double force_N, double largest_N);
/// From the smallest to the largest azimuth of the loaded rollers; absent where nothing is loaded.
[[nodiscard]] std::optional<std::pair<double, double>> load_zone_deg(const Equilibrium& equilibrium);

}  // namespace ehd::bearing
