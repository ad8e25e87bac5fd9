// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string_view>
#include <variant>

#include "bearing/film_curve.hpp"
#include "bearing/fit.hpp"
#include "bearing/force_law.hpp"
#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "workflow/bearing_balance.hpp"
#include "workflow/bearing_curve.hpp"
#include "workflow/bearing_datum.hpp"
#include "workflow/bearing_dynamics.hpp"
#include "workflow/bearing_errors.hpp"
#include "workflow/bearing_fit.hpp"
#include "workflow/bearing_of_case.hpp"
#include "workflow/plausibility.hpp"

namespace ehd {

using bearing::BothRaceways;
using bearing::FilmCurve;
using bearing::LawPair;

std::vector<bearing::Law> default_laws(const BearingCase& body) {
  return bearing::laws_of(body.lubricant ? bearing::Laws::by_default : bearing::Laws::by_default_dry);
}

namespace {

/// Balances with one law, in the way that its row of bearing/law_table names: a new way does not compile until it has a
/// line here.
struct RunOfLaw {
  BearingResult& result;
  const BearingSetup& setup;
  bool with_films;
  ContactMemory& memory;

  void operator()(bearing::FromRoller make) const {
    fill_balance(result, setup, balance_all_positions(setup, make(roller_contact_of(setup.body))));
  }
  void operator()(bearing::FromFits make) const {
    const double largest_dry_N = prepare();
    run_linear_law(result, setup, make, largest_dry_N, memory, with_films);
  }
  void operator()(bearing::FromCurves make) const {
    const double largest_dry_N = prepare();
    run_curve_law(result, setup, make, largest_dry_N, memory);
  }

