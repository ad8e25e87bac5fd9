// SPDX-License-Identifier: GPL-3.0-or-later
// Stiffness, damping and waviness over M and L, from the atlas of motion (verification/atlas/motion.hpp). Nothing is
// solved or judged.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/atlas/motion.hpp"

namespace ehd::verification {

struct MotionMaps {
  std::vector<AtlasRow> kappa, waviness;  ///< rows of both tables
};
/// Throws CaseError where there is no atlas of motion, or one of another kind.
[[nodiscard]] MotionMaps motion_maps(const std::filesystem::path& folder);

/// Omega of a point at which damping is negative beyond its error, increasing.
[[nodiscard]] std::vector<double> driven_frequencies(const MotionMaps& maps, AtlasLaws laws, MoesGroups moes);

/// kappa_0, kappa_1; where damping is negative, and how far; how far the amplitude ratios of waves in pure rolling are
/// one curve over the similar wavelength.
[[nodiscard]] std::string human_motion_maps(const MotionMaps& maps);

}  // namespace ehd::verification
