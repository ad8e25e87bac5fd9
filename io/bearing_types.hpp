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
  int rows = 1;
  bool full_complement = false;     ///< as many rollers as fit
  std::string_view clearance = {};  ///< between which surfaces, where there are not two rings
  bool needles = false;             ///< slender rollers: the examples of a template are those of needles
};

inline constexpr std::string_view by_flanges =
    "State it as it is. Its flanges guide the rollers and carry axial loads. ehd has a radial load and no flanges: NU, "
    "NJ, NUP and N with the same numbers have the same result.";
inline constexpr std::string_view by_half =
    "State one row: half of the load, the rollers and the length of one row. Stiffness and torque of the bearing are "
    "twice those printed.";

inline constexpr BearingType bearing_types[] = {
    {.name = "NU", .what = "one row, flanges on the outer ring", .stated = by_flanges},
    {.name = "NJ", .what = "one row, one flange on the inner ring too", .stated = by_flanges},
    {.name = "NUP", .what = "one row, both rings with two flanges", .stated = by_flanges},
    {.name = "N", .what = "one row, flanges on the inner ring", .stated = by_flanges},
    {.name = "NA",
     .what = "needles, both rings",
     .stated = "State it as it is: a needle is a roller.",
     .needles = true},
    {.name = "RNU",
     .what = "one row without an inner ring",
     .stated =
         "The shaft is the inner raceway. The clearance is that on the shaft, the pitch diameter that of the centres.",
     .clearance = "outer raceway less shaft less two roller diameters"},
    {.name = "RNA",
     .what = "needles without an inner ring",
     .stated =
         "The shaft is the inner raceway. The clearance is that on the shaft, the pitch diameter that of the centres.",
     .clearance = "outer raceway less shaft less two roller diameters",
     .needles = true},
    {.name = "HK",
     .what = "needles in a drawn cup",
     .stated = "The shaft is the inner raceway. The clearance is that of the cup pressed into its bore.",
     .clearance = "inside of the pressed cup less shaft less two needle diameters",
     .needles = true},
    {.name = "K",
     .what = "needles in a cage without rings",
     .stated = "Shaft and bore are the raceways. The clearance is bore less shaft less two needle diameters. The cage "
               "keeps the needles apart; ehd takes rollers as equally spaced, with a cage or without.",
     .clearance = "bore less shaft less two needle diameters",
     .needles = true},
    {.name = "NCF",
     .what = "one row, full complement",
     .stated = "No cage parts the rollers: at most pi/asin(D/d_m) of them fit, D and d_m the diameters of roller and "
               "pitch circle. ehd knows no friction between rollers that touch.",
     .full_complement = true},
    {.name = "NN", .what = "two rows, flanges on the inner ring", .stated = by_half, .rows = 2},
    {.name = "NNU", .what = "two rows, flanges on the outer ring", .stated = by_half, .rows = 2},
    {.name = "NNCF", .what = "two rows, full complement", .stated = by_half, .rows = 2, .full_complement = true},
    {.name = "FC",
     .what = "four rows",
     .stated = "State one row: a quarter of the load, if the rows share it. Stiffness and torque of the bearing are "
               "four times those printed.",
     .rows = 4},
};

}  // namespace ehd
