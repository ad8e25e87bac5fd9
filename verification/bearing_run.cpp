// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bearing_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "contact/approach.hpp"
#include "contact/hertz.hpp"
#include "contact/nondimensional.hpp"
#include "verification/text.hpp"

namespace ehd::verification {

using bearing::CurveLaw;
using bearing::Equilibrium;
using bearing::FilmCurve;
using bearing::LawPair;
using bearing::LinearFit;
using bearing::RacewayContact;
using bearing::SolvedContact;
using bearing::SolvedContacts;
using bearing::SolveFailure;
using bearing::Unloading;

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

bearing::Geometry geometry_of(const BearingCase& body) {
  return {.rollers = body.geometry.rollers,
          .pitch_diameter_m = body.geometry.pitch_diameter_m,
          .roller_diameter_m = body.geometry.roller_diameter_m,
          .length_m = body.geometry.length_m,
          .clearance_m = body.geometry.clearance_m,
          .density_kg_per_m3 = body.geometry.density_kg_per_m3,
          .first_azimuth_deg = body.geometry.first_azimuth_deg};
}

bearing::RollerContact roller_contact_of(const BearingCase& body) {
  return {.force_N = 0,
          .length_m = body.geometry.length_m,
          .roller_diameter_m = body.geometry.roller_diameter_m,
          .pitch_diameter_m = body.geometry.pitch_diameter_m,
          .modulus_Pa = body.modulus_Pa,
          .poisson = body.poisson,
          .ring_thickness_m = body.geometry.ring_thickness_m.value_or(std::numeric_limits<double>::quiet_NaN())};
}

namespace {
constexpr BearingLaw all_laws[] = {BearingLaw::hertz, BearingLaw::iso,        BearingLaw::lundberg, BearingLaw::tripp,
                                   BearingLaw::houpert, BearingLaw::ehd_linear, BearingLaw::ehd};
constexpr double steel_limit_Pa = 4e9;  // above it a result is a numerical test
}  // namespace

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

std::vector<BearingLaw> default_laws(const BearingCase& bearing) {
  if (!bearing.lubricant) return {BearingLaw::hertz};
  return {BearingLaw::hertz, BearingLaw::ehd_linear, BearingLaw::ehd};
}

// ---- What a case says, in the words of bearing/ -----------------------------------------------------------------

namespace {

bearing::Speeds speeds_of(const BearingCase& body) {
  return bearing::speeds_from_rpm(body.operation.inner_speed_rpm, body.operation.outer_speed_rpm);
}

RacewayContact contact_of(const BearingCase& body, bearing::Raceway raceway) {
  const bearing::Geometry geometry = geometry_of(body);
  return {.length_m = geometry.length_m,
          .reduced_radius_m = bearing::reduced_radius_m(geometry, raceway),
          .reduced_modulus_Pa = bearing::reduced_modulus_Pa(body.modulus_Pa, body.poisson),
          .speed_sum_m_per_s = bearing::sum_speed_m_per_s(geometry, speeds_of(body)),
          .viscosity_Pa_s = body.lubricant ? body.lubricant->viscosity_Pa_s : 0};
}

BothRaceways<RacewayContact> contacts_of(const BearingCase& body) {
  return {contact_of(body, bearing::Raceway::inner), contact_of(body, bearing::Raceway::outer)};
}

bool at_rest(const BearingCase& body) { return !(bearing::sum_speed_m_per_s(geometry_of(body), speeds_of(body)) > 0); }

bool contains(const std::vector<BearingLaw>& laws, BearingLaw law) {
  return std::find(laws.begin(), laws.end(), law) != laws.end();
}

bool datum_from_dry(const BearingCase& body) {
  const auto* palmgren = std::get_if<PalmgrenDatum>(&body.datum);
  return palmgren && !palmgren->load_N;
}

}  // namespace

// ---- The plan -----------------------------------------------------------------------------------------------------

std::string bearing_stage::balance(BearingLaw law) { return "balance: " + std::string(to_string(law)); }
std::string bearing_stage::film(BearingLaw law) { return "film at each roller: " + std::string(to_string(law)); }

Plan plan_bearing(const BearingCase& body, const std::vector<BearingLaw>& asked, bearing::Form form,
                  int cage_positions) {
  Plan plan;
  const auto decide = [&plan](std::string_view stage, const std::string& why_skipped = "") {
    if (why_skipped.empty()) {
      plan.run.emplace_back(stage);
    } else {
      plan.skipped.push_back({std::string(stage), why_skipped});
    }
  };
  const std::string no_film = !body.lubricant ? "the case has no lubricant"
                              : at_rest(body) ? "the rings do not move against each other: no film"
                                              : "";
  const bool linear = no_film.empty() && contains(asked, BearingLaw::ehd_linear);
  const bool full = no_film.empty() && contains(asked, BearingLaw::ehd);
  const bool film = linear || full;
  const std::string why_no_film = !no_film.empty() ? no_film : "no law with a film is asked for";

  decide(bearing_stage::geometry);
  const auto azimuths = bearing::azimuths_deg(geometry_of(body));
  const auto cages = bearing::mirror_groups(azimuths);
  const int mirrored = body.geometry.rollers - static_cast<int>(cages.size());
  if (mirrored > 0)
    decide("balance of mirrored rollers", std::to_string(mirrored) + " of " + std::to_string(body.geometry.rollers) +
                                              " rollers mirror another and carry the same");
  decide(bearing_stage::across, form == bearing::Form::radial        ? "the radial form is asked for"
                                : bearing::symmetric_to_load(azimuths) ? "the cage stands symmetric to the load, and so does the ring"
                                                                       : "");
  decide(bearing_stage::cage, cage_positions > 0 ? "" : "not asked for (--cage-positions N)");
  decide(bearing_stage::dry, !film                                              ? why_no_film
                             : full || datum_from_dry(body) || !body.fit.load_N ? ""
                                                                                : "datum and fit range are stated");
  decide(bearing_stage::datum, film ? "" : why_no_film);
  decide(bearing_stage::solves, film ? "" : why_no_film);
  if (film) {
    decide("second solve of an equal contact",
           "a load already solved at a raceway is taken from memory, by every law, clearance and case");
    decide("quantities beside film.minimum, film.central and film.offset", "not asked for: the laws need no others");
  }
  decide(bearing_stage::fit, linear ? "" : film ? "ehd-linear is not asked for" : why_no_film);
  decide(bearing_stage::curve, film ? "" : why_no_film);
  for (const BearingLaw law : all_laws) {
    const bool possible = !needs_film(law) || no_film.empty();
    const bool no_ring = needs_ring_thickness(law) && !body.geometry.ring_thickness_m;
    decide(bearing_stage::balance(law), !contains(asked, law) ? "not asked for"
                                        : !possible           ? no_film
                                        : no_ring             ? "bearing.ring_thickness_m is not stated"
                                                              : "");
    if (!contains(asked, law)) continue;
    decide(bearing_stage::film(law), !needs_film(law) ? "a dry law has no film" : possible ? "" : no_film);
  }
  decide(bearing_stage::variant, linear ? "" : film ? "ehd-linear is not asked for" : why_no_film);
  decide(bearing_stage::lambda, !film                        ? why_no_film
                                : !body.geometry.roughness_m ? "bearing.roughness_m is not stated"
                                                             : "");
  return plan;
}

// ---- Contacts that were solved -------------------------------------------------------------------------------------

ContactMemory::ContactMemory(ContactSolver solver, Request request)
    : solver_(std::move(solver)), request_(std::move(request)) {}

Request ContactMemory::bearing_request() {
  Request request;
  request.tolerance = 1e-4;
  return request;
}

namespace {

bearing::ContactResult solve_contact(const RacewayContact& contact, const Lubricant& lubricant,
                                     const ContactSolver& solver, const Request& request, double load_N_per_m) {
  const Conditions conditions = contact.at(load_N_per_m * contact.length_m);
  Nondimensional reading;
  try {
    reading = nondimensionalise(conditions, lubricant, Flooded{});
  } catch (const StatementError& error) {
    return SolveFailure{.why = error.what()};
  }
  reading.problem.wanted = {Quantity::film_minimum, Quantity::film_central, Quantity::film_offset};
  // Asked for is a tenth of what a contact law needs of its points. Where that is not met, the need itself is asked for: on
  // finer and finer grids a spike that meets X = 0 only blurs what a coarser one knew.
  constexpr double needed = 1e-3;
  Solution solution = solver(reading.problem, request);
  if (solution.record.status == StopReason::tolerance_not_met && request.tolerance.value_or(needed) < needed) {
    Request less = request;
    less.tolerance = needed;
    if (Solution again = solver(reading.problem, less); again.record.status == StopReason::converged)
      solution = std::move(again);
  }
  const StopReason status = solution.record.status;
  const std::string groups =
      "M = " + plain(reading.problem.groups.M, 4) + ", L = " + plain(reading.problem.groups.L, 4) + ": ";
  if (status != StopReason::converged && status != StopReason::tolerance_not_met)
    return SolveFailure{.why = groups + std::string(to_string(status)) +
                               (solution.record.reason.empty() ? "" : " (" + solution.record.reason + ")"),
                        .limit = status == StopReason::limit_reached};
  const auto film = solution.observables.find(Quantity::film_minimum);
  const auto offset = solution.observables.find(Quantity::film_offset);
  if (film == solution.observables.end() || offset == solution.observables.end() || !offset->second.error ||
      !film->second.error)
    return SolveFailure{.why = groups + "the solver gives no film.minimum or film.offset with an error"};
  // A film that is a small part of the approach need not be known as well as one that is all of it: what it does to the
  // contact force counts too, against the dry approach with x_0 = l.
  constexpr double largest_offset_error = 1e-2;  // more than a per cent of film, and of force, is no solution for a bearing
  const double force_N = load_N_per_m * contact.length_m, b = hertz::half_width_m(conditions);
  const double dry_offset = dry_approach_m(contact.at(force_N), contact.length_m) * contact.reduced_radius_m / (b * b);
  const double offset_film = offset->second.value - hertz::dry_offset();
  const auto known_to = [&](double share) { return *offset->second.error <= share * std::max(offset_film, dry_offset / 10); };
  if (!known_to(largest_offset_error))
    return SolveFailure{.why = groups + "the offset film is known to " + plain(*offset->second.error / offset_film, 2) +
                        " of itself only, and to more than " + plain(largest_offset_error) +
                        " of a tenth of the approach"};
  return SolvedContact{.offset = offset->second.value,
                       .offset_error = *offset->second.error,
                       .film_minimum_m = film->second.value * *reading.scales->film_m_per_hertz_film(),
                       .film_error = *film->second.error,
                       .converged = status == StopReason::converged || (*film->second.error <= needed && known_to(needed))};
}

}  // namespace

ContactMemory::Raceway& ContactMemory::raceway(const RacewayContact& contact, const Lubricant& lubricant) {
  const Key key{contact, lubricant.viscosity, lubricant.density, lubricant.alpha_per_Pa, lubricant.z, lubricant.p0_Pa};
  Raceway& raceway = raceways_[key];
  if (!raceway.contacts)
    raceway.contacts = std::make_unique<SolvedContacts>(
        contact, [contact, lubricant, solver = solver_, request = request_](double load_N_per_m) {
          return solve_contact(contact, lubricant, solver, request, load_N_per_m);
        });
  return raceway;
}

SolvedContacts& ContactMemory::of(const RacewayContact& contact, const Lubricant& lubricant) {
  return *raceway(contact, lubricant).contacts;
}

const std::variant<FilmCurve, SolveFailure>& ContactMemory::curve(const RacewayContact& contact,
                                                                  const Lubricant& lubricant,
                                                                  const bearing::CurveRequest& request) {
  Raceway& of = raceway(contact, lubricant);
  const bearing::CurveRequest key = bearing::as_met(request);
  const auto known = of.curves.find(key);
  if (known == of.curves.end()) return of.curves.emplace(key, bearing::build_curve(*of.contacts, key)).first->second;
  if (const auto* curve = std::get_if<FilmCurve>(&known->second))
    curve_recalls_ += static_cast<long>(curve->forces_N().size());
  return known->second;
}

long ContactMemory::solves() const {
  long sum = 0;
  for (const auto& raceway : raceways_) sum += raceway.second.contacts->solves();
  return sum;
}

long ContactMemory::recalls() const {
  long sum = curve_recalls_;
  for (const auto& raceway : raceways_) sum += raceway.second.contacts->recalls();
  return sum;
}

// ---- The run --------------------------------------------------------------------------------------------------------

namespace {

std::string micrometre(double metre, int digits = 4) { return plain(1e6 * metre, digits) + " um"; }
std::string millimetre(double metre, int digits = 4) { return plain(1e3 * metre, digits) + " mm"; }

/// A law could not be carried through; the sentence says where.
class LawFailure : public std::runtime_error {
 public:
  explicit LawFailure(const std::string& why) : std::runtime_error(why) {}
  explicit LawFailure(const SolveFailure& contact) : std::runtime_error(contact.why), limit_(contact.limit) {}
  /// A contact that the law needs ended on iterations or time.
  [[nodiscard]] bool limit() const { return limit_; }

