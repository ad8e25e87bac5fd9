// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_balance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "contact/hertz.hpp"
#include "contact/nondimensional.hpp"
#include "workflow/bearing_of_case.hpp"

namespace ehd {

using bearing::Equilibrium;
using bearing::LawPair;
using bearing::RacewayContact;

namespace {

/// A lateral force above this part of the radial load is noted.
constexpr double negligible_lateral_force = 1e-9;

Equilibrium balanced(const BearingSetup& setup, const LawPair& laws, const bearing::Geometry& geometry) {
  auto result = bearing::balance(geometry, laws, setup.loading, setup.form);
  if (const auto* failure = std::get_if<bearing::NoEquilibrium>(&result)) throw LawFailure(failure->why);
  return std::get<Equilibrium>(std::move(result));
}

CageTurn::Range range_of(const std::vector<Equilibrium>& positions, double Equilibrium::*displacement) {
  double lowest = positions.front().*displacement, highest = lowest, sum = 0;
  for (const Equilibrium& ring : positions) {
    lowest = std::min(lowest, ring.*displacement);
    highest = std::max(highest, ring.*displacement);
    sum += ring.*displacement;
  }
  return {sum / static_cast<double>(positions.size()), highest - lowest};
}

CageTurn turn_of(const std::vector<Equilibrium>& positions) {
  CageTurn turn{.positions = static_cast<int>(positions.size()),
                .displacement_m = range_of(positions, &Equilibrium::displacement_m),
                .displacement_lateral_m = range_of(positions, &Equilibrium::lateral_displacement_m)};
  for (const Equilibrium& ring : positions)
    for (const bearing::RollerState& roller : ring.rollers)
      turn.largest_force_N = std::max(turn.largest_force_N, roller.inner.force_N);
  return turn;
}

ContactRow row_of_contact(const bearing::ContactState& state, const RacewayContact& contact) {
  ContactRow row{.force_N = state.force_N, .displacement_m = state.approach_m};
  if (state.force_N > 0) row.hertz_pressure_Pa = hertz::pressure_Pa(contact.at(state.force_N));
  return row;
}

}  // namespace

BearingSetup::BearingSetup(const BearingCase& of, bearing::Form balance_form, int positions)
    : body(of),
      form(balance_form),
      cage_positions(positions),
      contacts(raceway_contacts_of(of)),
      loading{of.operation.radial_load_N, bearing::centrifugal_force_N(of.geometry, speeds_of(of))} {}

std::vector<Equilibrium> balance_all_positions(const BearingSetup& setup, const LawPair& laws) {
  std::vector<Equilibrium> positions;
  const int count = std::max(1, setup.cage_positions);
  for (int k = 0; k < count; ++k) {
    bearing::Geometry turned = setup.body.geometry;
    turned.first_azimuth_deg += 360.0 / setup.body.geometry.rollers * k / count;
    positions.push_back(balanced(setup, laws, turned));
  }
  return positions;
}

double largest_dry_force_N(const BearingSetup& setup) {
  const LawPair hertz = bearing::dry_laws(bearing::Law::hertz, roller_contact_of(setup.body));
  double largest = 0;
  for (const bearing::RollerState& roller : balanced(setup, hertz, setup.body.geometry).rollers)
    largest = std::max(largest, roller.inner.force_N);
  return largest;
}

std::vector<RollerRow> rows_of(const BearingSetup& setup, const Equilibrium& ring) {
  std::vector<RollerRow> rows;
  for (std::size_t j = 0; j < ring.rollers.size(); ++j)
    rows.push_back({ring.azimuths_deg[j], row_of_contact(ring.rollers[j].inner, setup.contacts.inner),
                    row_of_contact(ring.rollers[j].outer, setup.contacts.outer)});
  return rows;
}

void fill_balance(BearingResult& result, const BearingSetup& setup, const std::vector<Equilibrium>& positions) {
  const Equilibrium& ring = positions.front();
  result.displacement_m = ring.displacement_m;
  result.displacement_lateral_m = ring.lateral_displacement_m;
  result.load_zone_deg = bearing::load_zone_deg(ring);
  result.geometric_load_zone_deg = geometric_load_zone_deg(result, setup.body.geometry.clearance_m);
  result.stiffness_N_per_m = ring.stiffness_N_per_m;
  result.balance_error = ring.balance_error;
  result.rollers = rows_of(setup, ring);
  result.rollers_balanced = ring.rollers_balanced;
  result.newton_iterations = ring.newton_iterations;
  if (setup.cage_positions > 0) result.cage = turn_of(positions);
  const double lateral = std::abs(ring.lateral_force_N);
  if (setup.form == bearing::Form::radial && lateral > negligible_lateral_force * setup.loading.radial_N)
    result.notes.push_back(note::LateralForce{ring.lateral_force_N});
}

void note_oil(BearingResult& result, const BearingSetup& setup) {
  result.oil = setup.body.lubricant->oil;
  if (result.oil)
    for (const std::string& note : notes_of(*result.oil)) result.notes.push_back(note::Oil{note});
  const Conditions mean = setup.contacts.inner.at(setup.loading.radial_N / setup.body.geometry.rollers);
  try {
    for (const std::string& remark : nondimensionalise(mean, setup.body.lubricant->lubricant, Flooded{}).notes)
      result.notes.push_back(note::Oil{remark});
  } catch (const StatementError&) {  // a mean load out of range says nothing about the rollers' own
  }
}

}  // namespace ehd
