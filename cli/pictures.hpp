// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures that `--plot` writes: SVG texts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflow/bearing_run.hpp"
#include "workflow/contact_run.hpp"

namespace ehd::cli {

/// Pressure and film over the contact: in um and MPa where the case is stated in SI, else in Hertz units.
[[nodiscard]] std::string contact_picture(const ContactRun& run, const std::string& title);

/// One bearing: the loads round it in polar coordinates, beside forces and displacements over the azimuth. Two or
/// three: the same for each, one above the other and on the same axes. More: forces and displacements of each alone. A
/// curve a law; absent where no law balanced.
[[nodiscard]] std::optional<std::string> bearing_picture(const std::vector<Case>& cases,
                                                         const std::vector<std::vector<BearingResult>>& results);

}  // namespace ehd::cli
