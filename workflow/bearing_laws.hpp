// SPDX-License-Identifier: GPL-3.0-or-later
// The contact force laws by name, as the command line and the cases have them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "bearing/equilibrium.hpp"

namespace ehd {

enum class BearingLaw { hertz, iso, lundberg, tripp, houpert, ehd_linear, ehd };
inline constexpr BearingLaw all_laws[] = {BearingLaw::hertz,   BearingLaw::iso,        BearingLaw::lundberg, BearingLaw::tripp,
                                          BearingLaw::houpert, BearingLaw::ehd_linear, BearingLaw::ehd};
[[nodiscard]] std::string_view to_string(BearingLaw law);  ///< "hertz", …, "houpert", "ehd-linear", "ehd"
[[nodiscard]] std::optional<BearingLaw> bearing_law_from(std::string_view text);
[[nodiscard]] std::string bearing_law_names();  ///< for messages
[[nodiscard]] bool needs_film(BearingLaw law);
[[nodiscard]] bool needs_ring_thickness(BearingLaw law);  ///< tripp, houpert: at the outer raceway
/// A dry law at both raceways. Throws std::invalid_argument for a law with films.
[[nodiscard]] bearing::LawPair dry_laws(BearingLaw law, const bearing::RollerContact& contact);

}  // namespace ehd
