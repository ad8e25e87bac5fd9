// SPDX-License-Identifier: GPL-3.0-or-later
// Types of radial roller bearings, by the codes of makers' catalogues, and how each is stated as a bearing case.
// Dimensions are the reader's: a code says how a bearing is built, not how large it is.
#pragma once

#include <string_view>

namespace ehd {

struct BearingType {
  std::string_view name;    ///< the code in front of the number: "NU"
  std::string_view what;    ///< how it is built
  std::string_view stated;  ///< how to state it, in whole sentences
};

inline constexpr std::string_view by_flanges = "State it as it is. Its flanges carry axial loads; this load is radial.";
inline constexpr std::string_view by_half =
    "State one row: half of the load, the rollers and the length of one row. Stiffness and torque of the bearing are "
    "twice those printed.";

inline constexpr BearingType bearing_types[] = {
    {"NU", "one row, flanges on the outer ring", by_flanges},
    {"NJ", "one row, one flange on the inner ring too", by_flanges},
    {"NUP", "one row, both rings with two flanges", by_flanges},
    {"N", "one row, flanges on the inner ring", by_flanges},
    {"NA", "needles, both rings", "State it as it is: a needle is a roller."},
    {"RNU", "one row without an inner ring",
     "The shaft is the inner raceway. The clearance is that on the shaft, the pitch diameter that of the centres."},
    {"RNA", "needles without an inner ring",
     "The shaft is the inner raceway. The clearance is that on the shaft, the pitch diameter that of the centres."},
    {"HK", "needles in a drawn cup",
     "The shaft is the inner raceway. The clearance is that of the cup pressed into its bore."},
    {"K", "needles in a cage without rings",
     "Shaft and bore are the raceways. The clearance is bore less shaft less two needle diameters."},
    {"NCF", "one row, full complement",
     "No cage parts the rollers: at most pi/asin(D/d_m) of them fit, D and d_m the diameters of roller and pitch "
     "circle."},
    {"NN", "two rows, flanges on the inner ring", by_half},
    {"NNU", "two rows, flanges on the outer ring", by_half},
    {"NNCF", "two rows, full complement", by_half},
    {"FC", "four rows",
     "State one row: a quarter of the load, if the rows share it. Stiffness and torque of the bearing are four times "
     "those printed."},
};

}  // namespace ehd