 private:
  /// What every law with films needs first: the dry balance, where the plan has it, and the datum.
  [[nodiscard]] double prepare() const {
    const double largest_dry_N = result.plan.runs(bearing_stage::dry) ? largest_dry_force_N(setup) : 0;
    const DatumOfCase datum = datum_of(setup, largest_dry_N);
    result.datum_m = datum.x0_m;
    result.notes.emplace_back(datum.note);
    return largest_dry_N;
  }
};

void fill_lambda_ratios(BearingResult& result, const BearingCase& body) {
  if (!result.plan.runs(bearing_stage::lambda)) return;
  for (RollerRow& row : result.rollers)
    for (ContactRow* at : {&row.inner, &row.outer})
      if (at->film_minimum_m) at->lambda_ratio = *at->film_minimum_m / *body.roughness_m;
}

void note_limits(BearingResult& result) {
  double smallest_ratio = std::numeric_limits<double>::infinity();
  for (const RollerRow& row : result.rollers)
    for (const ContactRow* at : {&row.inner, &row.outer})
      smallest_ratio = std::min(smallest_ratio, at->lambda_ratio.value_or(smallest_ratio));
  if (smallest_ratio < 1) result.notes.push_back(note::ThinFilm{smallest_ratio});
}

/// The contacts of one raceway that missed their tolerance, among those that this law's curve and fit are made of.
std::size_t missed_contacts(const FilmCurve* curve, const bearing::LinearFit* fit) {
  std::set<double> missed_N;
  if (curve) missed_N.insert(curve->errors().missed_N.begin(), curve->errors().missed_N.end());
  if (fit)
    for (const bearing::FitPoint& point : fit->points)
      if (!point.converged) missed_N.insert(point.force_N);
  return missed_N.size();
}

/// Between two points of the curve no contact could be solved: its error there is not known.
bool has_unjudged_gap(const FilmCurve& curve) {
  return !std::isfinite(curve.errors().interpolation + curve.errors().interpolation_force);
}

/// Whether a limit on iterations or time ended the curves of a result, or kept it from having any.
bool limit_ended_films(const BearingResult& result) {
  if (result.curve) return result.curve->inner.errors().cut_short || result.curve->outer.errors().cut_short;
  return std::any_of(result.notes.begin(), result.notes.end(), [](const BearingNote& note) {
    const auto* none = std::get_if<note::NoFilms>(&note);
    return none && none->limit;
  });
}

/// A balance is no better than the contacts that its law and films are made of. The memory holds contacts of other laws
/// and cases too; they do not count.
void judge_contacts(BearingResult& result) {
  const bool limit = limit_ended_films(result);
  if (limit) {
    result.status = StopReason::limit_reached;
    result.why = limit_ended_film_curves;
  }
  if (result.curve && (has_unjudged_gap(result.curve->inner) || has_unjudged_gap(result.curve->outer))) {
    if (!limit) result.status = StopReason::tolerance_not_met;
    result.why += fmt::format(
        "{}no contact could be solved between two points of a film curve; so errors of forces and films "
        "are not known",
        limit ? "; " : "");
    return;
  }
  if (limit) return;
  const std::size_t missed =
      missed_contacts(result.curve ? &result.curve->inner : nullptr, result.fit ? &result.fit->inner : nullptr) +
      missed_contacts(result.curve ? &result.curve->outer : nullptr, result.fit ? &result.fit->outer : nullptr);
  if (missed == 0) return;
  result.status = StopReason::tolerance_not_met;
  result.why = fmt::format("{} of the raceways' solved contacts have an estimated film error above 1e-3", missed);
}

StopReason reason_of(const LawFailure& failure) {
  return failure.limit() ? StopReason::limit_reached : StopReason::diverged;
}

/// The balance stays where its contacts have no response.
void add_motion(BearingResult& result, const BearingSetup& setup, const BearingRequest& request,
                ContactMemory& memory) {
  try {
    fill_dynamics(result, setup, *laws_of(setup.body, result), request.frequencies_Hz, memory);
  } catch (const LawFailure& failure) {
    result.status = reason_of(failure);
    result.why += fmt::format("{}the bearing is balanced, but its stiffness and damping in motion are not known: {}",
                              result.why.empty() ? "" : "; ", failure.what());
  }
}

void carry_through(BearingResult& result, const BearingSetup& setup, const BearingRequest& request,
                   ContactMemory& memory) {
  try {
    std::visit(RunOfLaw{result, setup, request.films, memory}, bearing::row_of(result.law).make);
    result.status = StopReason::converged;
    fill_lambda_ratios(result, setup.body);
    fill_torque(result, setup);
    note_limits(result);
    judge_contacts(result);
    if (result.plan.runs(bearing_stage::dynamics)) add_motion(result, setup, request, memory);
  } catch (const LawFailure& failure) {
    result.status = reason_of(failure);
    result.why = failure.what();
    result.rollers.clear();
  }
  // A bearing without a balance needs these most: a slip of a unit may be why.
  for (const Unusual& one : unusual(facts_of(setup.body, result.rollers))) result.notes.emplace_back(one);
}

/// Keys of [datum] that the case states and its law of the datum does not read.
void note_unread_datum(BearingResult& result, const Case& bearing_case) {
  struct Reader {
    const char* key;
    std::string_view law;
  };
  constexpr std::array readers{Reader{"load_N", PalmgrenDatum::name}, Reader{"x0_m", LengthDatum::name}};
  const auto& datum = std::get<BearingCase>(bearing_case.body).datum;
  const std::string_view law = std::visit([](const auto& one) { return one.name; }, datum);
  for (const Reader& reader : readers)
    if (reader.law != law && bearing_case.places.contains(std::string("datum.") + reader.key))
      result.notes.push_back(note::UnreadDatum{reader.key, std::string(law), std::string(reader.law)});
}

BearingResult run_law(const Case& bearing_case, const BearingRequest& request, const BearingSetup& setup,
                      bearing::Law law, Plan plan, ContactMemory& memory) {
  const auto begin = std::chrono::steady_clock::now();
  const long solves = memory.solves(), recalls = memory.recalls(), responses = memory.responses();
  BearingResult result;
  result.case_id = bearing_case.id;
  result.version = bearing_case.version;
  result.law = law;
  result.form = request.form;
  result.plan = std::move(plan);
  if (needs_film(law)) note_unread_datum(result, bearing_case);
  carry_through(result, setup, request, memory);
  result.contact_solves = memory.solves() - solves;
  result.contact_recalls = memory.recalls() - recalls;
  result.responses = memory.responses() - responses;
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

/// The most loaded roller carries at least the radial load over the number of rollers. Beyond largest_M no contact with
/// a film is solved.
void require_solvable_load(const Case& bearing_case, const BearingCase& body) {
  const auto contacts = raceway_contacts_of(body);
  const double rollers = body.geometry.rollers;
  const double most_N = largest_M * rollers * std::min(force_at_M_1_N(contacts.inner), force_at_M_1_N(contacts.outer));
  if (body.operation.radial_load_N <= most_N) return;
  throw case_error(bearing_case, "operation.radial_load_N",
                   fmt::format("gives a roller more than M = {}, where no contact with a film is solved; allowed with "
                               "this speed and oil is up to {} N, or a dry law ({})",
                               plain(largest_M), plain(most_N, 3), bearing::names_of(bearing::Laws::dry)));
}

/// A raceway has the same L at every force. So one contact, that of M = 1, tells whether L is in its range, beyond
/// which no contact with a film is solved. The refusal also names unusual numbers: one of them may have a wrong unit.
void require_solvable_oil(const Case& bearing_case, const BearingCase& body) {
  const auto contacts = raceway_contacts_of(body);
  for (const bearing::Raceway raceway : bearing::both_raceways) {
    const bearing::RacewayContact& contact = contacts.at(raceway);
    try {
      (void)nondimensionalise(contact.at(force_at_M_1_N(contact)), body.lubricant->lubricant, Flooded{});
    } catch (const StatementError& error) {
      if (error.key() != "L") continue;  // the contacts say what else is wrong
      std::string why = fmt::format(
          "at the {} raceway {}; a thinner oil or a lower speed makes L smaller, and a dry law ({}) needs no oil",
          to_string(raceway), error.what(), bearing::names_of(bearing::Laws::dry));
      for (const Unusual& one : unusual(facts_of(body, {}))) why += "; " + sentence_of(one);
      throw case_error(bearing_case, "lubricant", why);
    }
  }
}

}  // namespace

void require_possible(const Case& bearing_case, const BearingRequest& request) {
  const auto& body = std::get<BearingCase>(bearing_case.body);
  for (const bearing::Law law : request.laws) {
    if (needs_ring_thickness(law) && !body.ring_thickness_m)
      throw case_error(bearing_case, "bearing.ring_thickness_m",
                       fmt::format("is missing; law {} needs it at the outer raceway (allowed without: {})",
                                   to_string(law), bearing::names_of(bearing::Laws::dry_without_ring_thickness)));
    if (!needs_film(law)) continue;
    if (!body.lubricant && request.explicitly)
      throw case_error(bearing_case, "lubricant",
                       fmt::format("is missing; law {} needs it (allowed without: the dry laws, {})", to_string(law),
                                   bearing::names_of(bearing::Laws::dry)));
    if (!body.lubricant || !at_rest(body)) continue;
    const std::string both = "operation.inner_speed_rpm", one = "operation.speed_rpm";
    throw case_error(bearing_case, bearing_case.places.contains(both) ? both : one,
                     fmt::format("leaves the rings at rest against each other, where law {} does not exist; allowed is "
                                 "a relative speed, or a dry law ({})",
                                 to_string(law), bearing::names_of(bearing::Laws::dry)));
  }
  if (!body.lubricant || std::none_of(request.laws.begin(), request.laws.end(), bearing::needs_film)) return;
  require_solvable_oil(bearing_case, body);
  require_solvable_load(bearing_case, body);
}

std::vector<BearingResult> run_bearing(const Case& bearing_case, const BearingRequest& request, ContactMemory& memory) {
  require_possible(bearing_case, request);
  const auto& body = std::get<BearingCase>(bearing_case.body);
  const BearingSetup setup(body, request.form, request.cage_positions);
  std::vector<BearingResult> results;
  for (const bearing::Law law : request.laws) {
    Plan plan = plan_bearing(body, {law}, request.form, request.cage_positions, !request.frequencies_Hz.empty());
    if (plan.runs(bearing_stage::balance(law)))
      results.push_back(run_law(bearing_case, request, setup, law, std::move(plan), memory));
  }
  if (const BearingResult* full = full_relation_in(results))
    for (BearingResult& result : results) {
      if (result.fit && !result.rollers.empty()) judge_use_beside(result, *full);
      result.errors = sum_of(numerical_budget(body, result, *full));
    }
  return results;
}

namespace {

/// The laws of a result, by how the law's row makes them.
struct LawsOfResult {
  const BearingCase& body;
  const BearingResult& result;

  std::optional<LawPair> operator()(bearing::FromRoller make) const { return make(roller_contact_of(body)); }
  std::optional<LawPair> operator()(bearing::FromFits make) const {
    return result.fit ? std::optional(make(*result.fit)) : std::nullopt;
  }
  std::optional<LawPair> operator()(bearing::FromCurves make) const {
    if (!result.curve || !result.datum_m) return std::nullopt;
    return make({std::make_shared<const FilmCurve>(result.curve->inner),
                 std::make_shared<const FilmCurve>(result.curve->outer)},
                *result.datum_m);
  }
};

}  // namespace

std::optional<LawPair> laws_of(const BearingCase& body, const BearingResult& result) {
  return std::visit(LawsOfResult{body, result}, bearing::row_of(result.law).make);
}

}  // namespace ehd