 private:
  bool limit_ = false;
};

class BearingRun {
 public:
  BearingRun(const Case& bearing_case, const BearingRequest& request, ContactMemory& memory)
      : case_(bearing_case),
        body_(std::get<BearingCase>(bearing_case.body)),
        request_(request),
        memory_(memory),
        geometry_(geometry_of(body_)),
        contacts_(contacts_of(body_)),
        loading_{body_.operation.radial_load_N, bearing::centrifugal_force_N(geometry_, speeds_of(body_))} {}

  [[nodiscard]] std::vector<BearingResult> run() {
    std::vector<BearingResult> results;
    for (const BearingLaw law : request_.laws) {
      const Plan plan = plan_bearing(body_, {law}, request_.form, request_.cage_positions);
      if (plan.runs(bearing_stage::balance(law))) results.push_back(run_law(law, plan));
    }
    return results;
  }

 private:
  [[nodiscard]] BearingResult run_law(BearingLaw law, const Plan& plan) {
    const auto begin = std::chrono::steady_clock::now();
    const long solves = memory_.solves(), recalls = memory_.recalls();
    BearingResult result;
    result.case_id = case_.id;
    result.version = case_.version;
    result.law = law;
    result.form = request_.form;
    result.plan = plan;
    try {
      if (!needs_film(law)) {
        fill(result, all_positions(dry_laws(law, roller_contact_of(body_))));
      } else {
        if (plan.runs(bearing_stage::dry)) dry_ = balanced(dry_laws(BearingLaw::hertz, roller_contact_of(body_)));
        result.datum_m = {datum_m(contacts_.inner), datum_m(contacts_.outer)};
        note_datum(result);
        if (law == BearingLaw::ehd_linear) run_linear(result);
        if (law == BearingLaw::ehd) run_curve(result);
      }
      result.status = StopReason::converged;
      fill_lambda_ratios(result);
      note_what_to_know(result);
      judge_contacts(result);
    } catch (const LawFailure& failure) {
      result.status = failure.limit() ? StopReason::limit_reached : StopReason::diverged;
      result.why = failure.what();
      result.rollers.clear();
    }
    result.contact_solves = memory_.solves() - solves;
    result.contact_recalls = memory_.recalls() - recalls;
    result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
  }

