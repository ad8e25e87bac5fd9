// SPDX-License-Identifier: GPL-3.0-or-later
// Random bearings over the ranges that a balance is made for. A seed gives the same bearing on every machine.
#pragma once

#include "bearing/equilibrium.hpp"

namespace ehd::verification {

/// Z 3..400, rollers side by side; clearance -20..+200 um; load from none to p_H = 4 GPa on the most loaded roller;
/// either ring or both turning, to 30,000 rpm; the cage anywhere, symmetric to the load, or nearly so. Preload and
/// speed are limited to 4 GPa at the contacts too: with small rollers, -20 um or 30,000 rpm would give more.
struct RandomBearing {
  bearing::Geometry geometry;
  bearing::Speeds speeds;
  bearing::Loading loading;
  bearing::RollerContact contact;  ///< what the dry laws need
};
[[nodiscard]] RandomBearing random_bearing(unsigned seed);

}  // namespace ehd::verification
