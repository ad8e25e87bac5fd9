// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/law_table.hpp"

#include <array>
#include <stdexcept>
#include <vector>

#include "bearing/approach_formulas.hpp"
#include "bearing/film_curve.hpp"
#include "bearing/fit.hpp"
#include "bearing/force_law.hpp"

namespace ehd::bearing {

namespace {

/// A law that differs between the raceways.
template <auto law_of>
LawPair at_each(const RollerContact& contact) {
  return {law_of(contact, Raceway::inner), law_of(contact, Raceway::outer)};
}

/// A law of the contact length alone.
template <PowerLaw (*law_of)(double length_m)>
LawPair of_length(const RollerContact& contact) {
  return {law_of(contact.length_m), law_of(contact.length_m)};
}

LawPair from_fits(const BothRaceways<LinearFit>& fits) { return {fits.inner.law(), fits.outer.law()}; }

LawPair from_curves(const BothRaceways<SharedCurve>& curves, const BothRaceways<double>& datum_m) {
  return {CurveLaw(curves.inner, datum_m.inner), CurveLaw(curves.outer, datum_m.outer)};
}

constexpr std::array table{
    LawRow{.law = Law::hertz,
           .name = "hertz",
           .description = "f = 8.06e4 l^(8/9) delta^(10/9) (N, mm): Palmgren's law as rounded by Teutsch & Sauer 2004",
           .is_default = true,
           .make = FromRoller{of_length<palmgren_law>}},
    LawRow{.law = Law::iso,
           .name = "iso",
           .description = "f = 35948 2^(10/9) l^(8/9) delta^(10/9) (N, mm): two in series are c_L of ISO/TS 16281",
           .make = FromRoller{of_length<iso_law>}},
    LawRow{.law = Law::lundberg,
           .name = "lundberg",
           .description = "delta = (2f/(pi l)) Sum((1-nu^2)/E) (2 ln 2 + 1/2 + ln(l/2b)): Lundberg 1939",
           .make = FromRoller{at_each<lundberg_law>}},
    LawRow{.law = Law::tripp,
           .name = "tripp",
           .description = "delta = k f ln(length^2/b^2), the lengths those of roller and ring: Tripp 1985",
           .needs_ring_thickness = true,
           .make = FromRoller{at_each<tripp_law>}},
    LawRow{.law = Law::houpert,
           .name = "houpert",
           .description = "delta = c f^(1/1.074) at the inner, c f^(1/1.078) at the outer raceway: Houpert 2001",
           .needs_ring_thickness = true,
           .make = FromRoller{at_each<houpert_law>}},
    LawRow{.law = Law::ehd_linear,
           .name = "ehd-linear",
           .description = "f = max(0, K delta + dF), a straight line through solved EHD contacts: Tsuha et al.",
           .is_default = true,
           .make = from_fits},
    LawRow{.law = Law::ehd,
           .name = "ehd",
           .description = "delta = delta_dry(f; x_0) - F(f), F the offset film of a curve through solved EHD contacts",
           .is_default = true,
           .make = from_curves},
};

consteval bool rows_follow_the_enum() {
  for (std::size_t k = 0; k < table.size(); ++k)
    if (static_cast<std::size_t>(table[k].law) != k) return false;
  return table.size() == word_count<Law>();
}
static_assert(rows_follow_the_enum(), "each law has one row, in the order of the enum");

bool is_one_of(const LawRow& row, Laws which) {
  switch (which) {
    case Laws::all: return true;
    case Laws::dry: return !row.needs_film();
    case Laws::dry_without_ring_thickness: return !row.needs_film() && !row.needs_ring_thickness;
    case Laws::from_fits: return std::holds_alternative<FromFits>(row.make);
    case Laws::by_default: return row.is_default;
    case Laws::by_default_dry: return row.is_default && !row.needs_film();
  }
  return false;
}

}  // namespace

std::span<const LawRow> law_rows() { return table; }

const LawRow& row_of(Law law) { return table.at(static_cast<std::size_t>(law)); }

std::string_view to_string(Law law) { return row_of(law).name; }

std::optional<Law> law_from(std::string_view text) { return word_from<Law>(text); }

bool needs_film(Law law) { return row_of(law).needs_film(); }
bool needs_ring_thickness(Law law) { return row_of(law).needs_ring_thickness; }

LawPair dry_laws(Law law, const RollerContact& contact) {
  const LawRow& row = row_of(law);
  if (const auto* make = std::get_if<FromRoller>(&row.make)) return (*make)(contact);
  throw std::invalid_argument("law " + std::string(row.name) + " is not dry: it needs solved contacts");
}

std::vector<Law> laws_of(Laws which) {
  std::vector<Law> laws;
  for (const LawRow& row : table)
    if (is_one_of(row, which)) laws.push_back(row.law);
  return laws;
}

std::string names_of(Laws which, std::string_view last) {
  const std::vector<Law> laws = laws_of(which);
  std::string names;
  for (std::size_t k = 0; k < laws.size(); ++k) {
    if (k > 0) names += k + 1 == laws.size() ? last : ", ";
    names += to_string(laws[k]);
  }
  return names;
}

}  // namespace ehd::bearing
