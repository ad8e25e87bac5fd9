// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/conditions.hpp"

namespace ehd {

std::string_view to_string(ViscosityLaw law) {
  switch (law) {
    case ViscosityLaw::isoviscous: return "isoviscous";
    case ViscosityLaw::barus: return "barus";
    case ViscosityLaw::roelands: return "roelands";
  }
  return "";
}

std::string_view to_string(DensityLaw law) {
  switch (law) {
    case DensityLaw::incompressible: return "incompressible";
    case DensityLaw::dowson_higginson: return "dowson-higginson";
    case DensityLaw::dowson_higginson_1977: return "dowson-higginson-1977";
  }
  return "";
}

std::optional<ViscosityLaw> viscosity_law_from(std::string_view text) {
  for (const auto law : {ViscosityLaw::isoviscous, ViscosityLaw::barus, ViscosityLaw::roelands}) {
    if (text == to_string(law)) return law;
  }
  return std::nullopt;
}

std::optional<DensityLaw> density_law_from(std::string_view text) {
  for (const auto law :
       {DensityLaw::incompressible, DensityLaw::dowson_higginson, DensityLaw::dowson_higginson_1977}) {
    if (text == to_string(law)) return law;
  }
  return std::nullopt;
}

}  // namespace ehd
