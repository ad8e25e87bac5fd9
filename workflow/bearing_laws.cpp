// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_laws.hpp"

#include <stdexcept>

namespace ehd {

using bearing::LawPair;

std::string_view to_string(BearingLaw law) {
  switch (law) {
    case BearingLaw::hertz: return "hertz";
    case BearingLaw::iso: return "iso";
    case BearingLaw::lundberg: return "lundberg";
    case BearingLaw::tripp: return "tripp";
    case BearingLaw::houpert: return "houpert";
    case BearingLaw::ehd_linear: return "ehd-linear";
    case BearingLaw::ehd: return "ehd";
  }
  return "";
}

std::optional<BearingLaw> bearing_law_from(std::string_view text) {
  for (const BearingLaw law : all_laws) {
    if (text == to_string(law)) return law;
  }
  return std::nullopt;
}

std::string bearing_law_names() {
  std::string names;
  for (const BearingLaw law : all_laws) names += (names.empty() ? "" : ", ") + std::string(to_string(law));
  return names;
}

bool needs_film(BearingLaw law) { return law == BearingLaw::ehd_linear || law == BearingLaw::ehd; }

bool needs_ring_thickness(BearingLaw law) { return law == BearingLaw::tripp || law == BearingLaw::houpert; }

LawPair dry_laws(BearingLaw law, const bearing::RollerContact& contact) {
  using bearing::Raceway;
  const auto each = [&contact](auto law_of) { return LawPair{law_of(contact, Raceway::inner), law_of(contact, Raceway::outer)}; };
  switch (law) {
    case BearingLaw::hertz: return {bearing::palmgren_law(contact.length_m), bearing::palmgren_law(contact.length_m)};
    case BearingLaw::iso: return {bearing::iso_law(contact.length_m), bearing::iso_law(contact.length_m)};
    case BearingLaw::lundberg: return each(bearing::lundberg_law);
    case BearingLaw::tripp: return each(bearing::tripp_law);
    case BearingLaw::houpert: return each(bearing::houpert_law);
    case BearingLaw::ehd_linear:
    case BearingLaw::ehd: break;
  }
  throw std::invalid_argument("law " + std::string(to_string(law)) + " is not dry: it needs solved contacts");
}

}  // namespace ehd