  /// A balance is no better than the contacts that its law and films are made of; what else the memory holds is another's.
  static void judge_contacts(BearingResult& result) {
    const auto missed_N = [&result](auto at_raceway) {
      std::set<double> missed;
      if (result.curve) missed.insert(at_raceway(*result.curve).missed_N.begin(), at_raceway(*result.curve).missed_N.end());
      if (result.fit)
        for (const bearing::FitPoint& point : at_raceway(*result.fit).points)
          if (!point.converged) missed.insert(point.force_N);
      return missed.size();
    };
    const std::size_t unconverged = missed_N([](const auto& both) -> const auto& { return both.inner; }) +
                                    missed_N([](const auto& both) -> const auto& { return both.outer; });
    if (unconverged == 0) return;
    result.status = StopReason::tolerance_not_met;
    result.why = std::to_string(unconverged) + " of the raceways' solved contacts have an estimated film error above 1e-3";
    result.notes.push_back(result.why);
  }

  [[nodiscard]] Equilibrium balanced(const LawPair& laws) const { return balanced(laws, geometry_); }
  [[nodiscard]] Equilibrium balanced(const LawPair& laws, const bearing::Geometry& geometry) const {
    auto result = bearing::balance(geometry, laws, loading_, request_.form);
    if (const auto* failure = std::get_if<bearing::NoEquilibrium>(&result)) throw LawFailure(failure->why);
    return std::get<Equilibrium>(std::move(result));
  }

  /// The balance of the case, and after it those of the cage's further positions.
  [[nodiscard]] std::vector<Equilibrium> all_positions(const LawPair& laws) const {
    std::vector<Equilibrium> positions;
    const int count = std::max(1, request_.cage_positions);
    for (int k = 0; k < count; ++k) {
      bearing::Geometry turned = geometry_;
      turned.first_azimuth_deg += 360.0 / geometry_.rollers * k / count;
      positions.push_back(balanced(laws, turned));
    }
    return positions;
  }

  [[nodiscard]] double largest_dry_N() const {
    double largest = 0;
    for (const bearing::RollerState& roller : dry_.rollers) largest = std::max(largest, roller.inner.force_N);
    return largest;
  }

  /// x_0 at one raceway.
  [[nodiscard]] double datum_m(const RacewayContact& contact) const {
    if (const auto* given = std::get_if<LengthDatum>(&body_.datum)) return given->x0_m;
    if (std::holds_alternative<LundbergDatum>(body_.datum)) return contact.length_m;
    const double load_N = palmgren_load_N();
    if (!(load_N > 0)) return contact.length_m;  // no contact force at all: a datum is of no consequence
    return datum_from_dry_approach_m(contact.at(load_N), bearing::palmgren_law(contact.length_m).approach(load_N));
  }
  /// Without a radial load the dry rollers press on the outer ring alone.
  [[nodiscard]] double palmgren_load_N() const {
    const double largest_N = largest_dry_N();
    return std::get<PalmgrenDatum>(body_.datum).load_N.value_or(largest_N > 0 ? largest_N : loading_.centrifugal_N);
  }

