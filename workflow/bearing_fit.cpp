// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_fit.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <variant>

#include "bearing/fit.hpp"
#include "workflow/bearing_curve.hpp"
#include "workflow/bearing_notes.hpp"
#include "workflow/bearing_plan.hpp"

namespace ehd {

using bearing::BothRaceways;
using bearing::Equilibrium;
using bearing::LawPair;
using bearing::LinearFit;
using bearing::RacewayContact;
using bearing::Unloading;

namespace {

/// The line of one raceway. `dry_N`: the largest force on it that the dry balance knows.
LinearFit fitted(BearingResult& result, const BearingSetup& setup, const RacewayContact& contact, double datum_m,
                 double dry_N, const char* raceway, ContactMemory& memory) {
  const FitRange& stated = setup.body.fit;
  const double from_N = std::max(dry_N, lightest_fit_M * force_at_M_1_N(contact) / default_fit_from);
  const auto [low, high] = stated.load_N.value_or(std::pair{default_fit_from * from_N, default_fit_to * from_N});
  if (!stated.load_N && from_N > dry_N)
    result.notes.push_back(note::raised_fit(lightest_fit_M, raceway, low, default_fit_from, default_fit_from * dry_N));
  try {
    auto fit =
        bearing::fit_contacts(memory.of(contact, setup.body.lubricant->lubricant), datum_m, low, high, stated.points);
    if (const auto* failure = std::get_if<bearing::SolveFailure>(&fit)) throw LawFailure(*failure);
    return std::get<LinearFit>(std::move(fit));
  } catch (const std::invalid_argument& error) {
    throw LawFailure(error.what());
  }
}

/// Films at the rollers' loads come from the raceway's curve: a line through a fit's few points says nothing of films.
void fill_films_of_fit(BearingResult& result, const BearingSetup& setup, double largest_dry_N, ContactMemory& memory) {
  double reach_N = result.plan.runs(bearing_stage::dry) ? first_reach_N(setup, largest_dry_N) : 0;
  for (const RollerRow& row : result.rollers) reach_N = std::max({reach_N, row.inner.force_N, row.outer.force_N});
  try {
    fill_films(result, curves_of(setup, reach_N, memory));
  } catch (const LawFailure& failure) {
    result.notes.push_back(note::no_films(failure.what()));
  }
}

/// The balance with lines that are cut at delta = 0. Where the rollers of the plane form stand on the jump of the law
/// and there is no balance, the radial form is tried.
void add_cut_variant(BearingResult& result, const BearingSetup& setup) {
  const LawPair cut{result.fit->inner.law(Unloading::at_zero_approach),
                    result.fit->outer.law(Unloading::at_zero_approach)};
  auto found = bearing::balance(setup.geometry, cut, setup.loading, setup.form);
  bool radial = false;
  if (std::holds_alternative<bearing::NoEquilibrium>(found) && setup.form == bearing::Form::plane) {
    found = bearing::balance(setup.geometry, cut, setup.loading, bearing::Form::radial);
    radial = true;
  }
  if (const auto* failure = std::get_if<bearing::NoEquilibrium>(&found)) {
    result.notes.push_back(note::no_variant(failure->why));
    return;
  }
  const auto& ring = std::get<Equilibrium>(found);
  VariantResult variant{.name = "cut at delta = 0",
                        .displacement_m = ring.displacement_m,
                        .displacement_lateral_m = ring.lateral_displacement_m,
                        .balance_error = ring.balance_error,
                        .rollers = rows_of(setup, ring)};
  const bool on_jump = std::any_of(ring.rollers.begin(), ring.rollers.end(),
                                   [](const bearing::RollerState& roller) { return roller.at_jump; });
  result.notes.push_back(note::variant(variant, result.rollers, on_jump, radial));
  result.variants.push_back(std::move(variant));
}

}  // namespace

void run_linear_law(BearingResult& result, const BearingSetup& setup, bearing::FromFits make, double largest_dry_N,
                    ContactMemory& memory, bool with_films) {
  const double inner_N = largest_dry_N, outer_N = std::max(inner_N, setup.loading.centrifugal_N);
  auto inner = fitted(result, setup, setup.contacts.inner, result.datum_m->inner, inner_N, "inner", memory);
  auto outer = fitted(result, setup, setup.contacts.outer, result.datum_m->outer, outer_N, "outer", memory);
  result.fit = BothRaceways<LinearFit>{std::move(inner), std::move(outer)};
  note::add_lubricant(result.notes, setup);
  fill_balance(result, setup, balance_all_positions(setup, make(*result.fit)));
  if (!with_films || !result.plan.runs(bearing_stage::film(result.law))) return;
  fill_films_of_fit(result, setup, largest_dry_N, memory);
  note::add_fit_range(result.notes, result.fit->inner, result.rollers, &RollerRow::inner, "inner");
  note::add_fit_range(result.notes, result.fit->outer, result.rollers, &RollerRow::outer, "outer");
  if (result.plan.runs(bearing_stage::variant)) add_cut_variant(result, setup);
}

}  // namespace ehd
