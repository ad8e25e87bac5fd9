// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/shown_pressure.hpp"

#include "contact/observables.hpp"

namespace ehd {

bool pressure_known(const Solution& solution) { return solution.observables.contains(Quantity::pressure_maximum); }

std::optional<double> pressure_cut(const Solution& solution) {
  const Array& P = solution.fields.P;
  if (P.size() == 0 || pressure_known(solution)) return std::nullopt;
  // A pressure that is not finite is not known either.
  return P.maxCoeff() <= shown_of_unresolved ? std::nullopt : std::optional(shown_of_unresolved);
}

std::optional<Reading> vague_spike(const Solution& solution) {
  if (solution.observables.contains(Quantity::pressure_spike)) return std::nullopt;
  const auto spike = observed::pressure_spike(solution.fields);
  return spike && spike->place ? spike : std::nullopt;
}

}  // namespace ehd
