// SPDX-License-Identifier: GPL-3.0-or-later
// The load distribution of a bearing in the numbers that an engineer asks for first, a column a law.
#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bearing/geometry.hpp"
#include "workflow/bearing_result.hpp"
#include "workflow/case.hpp"

namespace ehd {

/// Numerical errors of one law's balance, from fit, interpolation and contact solves. The datum is not among them.
struct BearingErrors {
  double displacement_m = 0;
  double largest_force_N = 0;
  double any_force_N = 0;                    ///< of the roller whose force is known least
  std::optional<double> smallest_film = {};  ///< relative

  /// False where a source is infinite, as that of a film curve with a gap that nothing judged.
  [[nodiscard]] bool are_known() const {
    return std::isfinite(displacement_m + largest_force_N + any_force_N + smallest_film.value_or(0));
  }
};
using ErrorsOfLaws = std::map<bearing::Law, BearingErrors>;

/// Digits of a number with films whose error is not known.
inline constexpr int unstated_digits = 3;

/// The azimuth of a roller, and of its mirror image where it has one: "0", "+-16.364".
[[nodiscard]] std::string azimuth_text(const bearing::RollerGroup& group, double azimuth_deg);

/// Displacement, largest load and its pressure, load zone, thinnest film, stiffness, and where pressure and film are.
/// Brackets are the errors in units of the last digit; a law without an entry in `errors` has none. A fitted law has an
/// error of its stiffness only with the law ehd beside it.
[[nodiscard]] std::string summary_table(const BearingCase& body, const std::vector<BearingResult>& results,
                                        const ErrorsOfLaws& errors);

}  // namespace ehd
