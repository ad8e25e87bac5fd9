// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/carried_density.hpp"

#include <variant>

#include "fast/node_fields.hpp"
#include "fast/vectorise.hpp"

namespace ehd::fast {

namespace {

/// Null where the density is constant, and on grids without a spike to follow.
const DowsonHigginson* with_chords(const Setting& setting, const NodeFields& nodes) {
  struct {
    const DowsonHigginson* operator()(const Incompressible&) const { return nullptr; }
    const DowsonHigginson* operator()(const DowsonHigginson& law) const { return &law; }
  } chords;
  return nodes.grid->near_spike.size() > 0 ? std::visit(chords, setting.density) : nullptr;
}

/// s = 1/(1 + c P): then sigma = a s_(j-1) s_(j+1), without cancellation.
Array saturation(const DowsonHigginson& law, const Array& P) { return 1 / (1 + law.c * P.max(0)); }

}  // namespace

void CarriedDensity::evaluate(const Setting& setting, const NodeFields& nodes, const Array& P) {
  value = nodes.density.value;
  const DowsonHigginson* const law = with_chords(setting, nodes);
  if (!law) return;
  const Array s = saturation(*law, P);
  const double* const rho = nodes.density.value.data();
  const double* const w = nodes.grid->near_spike.data();
  double* const carried = value.data();
  EHD_VECTORISE
  for (int j = 1; j < nodes.n; ++j)
    carried[j] += w[j] * (rho[j - 1] - rho[j] + law->a * s[j - 1] * s[j + 1] * (P[j] - P[j - 1]));
}

void CarriedDensity::linearise(const Setting& setting, const NodeFields& nodes, const Array& P) {
  evaluate(setting, nodes, P);
  const int n = nodes.n;
  by_own = nodes.density.slope;
  by_left.setZero(n + 1);
  by_right.setZero(n + 1);
  const DowsonHigginson* const law = with_chords(setting, nodes);
  by_neighbours = law != nullptr;
  if (!law) return;
  const Array s = saturation(*law, P);
  const double* const w = nodes.grid->near_spike.data();
  for (int j = 1; j < n; ++j) {
    const double sigma = law->a * s[j - 1] * s[j + 1];
    by_own[j] += w[j] * (sigma - by_own[j]);
    by_left[j] = w[j] * sigma * law->c * s[j - 1] * (P[j + 1] - P[j]);
    by_right[j] = w[j] * sigma * law->c * s[j + 1] * (P[j - 1] - P[j]);
  }
}

}  // namespace ehd::fast
