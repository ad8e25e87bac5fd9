// SPDX-License-Identifier: GPL-3.0-or-later
// The panels of a table of films: the range, split where the films bend.
//
// With M the largest pressure moves from the inlet side to the exit side. Where it passes X = 0, the central film
// bends. That is a curve M(L), "the bend", found here by solves. With Barus' oil the bend becomes a corner above L =
// 10: below it ln H_cen falls by 0.29 sqrt(ln M_bend - ln M), above it H_cen is the smooth Couette film. Panels have
// the bend as an edge and are solved on a scale with a square root, on which both sides are smooth.
#pragma once

#include <vector>

#include "workflow/film_panel.hpp"
#include "workflow/film_table_source.hpp"

namespace ehd {

/// Nearer to the bend than this (in ln M) no contact is solved for the coefficients. At L = 20, Barus, `fast` cannot
/// find H_cen to 2e-5 at 3e-5, and takes 50 ms at 3e-4.
inline constexpr double bend_gap = 3e-4;

/// A panel to be filled. Contacts are solved between x_first and x_last; up to the edges the panel extrapolates.
struct PanelPlan {
  PanelShape shape;
  double x_first = -1, x_last = 1;
  bool may_bend = false;  ///< the bend may be in it
  [[nodiscard]] bool extrapolates() const { return x_first > -1 || x_last < 1; }
};

/// Panels with straight edges, split at the M between which the bend lies.
[[nodiscard]] std::vector<PanelPlan> straight_panels(const FilmRange& range);

struct BendPlans {
  std::vector<PanelPlan> panels;  ///< of a contact in the range: the first that holds it; empty: no bend was found
  long solves = 0;                ///< that searched for the bend
};

/// The panels that replace a straight one: those beside the bend, each over a band of L, and straight ones over the L
/// at which the bend is not in the panel. They may reach outside that panel. `most_panels`: no band is halved beyond.
[[nodiscard]] BendPlans panels_beside_bend(const PanelShape& panel, const FilmSource& source, long most_panels);

/// The halves of a panel in M, if it is straight and they are to be in M; else in L.
[[nodiscard]] std::vector<PanelPlan> halves(const PanelPlan& plan, bool in_M);

}  // namespace ehd
