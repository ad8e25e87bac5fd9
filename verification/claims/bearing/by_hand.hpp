// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of a bearing's contacts from the printed formulas, written out again, and from contacts that `reference`
// solves in SI. The claims about the parts of a bearing expect these numbers.
#pragma once

#include <string>

#include "verification/claims/shared.hpp"
#include "workflow/case.hpp"

namespace ehd::verification::bearing_parts {

/// One contact of a raceway. The rollers slip at neither raceway: both surfaces move past the contact point with
/// |w_ring - w_cage| r_ring.
struct ByHand {
  double radius_m, modulus_Pa, sum_speed_m_per_s, length_m;
};
[[nodiscard]] ByHand by_hand(const BearingCase& body, bool inner);

/// 4w/(pi E').
[[nodiscard]] double scale_m(const ByHand& contact, double force_N);
/// b, the half width by Hertz.
[[nodiscard]] double half_width_m(const ByHand& contact, double force_N);
/// The dry approach by the logarithmic kernel with the datum x_0.
[[nodiscard]] double dry_m(const ByHand& contact, double force_N, double datum_m);

/// Film and approach of one roller contact by `reference`, from SI. NaN where the solve does not converge.
struct SolvedByHand {
  double offset_film_m;  ///< delta_dry - delta, for any datum
  double film_minimum_m;
  double rolling_force_N_per_m;  ///< |Int h p' dx|/2
  /// Int h^3 p'^2/(12 eta) dx, what the flow dissipates, by differences of the pressure [W/m], and its error: from
  /// every second node.
  double dissipation_W_per_m, dissipation_error;
};
[[nodiscard]] SolvedByHand solved_by_hand(const BearingCase& body, bool inner, double force_N);

/// "bearing/" + id, on rung 11.
[[nodiscard]] Sentence sentence(const std::string& id, const std::string& statement);

[[nodiscard]] inline std::string raceway_name(bool inner) { return inner ? "inner" : "outer"; }
/// The inner or the outer one of anything that has both.
template <class Both>
[[nodiscard]] const auto& one_of(const Both& both, bool inner) {
  return inner ? both.inner : both.outer;
}

/// Ten times the 1e-4 that a bearing asks of the films of its contacts: an offset film is a film and a bit more.
[[nodiscard]] Tolerance film_tolerance();

}  // namespace ehd::verification::bearing_parts
