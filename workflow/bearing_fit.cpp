// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_fit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "bearing/equilibrium.hpp"
#include "bearing/film_curve.hpp"
#include "bearing/fit.hpp"
#include "bearing/force_law.hpp"
#include "workflow/bearing_curve.hpp"
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
LinearFit fitted(BearingResult& result, const BearingSetup& setup, bearing::Raceway raceway, double dry_N,
                 ContactMemory& memory) {
  const FitRange& stated = setup.body.fit;
  const RacewayContact& contact = setup.contacts.at(raceway);
  const double from_N = std::max(dry_N, lightest_fit_M * force_at_M_1_N(contact) / default_fit_from);
  const auto [low, high] = stated.load_N.value_or(std::pair{default_fit_from * from_N, default_fit_to * from_N});
  if (!stated.load_N && from_N > dry_N)
    result.notes.push_back(note::RaisedFit{.raceway = raceway, .from_N = low, .unraised_N = default_fit_from * dry_N});
  try {
    auto fit = bearing::fit_contacts(memory.of(contact, setup.body.lubricant->lubricant), result.datum_m->at(raceway),
                                     low, high, stated.points, stated.of);
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
    result.notes.push_back(note::NoFilms{.why = failure.what(), .limit = failure.limit()});
  }
}

/// The solver's own relation at a raceway; absent without a curve, and where the datum allows none.
std::optional<bearing::CurveLaw> solved_law(const BearingResult& result, bearing::Raceway raceway) {
  if (!result.curve) return std::nullopt;
  try {
    return bearing::CurveLaw(std::make_shared<const bearing::FilmCurve>(result.curve->at(raceway)),
                             result.datum_m->at(raceway));
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

LinearFit& fit_at(BearingResult& result, bearing::Raceway raceway) {
  return raceway == bearing::Raceway::inner ? result.fit->inner : result.fit->outer;
}

/// How far the line is off at the loaded contacts of this bearing (bearing::is_loaded). Without the solver's relation
/// the fit alone says that, and nothing is known outside of its range.
void judge_use(BearingResult& result, bearing::Raceway raceway) {
  LinearFit& fit = fit_at(result, raceway);
  const auto solved = solved_law(result, raceway);
  bearing::LineInUse use{.lightest_N = std::numeric_limits<double>::infinity()};
  for (const RollerRow& row : result.rollers) use.heaviest_N = std::max(use.heaviest_N, row.at(raceway).force_N);
  for (const RollerRow& row : result.rollers) {
    const ContactRow& at = row.at(raceway);
    if (!bearing::is_loaded(at.force_N, use.heaviest_N)) continue;
    use.lightest_N = std::min(use.lightest_N, at.force_N);
    if (solved) use.residual_N = std::max(use.residual_N, std::abs(at.force_N - solved->force(at.displacement_m)));
  }
  if (use.heaviest_N == 0) return;
  const bool in_range = use.lightest_N >= fit.points.front().force_N && use.heaviest_N <= fit.points.back().force_N;
  if (!solved && !in_range) use.residual_N = std::nan("");
  fit.in_use = use;
}

/// Before all other notes: nothing else of such a result is to be read first. Takes the place of earlier such notes.
void note_poor_lines(BearingResult& result) {
  std::erase_if(result.notes, [](const BearingNote& note) { return std::holds_alternative<note::PoorLine>(note); });
  auto at = result.notes.begin();
  for (const auto raceway : bearing::both_raceways)
    if (!result.fit->at(raceway).describes_contacts())
      at = std::next(result.notes.insert(at, note::PoorLine{.raceway = raceway}));
}

void note_outside_fit(BearingResult& result, bearing::Raceway raceway) {
  const auto& points = result.fit->at(raceway).points;
  note::OutsideFit outside{.raceway = raceway, .lightest_N = std::numeric_limits<double>::infinity()};
  for (const RollerRow& row : result.rollers) {
    const double f = row.at(raceway).force_N;
    if (!(f > 0) || (f >= points.front().force_N && f <= points.back().force_N)) continue;
    ++outside.contacts;
    outside.lightest_N = std::min(outside.lightest_N, f);
    outside.heaviest_N = std::max(outside.heaviest_N, f);
  }
  if (outside.contacts > 0) result.notes.push_back(outside);
}

/// The balance with lines that are cut at delta = 0. Where the rollers of the plane form stand on the jump of the law
/// and there is no balance, the radial form is tried.
void add_cut_variant(BearingResult& result, const BearingSetup& setup) {
  const LawPair cut{result.fit->inner.law(Unloading::at_zero_approach),
                    result.fit->outer.law(Unloading::at_zero_approach)};
  auto found = bearing::balance(setup.body.geometry, cut, setup.loading, setup.form);
  bool radial = false;
  if (std::holds_alternative<bearing::NoEquilibrium>(found) && setup.form == bearing::Form::plane) {
    found = bearing::balance(setup.body.geometry, cut, setup.loading, bearing::Form::radial);
    radial = true;
  }
  if (const auto* failure = std::get_if<bearing::NoEquilibrium>(&found)) {
    result.notes.push_back(note::NoVariant{failure->why});
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
  result.notes.push_back(note::CutVariant{.on_jump = on_jump, .radial = radial});
  result.variants.push_back(std::move(variant));
}

}  // namespace

void run_linear_law(BearingResult& result, const BearingSetup& setup, bearing::FromFits make, double largest_dry_N,
                    ContactMemory& memory, bool with_films) {
  const double inner_N = largest_dry_N, outer_N = std::max(inner_N, setup.loading.centrifugal_N);
  auto inner = fitted(result, setup, bearing::Raceway::inner, inner_N, memory);
  auto outer = fitted(result, setup, bearing::Raceway::outer, outer_N, memory);
  result.fit = BothRaceways<LinearFit>{std::move(inner), std::move(outer)};
  note_poor_lines(result);  // of the fits alone: there may be no balance
  note_oil(result, setup);
  fill_balance(result, setup, balance_all_positions(setup, make(*result.fit)));
  const bool films = with_films && result.plan.runs(bearing_stage::film(result.law));
  if (films) fill_films_of_fit(result, setup, largest_dry_N, memory);
  for (const auto raceway : bearing::both_raceways) judge_use(result, raceway);
  note_poor_lines(result);
  if (!films) return;
  note_outside_fit(result, bearing::Raceway::inner);
  note_outside_fit(result, bearing::Raceway::outer);
  if (result.plan.runs(bearing_stage::variant)) add_cut_variant(result, setup);
}

void judge_use_beside(BearingResult& result, const BearingResult& full) {
  for (const auto raceway : bearing::both_raceways) {
    LinearFit& fit = fit_at(result, raceway);
    if (!fit.in_use) continue;
    bearing::LineInUse& use = *fit.in_use;
    for (std::size_t j = 0; j < result.rollers.size(); ++j) {
      const ContactRow& at = full.rollers[j].at(raceway);
      const bool by_line = bearing::is_loaded(result.rollers[j].at(raceway).force_N, use.heaviest_N);
      if (by_line || !bearing::is_loaded(at.force_N, use.heaviest_N)) continue;
      use.lightest_N = std::min(use.lightest_N, at.force_N);
      use.residual_N = std::max(use.residual_N, std::abs(at.force_N - fit.law().force(at.displacement_m)));
    }
  }
  note_poor_lines(result);
}

}  // namespace ehd
