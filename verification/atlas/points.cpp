// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/atlas/points.hpp"

#include <fmt/format.h>

#include "contact/nondimensional.hpp"
#include "contact/rheology.hpp"
#include "contact/text.hpp"

namespace ehd::verification {

namespace {

constexpr double lightest_cut_M = 2;  ///< in a lighter contact, X = -4 lies inside the inlet zone
/// Measured at (20, 10): 1e-8 costs Barus, whose spike has no bound, three times as much; at (1000, 15) it is not met.
constexpr double other_tolerance = 1e-10, barus_tolerance = 1e-9;

}  // namespace

std::string inlet_text(const Inlet& inlet) {
  const auto* cut = std::get_if<TruncatedAt>(&inlet);
  return cut ? plain(cut->x) : "flooded";
}

std::string_view to_string(AtlasLaws laws) {
  switch (laws) {
    case AtlasLaws::isoviscous: return Isoviscous::name;
    case AtlasLaws::barus: return Barus::name;
    case AtlasLaws::roelands: return Roelands::name;
  }
  return "";
}

std::optional<AtlasLaws> atlas_laws_from(std::string_view text) { return word_from<AtlasLaws>(text); }

std::string AtlasPoint::id() const {
  const auto* cut = std::get_if<TruncatedAt>(&inlet);
  return fmt::format("atlas-{}-m{}-l{}-{}", to_string(laws), plain(M), plain(L),
                     cut ? "cut" + plain(-cut->x) : "flooded");
}

std::string AtlasPoint::title() const {
  const std::string law = laws == AtlasLaws::isoviscous ? "isoviscous, incompressible"
                          : laws == AtlasLaws::barus    ? "Barus, incompressible"
                                                        : "Roelands, compressible";
  return fmt::format(
      "Atlas: M = {}, L = {}, {}, {}{}{}", plain(M), plain(L), law,
      std::holds_alternative<Flooded>(inlet) ? "" : "inlet cut at X = ", inlet_text(inlet),
      numerical_test() ? fmt::format(" (a numerical test: p_H = {} GPa)", plain(hertz_pressure_Pa() / 1e9, 2)) : "");
}

double AtlasPoint::hertz_pressure_Pa() const {
  return verification::hertz_pressure_Pa(groups_from(MoesGroups{.M = M, .L = L}));
}

bool AtlasPoint::numerical_test() const { return hertz_pressure_Pa() > highest_pressure_Pa; }

ContactCase AtlasPoint::contact() const {
  Lubricant lubricant = oil(laws == AtlasLaws::roelands);
  if (laws == AtlasLaws::barus) lubricant.alpha_per_Pa = oil_alpha_per_Pa;
  if (laws == AtlasLaws::isoviscous) lubricant.viscosity = ViscosityLaw::isoviscous;
  return {.statement = MoesGroups{.M = M, .L = L}, .lubricant = lubricant, .inlet = inlet};
}

double AtlasPoint::usual_tolerance() const { return laws == AtlasLaws::barus ? barus_tolerance : other_tolerance; }

std::vector<AtlasPoint> atlas_points() {
  const std::vector<double> piezoviscous_L{2.5, 5, 10, 15, 20, 30};
  std::vector<AtlasPoint> points;
  for (const AtlasLaws laws : all_atlas_laws) {
    const bool isoviscous = laws == AtlasLaws::isoviscous;  // L = 0 is the same for all laws
    const Box box{.M = round_loads(box_lightest_M, box_heaviest_M),
                  .L = isoviscous ? std::vector<double>{0} : piezoviscous_L,
                  .roelands = {laws == AtlasLaws::roelands},
                  .lightest_cut_M = lightest_cut_M};
    for (const BoxContact& contact : contacts_of(box))
      points.push_back({laws, contact.moes.M, contact.moes.L, contact.inlet});
  }
  return points;
}

}  // namespace ehd::verification
