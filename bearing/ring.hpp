// SPDX-License-Identifier: GPL-3.0-or-later
// The inner ring and its rollers: the forces and the stiffness at a displacement of the ring.
#pragma once

#include <vector>

#include "bearing/geometry.hpp"
#include "bearing/plane.hpp"
#include "bearing/roller.hpp"

namespace ehd::bearing {

/// How the ring may move. Both forms agree where the cage stands symmetric to the load.
enum class Form {
  plane,  ///< the ring moves along the load (x) and across it (y): any cage position is balanced
  radial  ///< the ring moves along the load only, y = 0; the force across that this needs is reported, not balanced
};

struct Loading {
  double radial_N = 0;
  double centrifugal_N = 0;  ///< on each roller
};

/// A balance with a larger Equilibrium::balance_error is not returned.
inline constexpr double largest_balance_error = 1e-12;

/// The rollers at one displacement of the ring.
struct RingState {
  std::vector<RollerState> groups;
  Vector2 force_N;  ///< Sum f_i (cos psi, sin psi)
  Symmetric2 stiffness_N_per_m;
  double total_N = 0;  ///< Sum f_i
};

/// The rollers as functions of the displacement v of the ring from a reference. At light load and wide clearance an
/// approach of 1e-9 m stands beside a displacement of 1e-4 m. So a dry ring with clearance has a reference where
/// rollers in the directions a and b, beside the load line, just touch. With c the gap at the middle, the excess of a
/// roller at this reference is
///   c [cos(psi - (a+b)/2)/cos((b-a)/2) - 1] = -2 c sin((psi-a)/2) sin((psi-b)/2)/cos((b-a)/2).
/// The second form is exactly zero at a and b, and no difference of nearly equal numbers. v adds
/// v_x cos psi + v_y sin psi. The reference of preloaded rings and of films is the middle.
class Ring {
 public:
  /// Rollers that a symmetric ring cannot tell apart.
  struct Group {
    Vector2 direction;    ///< (cos psi, sin psi); the second is 0 where plane() is false
    double excess_m = 0;  ///< at the reference
    std::vector<int> members;
  };

  /// The laws must outlive the ring.
  Ring(const Geometry& geometry, const LawPair& laws, const Loading& loading, Form form);

  /// The ring moves across the load too: the plane form under a cage that is not symmetric to the load.
  [[nodiscard]] bool plane() const { return plane_; }
  [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }
  [[nodiscard]] const std::vector<double>& azimuths() const { return azimuths_; }
  [[nodiscard]] const RollerBalance& roller() const { return roller_; }
  [[nodiscard]] bool counts_from_touch() const { return counts_from_touch_; }
  /// Gap of a roller to the approach at which it begins to carry, with the ring in the middle; negative: preload.
  [[nodiscard]] double gap_m() const { return gap_m_; }
  /// The directions a and b beside the load.
  [[nodiscard]] double first_deg() const { return first_deg_; }
  [[nodiscard]] double second_deg() const { return second_deg_; }
  /// Displacements at which the rollers were balanced.
  [[nodiscard]] int evaluations() const { return evaluations_; }
  /// The load lies between two directions that are less than a half turn apart.
  [[nodiscard]] bool can_carry() const;

  /// The displacement from the middle.
  [[nodiscard]] Vector2 displacement_m(Vector2 v) const;
  [[nodiscard]] double excess_m(const Group& group, Vector2 v) const {
    return group.excess_m + dot(group.direction, v);
  }
  /// Balances every roller; each starts from its force at the call before.
  [[nodiscard]] RingState at(Vector2 v);
  /// Forces and stiffness of the ring from those of its rollers.
  void sum(RingState& state) const;

 private:
  void add_group(double azimuth, std::vector<int> members);
  void find_directions_beside_the_load();
  [[nodiscard]] double half_cosine() const;
  [[nodiscard]] double excess_at_touch_m(double azimuth) const;

  std::vector<double> azimuths_, azimuth_of_;
  RollerBalance roller_;
  double gap_m_;
  bool plane_ = false, counts_from_touch_ = false;
  double first_deg_ = 0, second_deg_ = 0;
  std::vector<Group> groups_;
  std::vector<double> guess_N_;
  int evaluations_ = 0;
};

}  // namespace ehd::bearing
