// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "contact/approach.hpp"
#include "contact/hertz.hpp"
#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "workflow/bearing_of_case.hpp"

namespace ehd {

using bearing::BothRaceways;
using bearing::CurveLaw;
using bearing::Equilibrium;
using bearing::FilmCurve;
using bearing::LawPair;
using bearing::LinearFit;
using bearing::RacewayContact;
using bearing::SolvedContact;
using bearing::SolvableContact;
using bearing::SolveFailure;
using bearing::Unloading;

std::vector<bearing::Law> default_laws(const BearingCase& body) {
  return bearing::laws_of(body.lubricant ? bearing::Laws::by_default : bearing::Laws::by_default_dry);
}

// ---- The run --------------------------------------------------------------------------------------------------------

namespace {

constexpr double steel_limit_Pa = 4e9;  // above it a result is a numerical test

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
    for (const bearing::Law law : request_.laws) {
      const Plan plan = plan_bearing(body_, {law}, request_.form, request_.cage_positions);
      if (plan.runs(bearing_stage::balance(law))) results.push_back(run_law(law, plan));
    }
    return results;
  }

 private:
  [[nodiscard]] BearingResult run_law(bearing::Law law, const Plan& plan) {
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
        if (plan.runs(bearing_stage::dry)) dry_ = balanced(dry_laws(bearing::Law::hertz, roller_contact_of(body_)));
        result.datum_m = {datum_m(contacts_.inner), datum_m(contacts_.outer)};
        note_datum(result);
        if (law == bearing::Law::ehd_linear) run_linear(result);
        if (law == bearing::Law::ehd) run_curve(result);
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

  /// A balance is no better than the contacts that its law and films are made of; what else the memory holds is
  /// another's.
  static void judge_contacts(BearingResult& result) {
    const auto missed_N = [&result](auto at_raceway) {
      std::set<double> missed;
      if (result.curve) {
        const std::vector<double>& of_curve = at_raceway(*result.curve).errors().missed_N;
        missed.insert(of_curve.begin(), of_curve.end());
      }
      if (result.fit)
        for (const bearing::FitPoint& point : at_raceway(*result.fit).points)
          if (!point.converged) missed.insert(point.force_N);
      return missed.size();
    };
    const std::size_t unconverged = missed_N([](const auto& both) -> const auto& { return both.inner; }) +
                                    missed_N([](const auto& both) -> const auto& { return both.outer; });
    if (unconverged == 0) return;
    result.status = StopReason::tolerance_not_met;
    result.why =
        std::to_string(unconverged) + " of the raceways' solved contacts have an estimated film error above 1e-3";
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

  [[nodiscard]] SolvableContact solved(const RacewayContact& contact) {
    return memory_.of(contact, body_.lubricant->lubricant);
  }

  // -- ehd-linear

  /// `dry_N`: the largest force on this raceway that the dry balance knows.
  [[nodiscard]] LinearFit fitted(BearingResult& result, const RacewayContact& contact, double datum, double dry_N,
                                 const char* name) {
    const double from_N = std::max(dry_N, lightest_fit_M * force_at_M_1_N(contact) / default_fit_from);
    const auto [low, high] = body_.fit.load_N.value_or(std::pair{default_fit_from * from_N, default_fit_to * from_N});
    if (!body_.fit.load_N && from_N > dry_N)
      result.notes.push_back("fit raised to M = " + plain(lightest_fit_M) + " at the " + name + " raceway: from " +
                             plain(low, 4) + " N, where " + plain(default_fit_from) +
                             " times the largest dry force would be " + plain(default_fit_from * dry_N, 3) + " N");
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
    if (request_.films && result.plan.runs(bearing_stage::film(bearing::Law::ehd_linear))) {
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
    result.notes.push_back(
        "variant " + variant.name + ": " + std::to_string(loaded_cut) + " loaded rollers instead of " +
        std::to_string(loaded) + ", roller 1 carries " + plain(variant.rollers[0].inner.force_N) + " N instead of " +
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
    // Where every roller is light the curve still begins at M = 1: what is lighter is foretold from solved contacts,
    // and below M = 1e-3 none can be solved.
    return std::max({1.05 * (largest_dry_N() + loading_.centrifugal_N), force_at_M_1_N(contacts_.inner),
                     force_at_M_1_N(contacts_.outer)});
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
    result.notes.push_back(
        std::string(name) + " curve: " + std::to_string(curve.forces_N().size()) + " solved contacts from " +
        plain(curve.lightest_N(), 4) + " to " + plain(curve.heaviest_N(), 4) +
        " N, relative errors of film and force: interpolation " + plain(curve.errors().interpolation, 2) + ", " +
        plain(curve.errors().interpolation_force, 2) + "; rigid limit below " + plain(curve.errors().joint, 2) + ", " +
        plain(curve.errors().joint_force, 2) + "; solver's own " + plain(curve.errors().solver_offset_film, 2) + " (" +
        curve.errors().lightest_because + "); " + std::to_string(below) + " contacts lie below it");
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
    result.load_zone_deg = bearing::load_zone_deg(ring, result.law == bearing::Law::ehd ? bearing::load_zone_share : 0);
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
  for (const bearing::Law law : request.laws) {
    if (needs_ring_thickness(law) && !body.geometry.ring_thickness_m)
      throw case_error(bearing_case, "bearing.ring_thickness_m",
                       "is missing; law " + std::string(to_string(law)) +
                           " needs it at the outer raceway (allowed without: " +
                           bearing::names_of(bearing::Laws::dry_without_ring_thickness) + ")");
    if (!needs_film(law)) continue;
    if (!body.lubricant && request.explicitly)
      throw case_error(bearing_case, "lubricant",
                       "is missing; law " + std::string(to_string(law)) + " needs it (allowed without: the dry laws, " +
                           bearing::names_of(bearing::Laws::dry) + ")");
    if (!body.lubricant || !at_rest(body)) continue;
    const std::string both = "operation.inner_speed_rpm", one = "operation.speed_rpm";
    throw case_error(bearing_case, bearing_case.lines.contains(both) ? both : one,
                     "leaves the rings at rest against each other, where law " + std::string(to_string(law)) +
                         " does not exist; allowed is a relative speed, or a dry law (--law " +
                         bearing::names_of(bearing::Laws::dry) + ")");
  }
}

std::vector<BearingResult> run_bearing(const Case& bearing_case, const BearingRequest& request, ContactMemory& memory) {
  require_possible(bearing_case, request);
  return BearingRun(bearing_case, request, memory).run();
}

std::optional<LawPair> laws_of(const BearingCase& body, const BearingResult& result) {
  if (!needs_film(result.law)) return dry_laws(result.law, roller_contact_of(body));
  if (result.law == bearing::Law::ehd_linear) {
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

}  // namespace ehd