  void note_datum(BearingResult& result) const {
    std::string name = "datum: ";
    if (std::holds_alternative<PalmgrenDatum>(body_.datum) && !(palmgren_load_N() > 0))
      name += "x_0 = l, since the dry rollers carry nothing that palmgren's law could be met at";
    else if (std::holds_alternative<PalmgrenDatum>(body_.datum))
      name += "palmgren, the hertz law met at a contact force of " + plain(palmgren_load_N()) + " N";
    else if (std::holds_alternative<LundbergDatum>(body_.datum))
      name += "lundberg, x_0 = l";
    else
      name += "x_0 given";
    result.notes.push_back(name + "; x_0 = " + millimetre(result.datum_m->inner) + " (inner), " +
                           millimetre(result.datum_m->outer) + " (outer)");
  }

  void note_lubricant(BearingResult& result, const RacewayContact& contact) const {
    const Conditions conditions = contact.at(loading_.radial_N / geometry_.rollers);
    try {
      for (const std::string& note : nondimensionalise(conditions, body_.lubricant->lubricant, Flooded{}).notes)
        if (note.find("GPa") == std::string::npos) result.notes.push_back(note);  // pressures: of each roller, below
    } catch (const StatementError&) {  // a mean load out of range says nothing about the rollers' own
    }
  }

  [[nodiscard]] SolvedContacts& solved(const RacewayContact& contact) {
    return memory_.of(contact, body_.lubricant->lubricant);
  }

  // -- ehd-linear

  /// `dry_N`: the largest force on this raceway that the dry balance knows.
  [[nodiscard]] LinearFit fitted(BearingResult& result, const RacewayContact& contact, double datum, double dry_N,
                                 const char* name) {
    const double from_N = std::max(dry_N, lightest_fit_M * force_at_M_1_N(contact) / default_fit_from);
    const auto [low, high] = body_.fit.load_N.value_or(std::pair{default_fit_from * from_N, default_fit_to * from_N});
    if (!body_.fit.load_N && from_N > dry_N)
      result.notes.push_back("fit raised to M = " + plain(lightest_fit_M) + " at the " + name + " raceway: from " + plain(low, 4) + " N, where " +
                             plain(default_fit_from) + " times the largest dry force would be " + plain(default_fit_from * dry_N, 3) + " N");
    try {
      auto fit = bearing::fit_contacts(solved(contact), datum, low, high, body_.fit.points);
      if (const auto* failure = std::get_if<SolveFailure>(&fit)) throw LawFailure(*failure);
      return std::get<LinearFit>(std::move(fit));
    } catch (const std::invalid_argument& error) {
      throw LawFailure(error.what());
    }
  }

  void run_linear(BearingResult& result) {
    const double inner_N = largest_dry_N(), outer_N = std::max(inner_N, loading_.centrifugal_N);
    auto inner = fitted(result, contacts_.inner, result.datum_m->inner, inner_N, "inner");
    auto outer = fitted(result, contacts_.outer, result.datum_m->outer, outer_N, "outer");
    result.fit = {std::move(inner), std::move(outer)};
    note_lubricant(result, contacts_.inner);
    const LawPair lines{result.fit->inner.law(), result.fit->outer.law()};
    fill(result, all_positions(lines));
    if (request_.films && result.plan.runs(bearing_stage::film(BearingLaw::ehd_linear))) {
      fill_films_of_fit(result);
      note_fit_range(result, result.fit->inner, &RollerRow::inner, "inner");
      note_fit_range(result, result.fit->outer, &RollerRow::outer, "outer");
      if (result.plan.runs(bearing_stage::variant)) add_cut_variant(result);
    }
  }

  /// Films at the rollers' loads, from the raceway's curve: a line through a fit's few points is no film.
  void fill_films_of_fit(BearingResult& result) {
    double reach_N = result.plan.runs(bearing_stage::dry) ? first_reach_N() : 0;
    for (const RollerRow& row : result.rollers) reach_N = std::max({reach_N, row.inner.force_N, row.outer.force_N});
    try {
      const auto inner = curve_of(contacts_.inner, reach_N), outer = curve_of(contacts_.outer, reach_N);
      fill_films(result, *inner, *outer);
      result.curve = BothRaceways<FilmCurve>{*inner, *outer};
    } catch (const LawFailure& failure) {
      result.notes.push_back("no films: " + std::string(failure.what()));
    }
  }

  static void fill_films(BearingResult& result, const FilmCurve& inner, const FilmCurve& outer) {
    for (RollerRow& row : result.rollers) {
      if (row.inner.force_N > 0) row.inner.film_minimum_m = inner.minimum_film(row.inner.force_N).value;
      if (row.outer.force_N > 0) row.outer.film_minimum_m = outer.minimum_film(row.outer.force_N).value;
    }
  }

  static void note_fit_range(BearingResult& result, const LinearFit& fit, ContactRow RollerRow::*raceway,
                             const char* name) {
    const double low = fit.points.front().force_N, high = fit.points.back().force_N;
    int outside = 0;
    double lowest = std::numeric_limits<double>::infinity(), highest = 0;
    for (const RollerRow& row : result.rollers) {
      const double f = (row.*raceway).force_N;
      if (!(f > 0) || (f >= low && f <= high)) continue;
      ++outside;
      lowest = std::min(lowest, f);
      highest = std::max(highest, f);
    }
    if (outside > 0)
      result.notes.push_back("fit used outside its range: " + std::to_string(outside) + " " + name +
                             " contacts carry " + plain(lowest, 4) + " to " + plain(highest, 4) + " N, fitted from " +
                             plain(low) + " to " + plain(high) + " N");
  }

