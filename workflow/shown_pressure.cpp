// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/shown_pressure.hpp"

namespace ehd {

bool pressure_known(const Solution& solution) { return solution.observables.contains(Quantity::pressure_maximum); }

std::optional<double> pressure_cut(const Solution& solution) {
  const Array& P = solution.fields.P;
  if (P.size() == 0 || pressure_known(solution)) return std::nullopt;
  // A pressure that is not finite is not known either.
  return P.maxCoeff() <= shown_of_unresolved ? std::nullopt : std::optional(shown_of_unresolved);
}

}  // namespace ehd
