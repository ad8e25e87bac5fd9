// SPDX-License-Identifier: GPL-3.0-or-later
// The points of the atlas: law sets, loads M, materials L, inlets.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/enum_words.hpp"
#include "verification/studies/box.hpp"
#include "workflow/case.hpp"

namespace ehd::verification {

enum class AtlasLaws {
  isoviscous,  ///< L = 0: isoviscous, incompressible
  barus,       ///< Barus, incompressible
  roelands,    ///< Roelands z = 0.68, p_0 = 1.96e8 Pa, Dowson and Higginson's density
};
inline constexpr auto all_atlas_laws = all_words<AtlasLaws>;
[[nodiscard]] std::string_view to_string(AtlasLaws laws);
[[nodiscard]] std::optional<AtlasLaws> atlas_laws_from(std::string_view text);

struct AtlasPoint {
  AtlasLaws laws = AtlasLaws::isoviscous;
  double M = 0;
  double L = 0;
  Inlet inlet = Flooded{};

  [[nodiscard]] std::string id() const;  ///< "atlas-roelands-m20-l10-flooded", "…-cut4"
  [[nodiscard]] std::string title() const;
  [[nodiscard]] double hertz_pressure_Pa() const;  ///< L sqrt(M/2pi)/alpha; 0 at L = 0
  [[nodiscard]] bool numerical_test() const;       ///< p_H above 4 GPa
  [[nodiscard]] ContactCase contact() const;
  /// 1e-10; Barus 1e-9.
  [[nodiscard]] double usual_tolerance() const;
};

/// All points, by law set, inlet (flooded; cut at X = -4 for M >= 2), M and L. L = 0 is there once: isoviscous.
[[nodiscard]] std::vector<AtlasPoint> atlas_points();

/// "flooded", or X of the cut: -4.
[[nodiscard]] std::string inlet_text(const Inlet& inlet);

}  // namespace ehd::verification