  void add_cut_variant(BearingResult& result) {
    const LawPair cut{result.fit->inner.law(Unloading::at_zero_approach),
                      result.fit->outer.law(Unloading::at_zero_approach)};
    auto found = bearing::balance(geometry_, cut, loading_, request_.form);
    bool radial = false;
    if (std::holds_alternative<bearing::NoEquilibrium>(found) && request_.form == bearing::Form::plane) {
      found = bearing::balance(geometry_, cut, loading_, bearing::Form::radial);
      radial = true;
    }
    if (const auto* failure = std::get_if<bearing::NoEquilibrium>(&found)) {
      result.notes.push_back("variant " + std::string(bearing_stage::variant) + ": no balance, " + failure->why);
      return;
    }
    const auto& ring = std::get<Equilibrium>(found);
    VariantResult variant{.name = "cut at delta = 0",
                          .displacement_m = ring.displacement_m,
                          .displacement_lateral_m = ring.lateral_displacement_m,
                          .balance_error = ring.balance_error,
                          .rollers = rows_of(ring)};
    int loaded = 0, loaded_cut = 0;
    bool shared = false;
    for (std::size_t j = 0; j < ring.rollers.size(); ++j) {
      loaded += result.rollers[j].inner.force_N > 0;
      loaded_cut += ring.rollers[j].inner.force_N > 0;
      shared = shared || ring.rollers[j].at_jump;
    }
    result.notes.push_back("variant " + variant.name + ": " + std::to_string(loaded_cut) +
                           " loaded rollers instead of " + std::to_string(loaded) + ", roller 1 carries " +
                           plain(variant.rollers[0].inner.force_N) + " N instead of " +
                           plain(result.rollers[0].inner.force_N) + " N" +
                           (shared ? "; the outermost sit on the jump of the law at delta = 0" : "") +
                           (radial ? "; balanced in the radial form, since in the plane rollers stand on that jump" : ""));
    result.variants.push_back(std::move(variant));
  }

  // -- ehd

  void run_curve(BearingResult& result) {
    double reach_N = first_reach_N();
    constexpr int extensions = 8;
    for (int extension = 0; extension < extensions; ++extension) {
      const auto inner = curve_of(contacts_.inner, reach_N), outer = curve_of(contacts_.outer, reach_N);
      const auto positions =
          all_positions({law_of(inner, result.datum_m->inner), law_of(outer, result.datum_m->outer)});
      double largest = 0;
      for (const Equilibrium& ring : positions)
        for (const bearing::RollerState& roller : ring.rollers)
          largest = std::max({largest, roller.inner.force_N, roller.outer.force_N});
      if (largest > std::min(inner->heaviest_N(), outer->heaviest_N())) {
        reach_N = 1.1 * std::max(largest, reach_N);
        continue;
      }
      fill(result, positions);
      fill_films(result, *inner, *outer);
      result.curve = BothRaceways<FilmCurve>{*inner, *outer};
      note_curve(result, *inner, &RollerRow::inner, "inner");
      note_curve(result, *outer, &RollerRow::outer, "outer");
      note_lubricant(result, contacts_.inner);
      return;
    }
    throw LawFailure("the roller loads grow beyond every solved contact; the datum or the load is out of reach");
  }

  /// M = f/(l sqrt(eta_0 u_s E' R)).
  [[nodiscard]] static double force_at_M_1_N(const RacewayContact& contact) {
    const double width = contact.reduced_modulus_Pa * contact.reduced_radius_m;
    return contact.length_m * std::sqrt(contact.viscosity_Pa_s * contact.speed_sum_m_per_s * width);
  }

  /// Where a first curve ends; a balance that goes beyond extends it.
  [[nodiscard]] double first_reach_N() const {
    // Where every roller is light the curve still begins at M = 1: what is lighter is foretold from solved contacts, and
    // below M = 1e-3 none can be solved.
    return std::max({1.05 * (largest_dry_N() + loading_.centrifugal_N), force_at_M_1_N(contacts_.inner), force_at_M_1_N(contacts_.outer)});
  }

  /// The contacts of the fit, where the case itself states them: the curve then shares them. With a range that follows
  /// the dry balance every load and clearance would have a curve of its own.
  [[nodiscard]] std::vector<double> stated_fit_N() const {
    if (!body_.fit.load_N) return {};
    return bearing::fit_forces_N(body_.fit.load_N->first, body_.fit.load_N->second, body_.fit.points);
  }

  [[nodiscard]] std::shared_ptr<const FilmCurve> curve_of(const RacewayContact& contact, double heaviest_N) {
    const auto& curve =
        memory_.curve(contact, body_.lubricant->lubricant, {.heaviest_N = heaviest_N, .given_N = stated_fit_N()});
    if (const auto* failure = std::get_if<SolveFailure>(&curve)) throw LawFailure(*failure);
    return std::make_shared<const FilmCurve>(std::get<FilmCurve>(curve));
  }

  [[nodiscard]] static CurveLaw law_of(const std::shared_ptr<const FilmCurve>& curve, double datum) {
    try {
      return {curve, datum};
    } catch (const std::domain_error& error) {
      throw LawFailure(error.what());
    }
  }

  static void note_curve(BearingResult& result, const FilmCurve& curve, ContactRow RollerRow::*raceway,
                         const char* name) {
    int below = 0;
    for (const RollerRow& row : result.rollers) below += (row.*raceway).force_N < curve.lightest_N();
    result.notes.push_back(std::string(name) + " curve: " + std::to_string(curve.forces_N().size()) +
                           " solved contacts from " + plain(curve.lightest_N(), 4) + " to " +
                           plain(curve.heaviest_N(), 4) + " N, relative errors of film and force: interpolation " +
                           plain(curve.interpolation_error, 2) + ", " + plain(curve.interpolation_force_error, 2) +
                           "; rigid limit below " + plain(curve.joint_error, 2) + ", " +
                           plain(curve.joint_force_error, 2) + "; solver's own " + plain(curve.solver_error, 2) + " (" +
                           curve.lightest_because + "); " + std::to_string(below) + " contacts lie below it");
  }

  // -- all laws

  [[nodiscard]] std::vector<RollerRow> rows_of(const Equilibrium& ring) const {
    std::vector<RollerRow> rows;
    for (std::size_t j = 0; j < ring.rollers.size(); ++j) {
      const auto row = [](const bearing::ContactState& state, const RacewayContact& contact) {
        ContactRow at{.force_N = state.force_N, .displacement_m = state.approach_m};
        if (state.force_N > 0) at.hertz_pressure_Pa = hertz::pressure_Pa(contact.at(state.force_N));
        return at;
      };
      rows.push_back({ring.azimuths_deg[j], row(ring.rollers[j].inner, contacts_.inner),
                      row(ring.rollers[j].outer, contacts_.outer)});
    }
    return rows;
  }

