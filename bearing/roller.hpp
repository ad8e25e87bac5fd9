// SPDX-License-Identifier: GPL-3.0-or-later
// One roller between its raceways: how a total approach splits between the inner and the outer contact.
#pragma once

#include "bearing/force_law.hpp"

namespace ehd::bearing {

struct ContactState {
  double force_N = 0;
  double approach_m = 0;  ///< negative where there is a gap, or a film thicker than the approach
};

/// One roller at a given total approach.
struct RollerState {
  ContactState inner, outer;
  double stiffness_N_per_m = 0;  ///< d f_i/d(delta_i + delta_o), 0 where the inner contact is unloaded
  bool at_jump = false;          ///< at delta = 0 of a law that jumps there (force_law.hpp)
};

/// Splits the total approach delta_i + delta_o of one roller so that f_o = f_i + F_c. Where the inner contact is
/// unloaded the roller rests on the outer ring, f_o = F_c. `guess_N`: a start for f_i, 0 for none.
[[nodiscard]] RollerState balance_roller(const LawPair& laws, double centrifugal_N, double total_approach_m,
                                         double guess_N = 0);

/// The equation of one roller. With s the total approach less the one at which the roller begins to carry,
///   r(f_i) = [delta_i(f_i) - delta_i(0)] + [delta_o(f_i + F_c) - delta_o(F_c)] - s = 0.
/// r increases with f_i. The brackets come from the laws without cancellation (rise), so f_i may be 1e-9 of F_c. A film
/// carries at any approach and begins nowhere; there s is the total approach itself. The laws must outlive this object.
class RollerBalance {
 public:
  RollerBalance(const LawPair& laws, double centrifugal_N);

  /// The total approach from which s counts.
  [[nodiscard]] double origin_m() const { return begins_ ? inner_begins_m_ + outer_alone_m_ : 0; }
  [[nodiscard]] bool begins() const { return begins_; }
  /// The s at which the inner contact carries f.
  [[nodiscard]] double excess_m(double f) const;
  [[nodiscard]] RollerState at(double s, double guess_N) const;
  /// Error of the roller's own balance [N]: of the forces, and of the approach times the stiffness.
  [[nodiscard]] double error_N(const RollerState& roller, double s) const;

 private:
  [[nodiscard]] double compliance_at(double f) const;
  [[nodiscard]] double solve(double s, double guess_N) const;

  const LawPair& laws_;
  double centrifugal_N_, inner_begins_m_, outer_alone_m_;
  bool begins_;
};

}  // namespace ehd::bearing
