// SPDX-License-Identifier: GPL-3.0-or-later
// Convergence of a number over a sequence of grids: first its trend, then what the trend allows to state: an order, an
// extrapolation, an uncertainty.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace ehd::verification {

enum class Trend {
  asymptotic,   ///< differences fall at the formal order, twice in a row
  monotone,     ///< differences of one sign fall, not (or not shown to be) at the formal order
  oscillatory,  ///< differences change their sign and fall
  stalled,      ///< the last two differences are not above the noise: finer grids add nothing
  divergent,    ///< differences do not fall
};
[[nodiscard]] std::string_view to_string(Trend trend);

struct GridValue {
  double cells = 0;  ///< intervals: h ~ 1/cells
  double value = 0;
};

struct GridStudy {
  Trend trend = Trend::divergent;
  std::optional<double> observed_order = {};  ///< of the last three grids; none where differences change sign or stall
  std::optional<double> extrapolated = {};    ///< asymptotic alone
  double uncertainty = 0;                     ///< relative, of the finest value: the GCI; infinite where divergent
  double safety = 0;                          ///< F_s of the GCI; 0 where there is none
};

/// Three grids or more, from coarse to fine, any ratios above 1. `noise`: the relative error of each value from other
/// sources than the grid. Throws std::invalid_argument for fewer grids, cells that do not grow, and values that are not
/// finite.
/// - Order p of three grids with ratios r21 = n1/n2 (1 the finest), r32, R = (f2 - f1)/(f3 - f2):
///   R = (1 - r21^-p)/(r32^p - 1), by bisection (Roache 1998, eq. 5.10.6.1, which iterates).
/// - asymptotic: p of the last three and of the three before both within 10 % of the formal order (four grids or more).
/// - GCI = F_s |f2 - f1|/(r21^q - 1)/|f1|: asymptotic F_s = 1.25, q the formal order; monotone F_s = 3,
///   q = min(max(1/2, p), formal) (Oberkampf & Roy 2010, section 8.6.3).
/// - oscillatory: half the range of the last three values (Stern et al. 2001). stalled: that, or the noise if larger.
[[nodiscard]] GridStudy study_grids(const std::vector<GridValue>& values, double formal_order, double noise);

}  // namespace ehd::verification
