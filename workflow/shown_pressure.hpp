// SPDX-License-Identifier: GPL-3.0-or-later
// Up to which pressure the fields of a contact may be shown.
#pragma once

#include <optional>

#include "contact/solution.hpp"
#include "workflow/contact_run.hpp"

namespace ehd {

/// Profiles and figures show a spike of unknown height up to this pressure [p/p_H]. The dome of a loaded contact ends
/// near 1, so that it stays visible; a spike on too coarse a grid was seen at 10 to 25.
inline constexpr double shown_of_unresolved = 1.5;

/// pressure.maximum is known, wanted or not. Otherwise a spike may be higher than the fields show.
[[nodiscard]] bool pressure_known(const ContactRun& run);

/// `shown_of_unresolved` where the fields exceed it and the pressure is not known. Empty where the pressure may be
/// shown as it is.
[[nodiscard]] std::optional<double> pressure_cut(const ContactRun& run);

/// The top of the spike that the fields have, where pressure.spike is not known, wanted or not. Empty where it is
/// known, and where there is no spike.
[[nodiscard]] std::optional<Reading> vague_spike(const ContactRun& run);

}  // namespace ehd
