// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/oil_laws.hpp"
#include "contact/text.hpp"
#include "workflow/bearing_of_case.hpp"
#include "workflow/bearing_result.hpp"
#include "workflow/case.hpp"
#include "workflow/contact_run.hpp"

namespace ehd {

namespace {

/// The contacts for which stated errors are calibrated: `ehd stress --part films`, and the findings stated-errors/ of
/// `ehd verify`. Inlets that are cut nearer than nearest_tested_cut were tested at these M alone.
constexpr double lightest_tested_M = 0.05, heaviest_tested_M = 5000, largest_tested_L = 30;
constexpr double nearest_tested_cut = -2.5, lightest_near_cut_M = 0.3, heaviest_near_cut_M = 50;

constexpr std::array table{
    UsualRange{.name = "surface speed",
               .fact = &Facts::surface_speed_m_per_s,
               .lowest = {},
               .highest = 200,
               .unit = "m/s",
               .reason = "the fastest bearings reach 3e6 mm/min x mm, 160 m/s"},
    UsualRange{.name = "viscosity",
               .fact = &Facts::viscosity_Pa_s,
               .lowest = 1e-4,
               .highest = 10,
               .unit = "Pa s",
               .reason = "from liquefied gas, some 1e-4 Pa s, to twice that of an ISO VG 320 oil at 0 degrees C"},
    UsualRange{.name = "alpha",
               .fact = &Facts::alpha_per_Pa,
               .lowest = 3e-9,
               .highest = 6e-8,
               .shown_over_SI = 1e9,
               .unit = "1/GPa",
               .reason = "water glycols have some 4 /GPa, mineral oils 15 to 30, traction fluids 40"},
    UsualRange{.name = "p_0",
               .fact = &Facts::p0_Pa,
               .lowest = 5e7,
               .highest = 1e9,
               .shown_over_SI = 1e-6,
               .unit = "MPa",
               .reason = "Roelands' own is 196 MPa, for every oil"},
    UsualRange{.name = "load",
               .fact = &Facts::load_N_per_m,
               .lowest = 1e3,
               .highest = {},
               .unit = "N/m",
               .reason = "contacts of bearings carry 1e4 to 1e6 N/m"},
    UsualRange{.name = "R",
               .fact = &Facts::reduced_radius_m,
               .lowest = 1e-4,
               .highest = 2,
               .unit = "m",
               .reason = "a needle of 1 mm on a flat has 0.0005 m, the rolls of mills some 0.5 m"},
    UsualRange{.name = "E'",
               .fact = &Facts::reduced_modulus_Pa,
               .lowest = 1e9,
               .highest = 2e12,
               .shown_over_SI = 1e-9,
               .unit = "GPa",
               .reason = "plastics have some 3 GPa, steel 226 GPa, diamond 1200 GPa"},
    UsualRange{.name = "density of the rollers",
               .fact = &Facts::roller_density_kg_per_m3,
               .lowest = 900,
               .highest = 2e4,
               .unit = "kg/m3",
               .reason = "plastics have some 1000 kg/m3, steel 7850 kg/m3, tungsten carbide 15600 kg/m3"},
    UsualRange{.name = "roughness",
               .fact = &Facts::roughness_m,
               .lowest = 1e-9,
               .highest = 2e-5,
               .shown_over_SI = 1e6,
               .unit = "um",
               .reason = "raceways have 0.05 to 0.5 um"},
    UsualRange{.name = "p_H",
               .fact = &Facts::hertz_pressure_Pa,
               .lowest = {},
               .highest = 4e9,
               .shown_over_SI = 1e-9,
               .unit = "GPa",
               .reason = "a numerical test, not a contact of steel"},
    UsualRange{.name = "thinnest film",
               .fact = &Facts::film_minimum_m,
               .lowest = 1e-9,
               .highest = {},
               .shown_over_SI = 1e9,
               .unit = "nm",
               .reason = "less than a molecule of oil is long"},
    UsualRange{.name = "rollers over the most that fit",
               .fact = &Facts::rollers_over_most,
               .lowest = {},
               .highest = 1,
               .unit = "",
               .reason = "the rollers overlap",
               .impossible = true},
    UsualRange{.name = "l/D",
               .fact = &Facts::length_over_diameter,
               .lowest = {},
               .highest = 30,
               .unit = "",
               .reason = "needle rollers reach 10, and 25 where two rows count as one"},
    UsualRange{.name = "D/d_m",
               .fact = &Facts::diameter_over_pitch,
               .lowest = 0.02,
               .highest = 0.4,
               .unit = "",
               .reason = "no catalogue has rollers that small or large in their bearing"},
    UsualRange{.name = "P_d/d_m",
               .fact = &Facts::clearance_over_pitch,
               .lowest = -2e-3,
               .highest = 2e-2,
               .unit = "",
               .reason = "clearances are about a thousandth of the diameter, and more preload than this yields steel"},
    UsualRange{.name = "M",
               .fact = &Facts::M,
               .lowest = lightest_tested_M,
               .highest = heaviest_tested_M,
               .unit = "",
               .reason = "stated errors are calibrated for M of 0.05 to 5000"},
    UsualRange{.name = "L",
               .fact = &Facts::L,
               .lowest = {},
               .highest = largest_tested_L,
               .unit = "",
               .reason = "stated errors are calibrated for L of 0 to 30"},
    UsualRange{.name = "the inlet's X",
               .fact = &Facts::cut_X,
               .lowest = {},
               .highest = nearest_tested_cut,
               .unit = "",
               .reason =
                   "stated errors are calibrated for cuts at -2.5 and before; nearer ones were tested at M of 0.3 "
                   "to 50"},
};

/// The larger or the smaller of a number and one that may be absent.
template <class Choose>
void keep(std::optional<double>& kept, const std::optional<double>& value, Choose choose) {
  if (value) kept = kept ? choose(*kept, *value) : *value;
}

/// What the viscosity law of the oil reads.
void put_oil(Facts& facts, const Lubricant& oil) {
  const LawKeys keys = row_of(oil.viscosity).keys;
  if (keys.alpha_per_Pa) facts.alpha_per_Pa = oil.alpha_per_Pa;
  if (keys.p0_Pa) facts.p0_Pa = oil.p0_Pa;
}

}  // namespace

std::span<const UsualRange> usual_ranges() { return table; }

Facts facts_of(const ContactCase& contact, const ContactRun& run) {
  Facts facts;
  if (contact.lubricant) put_oil(facts, *contact.lubricant);
  if (run.groups) {
    facts.M = run.groups->M;
    facts.L = run.groups->L;
    const bool near_cuts_tested = *facts.M >= lightest_near_cut_M && *facts.M <= heaviest_near_cut_M;
    const auto* cut = contact.inlet ? std::get_if<TruncatedAt>(&*contact.inlet) : nullptr;
    if (cut && !near_cuts_tested) facts.cut_X = cut->x;
  }
  if (run.scales) facts.hertz_pressure_Pa = run.scales->hertz_pressure_Pa;
  const auto film = run.solution.observables.find(Quantity::film_minimum);
  const std::optional<double> scale = run.m_per_hertz_film();
  if (film != run.solution.observables.end() && scale) facts.film_minimum_m = *scale * film->second.value;
  const auto* conditions = std::get_if<Conditions>(&contact.statement);
  if (!conditions) return facts;
  if (conditions->speed_sum_m_per_s) facts.surface_speed_m_per_s = std::abs(*conditions->speed_sum_m_per_s) / 2;
  facts.viscosity_Pa_s = conditions->viscosity_Pa_s;
  facts.load_N_per_m = conditions->load_N_per_m;
  facts.reduced_radius_m = conditions->reduced_radius_m;
  facts.reduced_modulus_Pa = conditions->reduced_modulus_Pa;
  return facts;
}

Facts facts_of(const BearingCase& body, const std::vector<RollerRow>& rollers) {
  const bearing::Geometry& geometry = body.geometry;
  const double d_m = geometry.pitch_diameter_m, D = geometry.roller_diameter_m;
  const bearing::Speeds speeds = speeds_of(body);
  Facts facts;
  facts.surface_speed_m_per_s =
      std::max(std::abs(speeds.inner_rad_per_s) * (d_m - D) / 2, std::abs(speeds.outer_rad_per_s) * (d_m + D) / 2);
  if (body.lubricant) {
    facts.viscosity_Pa_s = body.lubricant->viscosity_Pa_s;
    put_oil(facts, body.lubricant->lubricant);
  }
  facts.roughness_m = body.roughness_m;
  facts.reduced_modulus_Pa = bearing::reduced_modulus_Pa(body.modulus_Pa, body.poisson);
  facts.roller_density_kg_per_m3 = geometry.density_kg_per_m3;
  facts.rollers_over_most = static_cast<double>(geometry.rollers) / bearing::most_rollers(d_m, D);
  facts.length_over_diameter = geometry.length_m / D;
  facts.diameter_over_pitch = D / d_m;
  facts.clearance_over_pitch = geometry.clearance_m / d_m;
  for (const RollerRow& row : rollers)
    for (const ContactRow* at : {&row.inner, &row.outer}) {
      keep(facts.hertz_pressure_Pa, at->hertz_pressure_Pa, [](double a, double b) { return std::max(a, b); });
      keep(facts.film_minimum_m, at->film_minimum_m, [](double a, double b) { return std::min(a, b); });
    }
  return facts;
}

std::vector<Unusual> unusual(const Facts& facts) {
  std::vector<Unusual> found;
  for (const UsualRange& range : table) {
    const std::optional<double>& value = facts.*range.fact;
    if (!value) continue;
    if ((range.lowest && *value < *range.lowest) || (range.highest && *value > *range.highest))
      found.push_back({.range = &range, .value = *value});
  }
  return found;
}

std::string sentence_of(const Unusual& unusual) {
  const UsualRange& range = *unusual.range;
  const bool above = range.highest && unusual.value > *range.highest;
  const auto shown = [&](double value, int digits) {
    return plain(range.shown_over_SI * value, digits) + (range.unit.empty() ? "" : " " + std::string(range.unit));
  };
  return fmt::format("{} = {} is {} {}: {}", range.name, shown(unusual.value, 4), above ? "above" : "below",
                     shown(above ? *range.highest : *range.lowest, 3), range.reason);
}

}  // namespace ehd