  void fill(BearingResult& result, const std::vector<Equilibrium>& positions) const {
    const Equilibrium& ring = positions.front();
    result.displacement_m = ring.displacement_m;
    result.displacement_lateral_m = ring.lateral_displacement_m;
    result.load_zone_deg = bearing::load_zone_deg(ring, result.law == BearingLaw::ehd ? bearing::load_zone_share : 0);
    result.stiffness_N_per_m = ring.stiffness_N_per_m;
    result.balance_error = ring.balance_error;
    result.rollers = rows_of(ring);
    result.roller_groups = ring.groups;
    result.rollers_balanced = ring.rollers_balanced;
    result.newton_iterations = ring.newton_iterations;
    if (request_.cage_positions > 0) result.cage = turn_of(positions);
    const double lateral = std::abs(ring.lateral_force_N);
    if (request_.form == bearing::Form::radial && lateral > 1e-9 * loading_.radial_N)
      result.notes.push_back(
          "radial form: the cage position is not symmetric to the load, and the ring, which moves along the load only, "
          "needs a lateral force of " +
          plain(ring.lateral_force_N, 4) + " N");
  }

  [[nodiscard]] static CageTurn turn_of(const std::vector<Equilibrium>& positions) {
    CageTurn turn{.positions = static_cast<int>(positions.size()), .displacement_m = {}, .displacement_lateral_m = {}};
    const auto range_of = [&positions](double Equilibrium::*displacement) {
      double lowest = positions.front().*displacement, highest = lowest, sum = 0;
      for (const Equilibrium& ring : positions) {
        lowest = std::min(lowest, ring.*displacement);
        highest = std::max(highest, ring.*displacement);
        sum += ring.*displacement;
      }
      return CageTurn::Range{sum / static_cast<double>(positions.size()), highest - lowest};
    };
    turn.displacement_m = range_of(&Equilibrium::displacement_m);
    turn.displacement_lateral_m = range_of(&Equilibrium::lateral_displacement_m);
    for (const Equilibrium& ring : positions)
      for (const bearing::RollerState& roller : ring.rollers)
        turn.largest_force_N = std::max(turn.largest_force_N, roller.inner.force_N);
    return turn;
  }

  void fill_lambda_ratios(BearingResult& result) const {
    if (!result.plan.runs(bearing_stage::lambda)) return;
    for (RollerRow& row : result.rollers)
      for (ContactRow* at : {&row.inner, &row.outer})
        if (at->film_minimum_m) at->lambda_ratio = *at->film_minimum_m / *body_.geometry.roughness_m;
  }

  void note_what_to_know(BearingResult& result) const {
    double highest_Pa = 0, smallest_ratio = std::numeric_limits<double>::infinity();
    for (const RollerRow& row : result.rollers)
      for (const ContactRow* at : {&row.inner, &row.outer}) {
        highest_Pa = std::max(highest_Pa, at->hertz_pressure_Pa.value_or(0));
        smallest_ratio = std::min(smallest_ratio, at->lambda_ratio.value_or(smallest_ratio));
      }
    if (highest_Pa > steel_limit_Pa)
      result.notes.push_back("p_H = " + plain(1e-9 * highest_Pa, 4) +
                             " GPa is above 4 GPa: a numerical test, physically not steel");
    if (smallest_ratio < 1)
      result.notes.push_back("lambda ratio " + plain(smallest_ratio, 3) +
                             " is below 1: the film is thinner than the roughness, which smooth surfaces do not see");
  }

