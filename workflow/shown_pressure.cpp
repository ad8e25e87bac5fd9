// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/shown_pressure.hpp"

#include "contact/observables.hpp"

namespace ehd {

namespace {

bool known(const ContactRun& run, Quantity peak) {
  return run.solution.observables.contains(peak) || run.peaks.contains(peak);
}

}  // namespace

bool pressure_known(const ContactRun& run) { return known(run, Quantity::pressure_maximum); }

std::optional<double> pressure_cut(const ContactRun& run) {
  const Array& P = run.solution.fields.P;
  if (P.size() == 0 || pressure_known(run)) return std::nullopt;
  // A pressure that is not finite is not known either.
  return P.maxCoeff() <= shown_of_unresolved ? std::nullopt : std::optional(shown_of_unresolved);
}

std::optional<Reading> vague_spike(const ContactRun& run) {
  if (known(run, Quantity::pressure_spike)) return std::nullopt;
  const auto spike = observed::pressure_spike(run.solution.fields);
  return spike && spike->place ? spike : std::nullopt;
}

}  // namespace ehd
