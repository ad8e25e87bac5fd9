// SPDX-License-Identifier: GPL-3.0-or-later
// A part of a table of films: its edges are curves M(L), and its films are polynomials in x and y, each -1 … 1.
//
//   y = 2 (ln(1 + L) - ln(1 + L_low))/(ln(1 + L_high) - ln(1 + L_low)) - 1
//   s = (ln M - a(y))/(b(y) - a(y)),  a and b: ln M of the low and of the high edge, each a sum of c_j T_j(y)
//   even:       x = 2 s - 1
//   root_low:   x = 2 sqrt(s) - 1
//   root_high:  x = 1 - 2 sqrt(1 - s)
//
// ln(1 + L) instead of L halves the degree over L 2.5..20, and L = 0 is allowed. Where a film has a corner at an edge,
// it goes like sqrt(|ln M - edge|) on one side: that is smooth in x with a root (film_table_bend.hpp).
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "contact/conditions.hpp"

namespace ehd {

/// How x follows from ln M.
enum class PanelMap { even, root_low, root_high };
[[nodiscard]] std::string_view to_string(PanelMap map);  ///< "even", "root-low", "root-high"

/// Where a panel stands. Low edge below high edge at each L.
struct PanelShape {
  double L_low = 0, L_high = 0;
  std::vector<double> low = {}, high = {};  ///< c_j of ln M at the edges, at least one; one alone is a constant M
  PanelMap map = PanelMap::even;
};

/// Both edges are constant M.
[[nodiscard]] bool is_straight(const PanelShape& panel);

/// The least and the largest M of an edge, at 65 values of y.
[[nodiscard]] std::pair<double, double> ends_of(const std::vector<double>& edge);

/// L is in the panel, and M is not above its high edge.
[[nodiscard]] bool holds(const PanelShape& panel, const MoesGroups& at);

/// Next to the edge of a root, where dx/dM has no bound: where the root is less than this, the derivatives of x are as
/// if it were this.
inline constexpr double least_root = 1e-3;

/// The coordinates of a contact in a panel and their derivatives.
struct PanelPlace {
  double x = 0, x_by_M = 0, x_by_L = 0;
  double y = 0, y_by_L = 0;
};
/// L is in the panel. M beyond the edge of a root counts as at the edge.
[[nodiscard]] PanelPlace place_in(const PanelShape& panel, const MoesGroups& at);
/// The contact at x, y.
[[nodiscard]] MoesGroups contact_at(const PanelShape& panel, double x, double y);

}  // namespace ehd
