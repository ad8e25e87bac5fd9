// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/film_panel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "workflow/chebyshev.hpp"

namespace ehd {

namespace {

/// ln M, and its derivative by y.
struct Edges {
  ValueWithSlope low, high;
};

Edges edges_at(const PanelShape& panel, double y) {
  const ChebyshevBasis basis(static_cast<int>(std::max(panel.low.size(), panel.high.size())) - 1, y);
  return {chebyshev_sum(panel.low, basis), chebyshev_sum(panel.high, basis)};
}

double along(const PanelShape& panel) { return std::log1p(panel.L_high) - std::log1p(panel.L_low); }

double y_at(const PanelShape& panel, double L) {
  return 2 * (std::log1p(L) - std::log1p(panel.L_low)) / along(panel) - 1;
}

}  // namespace

std::string_view to_string(PanelMap map) {
  switch (map) {
    case PanelMap::even: return "even";
    case PanelMap::root_low: return "root-low";
    case PanelMap::root_high: return "root-high";
  }
  return "unknown";
}

bool is_straight(const PanelShape& panel) { return panel.low.size() == 1 && panel.high.size() == 1; }

std::pair<double, double> ends_of(const std::vector<double>& edge) {
  constexpr int cells = 64;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (int k = 0; k <= cells; ++k) {
    const double log_M =
        chebyshev_sum(edge, ChebyshevBasis(static_cast<int>(edge.size()) - 1, 2.0 * k / cells - 1)).value;
    least = std::min(least, log_M);
    most = std::max(most, log_M);
  }
  return {std::exp(least), std::exp(most)};
}

bool holds(const PanelShape& panel, const MoesGroups& at) {
  return at.L >= panel.L_low && at.L <= panel.L_high && std::log(at.M) <= edges_at(panel, y_at(panel, at.L)).high.value;
}

PanelPlace place_in(const PanelShape& panel, const MoesGroups& at) {
  PanelPlace place;
  place.y = y_at(panel, at.L);
  place.y_by_L = 2 / (along(panel) * (1 + at.L));
  const Edges edges = edges_at(panel, place.y);
  const double across = edges.high.value - edges.low.value;
  const double share = (std::log(at.M) - edges.low.value) / across;
  double x_by_share = 2;
  if (panel.map == PanelMap::even) {
    place.x = 2 * share - 1;
  } else {
    const bool high = panel.map == PanelMap::root_high;
    const double root = std::sqrt(std::max(0.0, high ? 1 - share : share));
    place.x = high ? 1 - 2 * root : 2 * root - 1;
    x_by_share = 1 / std::max(root, least_root);
  }
  const double share_by_y = -(edges.low.slope + share * (edges.high.slope - edges.low.slope)) / across;
  place.x_by_M = x_by_share / (across * at.M);
  place.x_by_L = x_by_share * share_by_y * place.y_by_L;
  return place;
}

MoesGroups contact_at(const PanelShape& panel, double x, double y) {
  const Edges edges = edges_at(panel, y);
  const double up = (1 + x) / 2, down = (1 - x) / 2;
  const double share = panel.map == PanelMap::root_low    ? up * up
                       : panel.map == PanelMap::root_high ? 1 - down * down
                                                          : up;
  const double low = edges.low.value, high = edges.high.value;
  return {.M = std::clamp(std::exp(low + share * (high - low)), std::exp(low), std::exp(high)),
          .L = std::clamp(std::expm1(std::log1p(panel.L_low) + along(panel) * (1 + y) / 2), panel.L_low, panel.L_high)};
}

}  // namespace ehd
