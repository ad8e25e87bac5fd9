// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid cylinder on a plane, Barus viscosity, load -> infinity (Blok).
//
// The reduced pressure q = (1 - e^(-alpha p))/alpha obeys the isoviscous equation, so it is Martin's pressure. Where
// the largest q reaches 1/alpha, p becomes infinite: at that film a rigid contact carries any load.
#pragma once

namespace ehd::verification::exact {

/// Films over L^(2/3) in Moes units.
struct Blok {
  Blok();
  double minimum = 0;  ///< 1.04970
  double couette = 0;  ///< 1.28667
};

}  // namespace ehd::verification::exact
