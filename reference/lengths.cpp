// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lengths.hpp"

#include <algorithm>
#include <cmath>

namespace ehd::reference {

double contact_length(double central_film) { return std::max(1.0, std::sqrt(2 * std::max(central_film, 0.0))); }
double inlet_zone(double central_film) { return std::pow(std::clamp(central_film, 0.0, 1.0), 2.0 / 3); }

double inlet_cells(const Array& nodes, double central_film) {
  const double l = contact_length(central_film);
  const Eigen::Index right = std::lower_bound(nodes.begin(), nodes.end(), -l) - nodes.begin();
  const Eigen::Index i = std::clamp<Eigen::Index>(right, 1, nodes.size() - 1);
  return l * inlet_zone(central_film) / (nodes[i] - nodes[i - 1]);
}

}  // namespace ehd::reference