  const Case& case_;
  const BearingCase& body_;
  const BearingRequest& request_;
  ContactMemory& memory_;
  bearing::Geometry geometry_;
  BothRaceways<RacewayContact> contacts_;
  bearing::Loading loading_;
  Equilibrium dry_;
};

}  // namespace

void require_possible(const Case& bearing_case, const BearingRequest& request) {
  const auto& body = std::get<BearingCase>(bearing_case.body);
  for (const BearingLaw law : request.laws) {
    if (needs_ring_thickness(law) && !body.geometry.ring_thickness_m)
      throw case_error(bearing_case, "bearing.ring_thickness_m",
                       "is missing; law " + std::string(to_string(law)) +
                           " needs it at the outer raceway (allowed without: hertz, iso, lundberg)");
    if (!needs_film(law)) continue;
    if (!body.lubricant && request.explicitly)
      throw case_error(bearing_case, "lubricant",
                       "is missing; law " + std::string(to_string(law)) + " needs it (allowed without: the dry laws, hertz, iso, lundberg, tripp, houpert)");
    if (!body.lubricant || !at_rest(body)) continue;
    const std::string both = "operation.inner_speed_rpm", one = "operation.speed_rpm";
    throw case_error(bearing_case, bearing_case.lines.contains(both) ? both : one,
                     "leaves the rings at rest against each other, where law " + std::string(to_string(law)) +
                         " does not exist; allowed is a relative speed, or a dry law (--law hertz, iso, lundberg, tripp, houpert)");
  }
}

std::vector<BearingResult> run_bearing(const Case& bearing_case, const BearingRequest& request, ContactMemory& memory) {
  require_possible(bearing_case, request);
  return BearingRun(bearing_case, request, memory).run();
}

std::optional<LawPair> laws_of(const BearingCase& body, const BearingResult& result) {
  if (!needs_film(result.law)) return dry_laws(result.law, roller_contact_of(body));
  if (result.law == BearingLaw::ehd_linear) {
    if (!result.fit) return std::nullopt;
    return LawPair{result.fit->inner.law(), result.fit->outer.law()};
  }
  if (!result.curve || !result.datum_m) return std::nullopt;
  return LawPair{CurveLaw(std::make_shared<const FilmCurve>(result.curve->inner), result.datum_m->inner),
                 CurveLaw(std::make_shared<const FilmCurve>(result.curve->outer), result.datum_m->outer)};
}

std::optional<double> measure(const std::vector<BearingResult>& results, const Expectation& expectation) {
  for (const BearingResult& result : results) {
    if (to_string(result.law) != expectation.law || result.rollers.empty()) continue;
    const std::string& quantity = expectation.quantity;
    if (quantity == "displacement") return result.displacement_m;
    const std::string prefix = "roller.";
    if (!quantity.starts_with(prefix)) return std::nullopt;
    std::size_t number = 0, digits = 0;
    try {
      number = std::stoul(quantity.substr(prefix.size()), &digits);
    } catch (const std::exception&) {
      return std::nullopt;
    }
    if (number < 1 || number > result.rollers.size()) return std::nullopt;
    const RollerRow& row = result.rollers[number - 1];
    const std::string rest = quantity.substr(prefix.size() + digits);
    if (rest == ".inner.force") return row.inner.force_N;
    if (rest == ".outer.force") return row.outer.force_N;
    if (rest == ".inner.displacement") return row.inner.displacement_m;
    if (rest == ".outer.displacement") return row.outer.displacement_m;
    if (rest == ".inner.film.minimum") return row.inner.film_minimum_m;
    if (rest == ".outer.film.minimum") return row.outer.film_minimum_m;
    return std::nullopt;
  }
  return std::nullopt;
}

// ---- Written
// ---------------------------------------------------------------------------------------------------------

namespace {

Json to_json(const ContactRow& row) {
  Json json = Json::object();
  put(json, "force_N", row.force_N);
  put(json, "displacement_m", row.displacement_m);
  put(json, "film_minimum_m", row.film_minimum_m);
  put(json, "hertz_pressure_Pa", row.hertz_pressure_Pa);
  put(json, "lambda_ratio", row.lambda_ratio);
  return json;
}

Json to_json(const std::vector<RollerRow>& rows) {
  Json json = Json::array();
  for (const RollerRow& row : rows) {
    Json roller = Json::object();
    put(roller, "azimuth_deg", row.azimuth_deg);
    roller["inner"] = to_json(row.inner);
    roller["outer"] = to_json(row.outer);
    json.push_back(std::move(roller));
  }
  return json;
}

Json to_json(const CageTurn& turn) {
  const auto range = [](const CageTurn::Range& one) {
    Json json = Json::object();
    put(json, "mean", one.mean);
    put(json, "peak_to_peak", one.peak_to_peak);
    return json;
  };
  Json json = Json::object();
  json["positions"] = turn.positions;
  json["displacement_m"] = range(turn.displacement_m);
  json["displacement_lateral_m"] = range(turn.displacement_lateral_m);
  put(json, "largest_force_N", turn.largest_force_N);
  return json;
}

Json to_json(const LinearFit& fit) {
  Json json = Json::object();
  put(json, "K_N_per_m", fit.K_N_per_m);
  put(json, "dF_N", fit.dF_N);
  put(json, "residual_N", fit.residual_N);
  put(json, "standard_deviation_N", fit.standard_deviation_N);
  put(json, "K_standard_deviation_N_per_m", fit.K_deviation_N_per_m);
  put(json, "dF_standard_deviation_N", fit.dF_deviation_N);
  put(json, "correlation", fit.correlation);
  json["load_N"] = {fit.points.front().force_N, fit.points.back().force_N};
  json["points"] = fit.points.size();
  return json;
}

Json to_json(const FilmCurve& curve) {
  Json json = Json::object();
  json["points"] = curve.forces_N().size();
  json["load_N"] = {curve.lightest_N(), curve.heaviest_N()};
  put(json, "interpolation_error", curve.interpolation_error);
  put(json, "joint_error", curve.joint_error);
  put(json, "force_error", std::max(curve.interpolation_force_error, curve.joint_force_error));
  put(json, "solver_error", curve.solver_error);
  json["lightest_because"] = curve.lightest_because;
  return json;
}

}  // namespace

Json to_json(const BearingResult& result) {
  Json json = Json::object();
  json["case"] = result.case_id;
  json["version"] = result.version;
  json["law"] = to_string(result.law);
  json["status"] = to_string(result.status);
  if (!result.rollers.empty()) {
    put(json, "displacement_m", result.displacement_m);
    put(json, "displacement_lateral_m", result.displacement_lateral_m);
    if (result.load_zone_deg) json["load_zone_deg"] = {result.load_zone_deg->first, result.load_zone_deg->second};
    json["stiffness_N_per_m"] = result.stiffness_N_per_m;
    if (result.cage) json["cage"] = to_json(*result.cage);
    json["rollers"] = to_json(result.rollers);
    put(json, "balance_error", result.balance_error);
  } else {
    json["why"] = result.why;
  }
  if (result.fit) json["fit"] = {{"inner", to_json(result.fit->inner)}, {"outer", to_json(result.fit->outer)}};
  if (result.curve) json["curve"] = {{"inner", to_json(result.curve->inner)}, {"outer", to_json(result.curve->outer)}};
  if (result.datum_m) json["datum"] = {{"inner_x0_m", result.datum_m->inner}, {"outer_x0_m", result.datum_m->outer}};
  for (const VariantResult& variant : result.variants) {
    Json one = Json::object();
    one["name"] = variant.name;
    put(one, "displacement_m", variant.displacement_m);
    put(one, "displacement_lateral_m", variant.displacement_lateral_m);
    one["rollers"] = to_json(variant.rollers);
    put(one, "balance_error", variant.balance_error);
    json["variants"].push_back(std::move(one));
  }
  json["cost"] = {{"wall_s", result.wall_s},
                  {"contact_solves", result.contact_solves},
                  {"contacts_from_memory", result.contact_recalls},
                  {"newton_iterations", result.newton_iterations},
                  {"rollers_balanced", result.rollers_balanced}};
  json["plan"] = to_json(result.plan);
  json["notes"] = result.notes;
  return json;
}

namespace {

/// The rollers that a table shows: one of each mirrored pair, with the text of its azimuth.
std::vector<std::pair<std::size_t, std::string>> shown_rollers(const std::vector<RollerRow>& rollers) {
  std::vector<double> azimuths;
  for (const RollerRow& roller : rollers) azimuths.push_back(roller.azimuth_deg);
  std::vector<std::pair<std::size_t, std::string>> shown;
  for (const bearing::RollerGroup& group : bearing::mirror_groups(azimuths)) {
    const auto first = static_cast<std::size_t>(group.members.front());
    shown.emplace_back(first, (group.members.size() > 1 ? "+-" : "") +
                                  plain(group.members.size() > 1 ? std::abs(azimuths[first]) : azimuths[first], 5));
  }
  std::sort(shown.begin(), shown.end(), [&](const auto& one, const auto& other) {
    return std::abs(azimuths[one.first]) < std::abs(azimuths[other.first]);
  });
  return shown;
}

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

/// What the ring does, a line a law; and over the cage's positions, where they were asked for.
std::string human_ring(const std::vector<BearingResult>& results) {
  std::vector<std::vector<std::string>> ring{
      {"ring", "lateral um", "load zone deg", "to", "stiffness N/um: xx", "yy", "xy"}};
  std::vector<std::vector<std::string>> turn{
      {"cage turning", "positions", "displacement um: mean", "peak to peak", "lateral um: mean", "peak to peak", "largest Q_i N"}};
  for (const BearingResult& result : results) {
    if (result.rollers.empty()) continue;
    const std::string law(to_string(result.law));
    const auto& K = result.stiffness_N_per_m;
    const auto& zone = result.load_zone_deg;
    ring.push_back({law, fixed(1e6 * result.displacement_lateral_m, 4), zone ? plain(zone->first, 5) : "-",
                    zone ? plain(zone->second, 5) : "-", plain(1e-6 * K[0][0], 5), plain(1e-6 * K[1][1], 5),
                    std::abs(K[0][1]) <= 1e-12 * K[0][0] ? "0" : plain(1e-6 * K[0][1], 5)});
    if (!result.cage) continue;
    const auto& along = result.cage->displacement_m;
    const auto& across = result.cage->displacement_lateral_m;
    turn.push_back({law, std::to_string(result.cage->positions), fixed(1e6 * along.mean, 4), plain(1e6 * along.peak_to_peak, 3),
                    fixed(1e6 * across.mean, 4), plain(1e6 * across.peak_to_peak, 3), fixed(result.cage->largest_force_N, 1)});
  }
  std::string text;
  if (ring.size() > 1) text += "\n" + aligned(ring, 1, "  ");
  if (turn.size() > 1) text += "\n" + aligned(turn, 1, "  ");
  return text;
}

}  // namespace

std::string human_table(const Case& bearing_case, const std::vector<BearingResult>& results) {
  const auto& body = std::get<BearingCase>(bearing_case.body);
  std::string text = bearing_case.id + ": " + bearing_case.title + "\n";
  text += "  radial load " + plain(body.operation.radial_load_N) + " N, clearance " +
          micrometre(body.geometry.clearance_m) + ", sum speed " +
          plain(bearing::sum_speed_m_per_s(geometry_of(body), speeds_of(body)), 4) + " m/s, centrifugal force " +
          plain(bearing::centrifugal_force_N(geometry_of(body), speeds_of(body)), 4) + " N a roller\n\n";

  // Rollers: psi, then Q_i, delta_i and film of every law.
  std::vector<std::string> head{"psi"}, units{"deg"};
  std::vector<const BearingResult*> with_rows;
  for (const BearingResult& result : results) {
    if (result.rollers.empty()) continue;
    with_rows.push_back(&result);
    head.insert(head.end(), {std::string(to_string(result.law)) + ": Q_i", "delta_i"});
    units.insert(units.end(), {"N", "um"});
    if (needs_film(result.law)) {
      head.emplace_back("h_i");
      units.emplace_back("um");
    }
  }
  if (!with_rows.empty()) {
    std::vector<std::vector<std::string>> rows{head, units};
    for (const auto& [j, azimuth] : shown_rollers(with_rows.front()->rollers)) {
      std::vector<std::string> row{azimuth};
      for (const BearingResult* result : with_rows) {
        const ContactRow& inner = result->rollers[j].inner;
        row.push_back(fixed(inner.force_N, 1));
        row.push_back(fixed(1e6 * inner.displacement_m, 3));
        if (needs_film(result->law)) row.push_back(inner.film_minimum_m ? fixed(1e6 * *inner.film_minimum_m, 3) : "-");
      }
      rows.push_back(row);
    }
    text += aligned(rows, 1, "  ") + "\n";
  }

  std::vector<std::vector<std::string>> summary{
      {"law", "displacement um", "balance error", "contacts solved", "from memory", "time s"}};
  for (const BearingResult& result : results) {
    const bool fine = !result.rollers.empty();
    summary.push_back({std::string(to_string(result.law)), fine ? fixed(1e6 * result.displacement_m, 4) : "-",
                       fine ? plain(result.balance_error, 2) : "-", std::to_string(result.contact_solves),
                       std::to_string(result.contact_recalls), plain(result.wall_s, 2)});
  }
  text += aligned(summary, 1, "  ");

  text += human_ring(results);

  for (const BearingResult& result : results) {
    if (!result.fit) continue;
    std::vector<std::vector<std::string>> fits{
        {"fit", "K N/m", "dF N", "residual N", "standard deviation N", "of K N/m", "of dF N", "N from", "to"}};
    const auto add = [&fits](const char* name, const LinearFit& fit) {
      fits.push_back({name, plain(fit.K_N_per_m, 5), fixed(fit.dF_N, 1), fixed(fit.residual_N, 1),
                      fixed(fit.standard_deviation_N, 1), plain(fit.K_deviation_N_per_m, 2),
                      fixed(fit.dF_deviation_N, 1), plain(fit.points.front().force_N, 5),
                      plain(fit.points.back().force_N, 5)});
    };
    add("inner", result.fit->inner);
    add("outer", result.fit->outer);
    text += "\n" + aligned(fits, 1, "  ");
  }
  for (const BearingResult& result : results) {
    if (!result.why.empty()) text += "\n  " + std::string(to_string(result.law)) + ": no balance: " + result.why + "\n";
    if (result.notes.empty()) continue;
    text += "\n  notes on " + std::string(to_string(result.law)) + "\n";
    for (const std::string& note : result.notes) text += "    - " + note + "\n";
  }
  return text;
}

}  // namespace ehd::verification
